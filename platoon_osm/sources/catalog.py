"""The maps that come with the package."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import MapDataError

__all__ = ["BUNDLED_MAPS", "BundledMap", "bundled_path"]


@dataclass(frozen=True, slots=True)
class BundledMap:
    """A map under maps/.

    Attributes
    ----------
    name : what to give to `load_network`.
    file : its file name.
    country : whose truck limits apply.
    about : one line for `platoon-osm maps`.
    attribution, licence : to be shown with everything made from it.
    """

    name: str
    file: str
    country: str
    about: str
    attribution: str
    licence: str


BUNDLED_MAPS = (
    BundledMap(
        name="italy-motorways",
        file="italy-motorways.osm",
        country="IT",
        about="long-distance motorways of Italy, a hand-compiled schematic at junction resolution",
        attribution="map: platoon_osm, compiled by hand from public facts",
        licence="MIT",
    ),
)


def bundled_path(name: str) -> tuple[BundledMap, Path] | None:
    """Return a bundled map and its file, or None if no map has that name.

    Raises
    ------
    MapDataError
        The map is known but its file is missing from the installation.
    """
    for bundled in BUNDLED_MAPS:
        if bundled.name == name:
            package = Path(__file__).resolve().parents[1]
            # Beside the code in an installed package, beside the package in a source tree.
            for folder in (package / "maps", package.parent / "maps"):
                if (folder / bundled.file).is_file():
                    return bundled, folder / bundled.file
            raise MapDataError(f"{bundled.file}: missing from the installation; install again")
    return None
