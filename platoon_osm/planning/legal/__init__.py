"""Searches for plans within the law on driving times."""
