"""Networks from OpenStreetMap files."""
