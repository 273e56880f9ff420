"""How fast a truck and a light vehicle may drive, as the tags of a road and the law say."""
