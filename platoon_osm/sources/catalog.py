"""Maps that are loaded by name: those that come with the package, and those a user adds.

from platoon_osm.sources.catalog import BUNDLED_MAPS, BundledMap
BUNDLED_MAPS.add(BundledMap("ours", "/data/ours.osm.pbf", "IT", "our own area", "us", "ours"))
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import MapDataError
from ..registry import Registry

__all__ = ["BUNDLED_MAPS", "BundledMap", "bundled_path"]


@dataclass(frozen=True, slots=True)
class BundledMap:
    """A map under maps/, or wherever its path leads.

    Attributes
    ----------
    name : str
        What to give to `load_network`.
    file : str
        Its file name; a user's own map has a whole path.
    country : str
        Whose truck limits apply.
    about : str
        One line for `platoon-osm maps`.
    attribution, licence : str
        To be shown with everything made from it.
    infer_links : bool
        Whether it lacks its ramps, so that likely connectors are always added.
    """

    name: str
    file: str
    country: str
    about: str
    attribution: str
    licence: str
    infer_links: bool = False


BUNDLED_MAPS: Registry[BundledMap] = Registry(
    "map",
    (
        BundledMap(
            name="italy-motorways",
            file="italy-motorways.osm",
            country="IT",
            about=(
                "long-distance motorways of Italy, a hand-compiled schematic at junction resolution"
            ),
            attribution="map: platoon_osm, compiled by hand from public facts",
            licence="MIT",
        ),
        BundledMap(
            name="california-corridor",
            file="california-corridor.osm.pbf",
            country="US-CA",
            about=(
                "motorways of California from San Diego to Redding, cut from OpenStreetMap; ramps "
                "inferred"
            ),
            attribution="© OpenStreetMap contributors",
            licence="ODbL 1.0",
            infer_links=True,
        ),
    ),
)


def bundled_path(name: str) -> tuple[BundledMap, Path] | None:
    """Find a map by its name.

    Parameters
    ----------
    name : str
        Its name, or that of a file, which is none.

    Returns
    -------
    (BundledMap, Path) or None
        The map and its file; None if no map has that name.

    Raises
    ------
    MapDataError
        The map is known but its file is missing.
    """
    bundled = BUNDLED_MAPS.get(name)
    if bundled is None:
        return None
    package = Path(__file__).resolve().parents[1]
    # Beside the code in an installed package, beside the package in a source tree.
    for folder in (package / "maps", package.parent / "maps"):
        if (folder / bundled.file).is_file():
            return bundled, folder / bundled.file
    raise MapDataError(f"{bundled.file}: missing from the installation; install again")
