"""Networks from the Overpass API and its cached answers."""
