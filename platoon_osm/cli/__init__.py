"""The command `platoon-osm`: one file a verb; the work is done by the package.

A package of your own adds to it by entry points, without touching this one; how stands in
`platoon_osm.cli.plug_ins`.
"""

from .command import main

__all__ = ["main"]
