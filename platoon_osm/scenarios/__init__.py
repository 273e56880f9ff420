"""Scenarios that come with the package, for the demo and as models for one's own."""
