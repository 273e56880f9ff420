"""The saved form of a network: one file, checked before it is trusted."""
