"""Whole pages, and the parts they share."""
