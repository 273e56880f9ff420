"""A day of trips, drawn from truck flows or from the towns of a network."""
