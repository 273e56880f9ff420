"""What kind of OSM file a name tells, in whatever case it is written."""

from __future__ import annotations

from pathlib import Path
from typing import Any

__all__ = ["osm_file"]


def osm_file(path: Path) -> Any:
    """Return a file as libosmium opens it; libosmium itself knows suffixes in lower case only.

    Parameters
    ----------
    path : Path
        An OSM file, such as MAP.OSM.PBF.

    Returns
    -------
    osmium.io.File or str
        To be given to a reader of libosmium.
    """
    import osmium

    kind = "".join(path.suffixes[-2:])
    if kind == kind.lower():
        return str(path)
    return osmium.io.File(str(path), kind.lower().removeprefix("."))
