"""Segments of Overture Maps' transportation theme."""
