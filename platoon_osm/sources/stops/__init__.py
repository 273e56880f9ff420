"""Rest areas, truck parkings, fuel and charging: what the map's tags of them mean."""
