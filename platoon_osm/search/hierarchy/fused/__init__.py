"""Searches that choose while they sweep: members on a route, a stretch for two."""
