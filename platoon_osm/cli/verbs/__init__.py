"""The verbs of `platoon-osm`, one file each; a file's `verb` is the click command.

What a verb needs for its work is imported when it works, so that help costs nothing.
"""

__all__ = ["VERBS"]

VERBS = (
    "demo", "maps", "prepare", "download", "scenario", "plan", "check", "compare", "study",
    "warmup",
)  # fmt: skip
"""In the order in which the help lists them."""
