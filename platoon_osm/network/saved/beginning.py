"""What a saved network begins with, by which it is known whatever its name."""

__all__ = ["FORMAT_VERSION", "MAGIC"]

MAGIC = b"PLTNNET"
FORMAT_VERSION = 3
"""Of the layout in `store`; the byte after the magic."""
