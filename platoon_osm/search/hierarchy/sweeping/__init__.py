"""Downward sweeps from one, two and many sources."""
