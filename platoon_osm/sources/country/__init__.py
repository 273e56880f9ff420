"""Which country a road is in, where the map does not say."""
