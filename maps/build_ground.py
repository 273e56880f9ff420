"""Make the table of coasts and borders that the package brings along.

    npm pack world-atlas@2.0.2
    python maps/build_ground.py world-atlas-2.0.2.tgz           # writes report/ground/ground.npz
    python maps/build_ground.py world-atlas-2.0.2.tgz --check   # writes nothing

The npm package world-atlas holds Natural Earth's countries (public domain) as TopoJSON; it is
needed here only. What is kept of it stands in maps/README.md. The same package always gives the
same table.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import tarfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
# Imported here, for only now is it found, wherever this is run from.

from platoon_osm.network.geodesy import metres_per_degree  # noqa: E402
from platoon_osm.report.ground.table import FILE, GroundTable  # noqa: E402

COUNTRIES = "countries-10m.json"

TOLERANCE_DEG = 0.005
"""How far a line may leave its course, in degrees of latitude: 550 m."""

LEAST_LAND_M2 = 1e6
"""Islands smaller than this are left out."""

Floats = NDArray[np.float64]


def decoded_arcs(topology: Mapping[str, Any]) -> list[Floats]:
    """Return the arcs of a TopoJSON file in degrees; quantised ones are steps between points."""
    arcs = [np.array(arc, np.float64).reshape(-1, 2) for arc in topology["arcs"]]
    if transform := topology.get("transform"):
        scale, zero = np.array(transform["scale"]), np.array(transform["translate"])
        arcs = [np.cumsum(arc, axis=0) * scale + zero for arc in arcs]
    return arcs


def joined(arcs: Sequence[Floats], numbers: Sequence[int]) -> Floats:
    """Return the line along some arcs; ~number means an arc run backwards."""
    parts = [arcs[n] if n >= 0 else arcs[~n][::-1] for n in numbers]
    return np.vstack([parts[0], *(part[1:] for part in parts[1:])])


def unwound(line: Floats) -> Floats:
    """Return a line that runs on over the date line, to longitudes beyond 180 if need be."""
    lon = np.unwrap(line[:, 0], period=360.0)
    lon -= 360.0 * np.round((lon.min() + lon.max()) / 720.0)
    return np.column_stack([lon, line[:, 1]])


def closed(ring: Floats) -> Floats:
    """Return a ring that ends where it begins; one that goes round a pole is led over it."""
    ring = unwound(ring)
    if abs(ring[0, 0] - ring[-1, 0]) < 180.0:
        return ring
    pole = math.copysign(90.0, float(ring[:, 1].mean()))
    return np.vstack([ring, [ring[-1, 0], pole], [ring[0, 0], pole], ring[0]])


def polygons(geometry: Mapping[str, Any]) -> Iterator[list[list[int]]]:
    """Yield the polygons of a geometry, each the arcs of its rings."""
    if geometry["type"] == "GeometryCollection":
        for one in geometry["geometries"]:
            yield from polygons(one)
    elif geometry["type"] == "Polygon":
        yield geometry["arcs"]
    elif geometry["type"] == "MultiPolygon":
        yield from geometry["arcs"]


def border_arcs(countries: Mapping[str, Any]) -> list[int]:
    """Return the arcs that more than one country has."""
    users: Counter[int] = Counter()
    for country in countries["geometries"]:
        users.update({n if n >= 0 else ~n for p in polygons(country) for ring in p for n in ring})
    return sorted(n for n, count in users.items() if count > 1)


def simplified(line: Floats) -> Floats:
    """Return a line with fewer points, none of it farther off than the tolerance."""
    wide = max(float(np.cos(np.radians(np.clip(abs(line[:, 1]).mean(), 0, 85)))), 0.05)
    scale = np.array([wide, 1.0])
    kept = shapely.simplify(shapely.linestrings(line * scale), TOLERANCE_DEG)
    return np.asarray(shapely.get_coordinates(kept) / scale)


def area_m2(ring: Floats) -> float:
    """Return the area of a ring, more than zero where it runs clockwise."""
    (x, y), per = ring.T, metres_per_degree(float(ring[:, 1].mean()))
    twice = np.sum(x[1:] * y[:-1] - x[:-1] * y[1:])
    return float(twice / 2 * per[0] * per[1])


def made(topology: Mapping[str, Any], about: Mapping[str, str]) -> tuple[GroundTable, int]:
    """Return the table of the objects `countries` and `land`, and how many isles are left out."""
    arcs = decoded_arcs(topology)
    land, left_out = [], 0
    for polygon in polygons(topology["objects"]["land"]):
        for place, numbers in enumerate(polygon):
            ring = closed(joined(arcs, numbers))
            area = area_m2(ring)
            if abs(area) < LEAST_LAND_M2:
                left_out += 1
                continue
            # Land is run clockwise, water in it the other way.
            clockwise = ring if (area > 0) == (place == 0) else ring[::-1]
            fewer = simplified(clockwise)
            land.append(fewer if len(fewer) > 3 else clockwise)
    borders = [simplified(unwound(arcs[n])) for n in border_arcs(topology["objects"]["countries"])]
    return GroundTable.of(land, borders, about), left_out


def from_package(path: Path) -> tuple[GroundTable, int]:
    """Return the table of the npm package world-atlas, as `npm pack` names it."""
    with tarfile.open(path) as package:
        read = {
            name: json.loads(package.extractfile(f"package/{name}").read())  # type: ignore[union-attr]  # these are files
            for name in ("package.json", COUNTRIES)
        }
    return made(
        read[COUNTRIES],
        {
            "data": "Natural Earth (https://www.naturalearthdata.com), public domain",
            "package": f"world-atlas {read['package.json']['version']}",
        },
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("package", type=Path, help="world-atlas-….tgz, from npm pack world-atlas")
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args()
    table, left_out = from_package(options.package)
    print(f"{len(table.land):>9,}  rings of land, {sum(map(len, table.land)):,} points")
    print(f"{len(table.borders):>9,}  lines of borders, {sum(map(len, table.borders)):,} points")
    print(f"{left_out:>9,}  islands left out, smaller than {LEAST_LAND_M2 / 1e6:g} km2")
    if not options.check:
        table.write(FILE)
        print(f"{FILE.relative_to(ROOT)}: {FILE.stat().st_size:,} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
