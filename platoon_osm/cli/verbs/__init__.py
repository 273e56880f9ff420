"""The verbs of `platoon-osm`, one file each; a file's `verb` is the click command.

A file has underscores where its verb has hyphens. What a verb needs for its work is imported when
it works, so that help costs nothing.
"""

__all__ = ["VERBS"]

VERBS = (
    "demo", "maps", "prepare", "download", "scenario", "plan", "check", "certify", "compare",
    "what-if", "fleet", "trips", "study", "bench", "warmup",
)  # fmt: skip
"""In the order in which the help lists them."""
