"""Least costs and paths: two engines behind one protocol, and where vehicles best join a route."""
