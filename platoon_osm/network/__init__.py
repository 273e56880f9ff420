"""The road network as plain arrays, and searching it."""
