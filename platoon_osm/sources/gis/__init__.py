"""Lines of a GIS, with OpenStreetMap's tags in their columns."""
