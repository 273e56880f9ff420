"""Where networks come from: the only rooms that know osmium, OSMnx and Overpass."""
