"""What a saved network begins with, by which it is known whatever its name."""

__all__ = ["FORMAT_VERSION", "MAGIC", "READABLE"]

MAGIC = b"PLTNNET"
FORMAT_VERSION = 4
"""Of the layout in `store`; the byte after the magic."""

READABLE = (3, FORMAT_VERSION)
"""Version 3 lacks some columns, which then have their defaults."""
