"""A tall country: California's motorways, schematic, and the real ones where they are."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
from places import SHARED

from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import POINT_KINDS, NamedPoints, RoadNetwork
from platoon_osm.network.texts import encode_texts
from platoon_osm.sources.load import load_network

EXTRACT = SHARED / "data" / "osm" / "california-motorway.osm.pbf"

PLACES = {
    "San Francisco": (-122.41, 37.77), "Oakland": (-122.27, 37.80), "Vallejo": (-122.24, 38.10),
    "Sacramento": (-121.49, 38.58), "Tracy": (-121.43, 37.73), "Stockton": (-121.30, 37.95),
    "San Jose": (-121.89, 37.33), "Santa Nella": (-121.02, 37.10), "Kettleman": (-119.96, 36.01),
    "Modesto": (-121.00, 37.64), "Fresno": (-119.79, 36.74), "Bakersfield": (-119.05, 35.37),
    "Wheeler Ridge": (-118.95, 35.00), "Los Angeles": (-118.24, 34.05),
    "Redding": (-122.36, 40.59), "Red Bluff": (-122.20, 40.16),
}  # fmt: skip

ROADS = {
    "I 5": ["Redding", "Red Bluff", "Sacramento", "Stockton", "Tracy", "Santa Nella", "Kettleman",
            "Wheeler Ridge", "Los Angeles"],
    "CA 99": ["Sacramento", "Stockton", "Modesto", "Fresno", "Bakersfield", "Wheeler Ridge"],
    "I 80": ["San Francisco", "Oakland", "Vallejo", "Sacramento"],
    "I 580": ["Oakland", "Tracy"],
    "US 101": ["San Francisco", "San Jose", "Santa Nella"],
}  # fmt: skip


@cache
def tall_country() -> RoadNetwork:
    """Winding roads from Redding to Los Angeles, twice as tall as wide."""
    names = list(PLACES)
    at = np.array([PLACES[name] for name in names])
    rng = np.random.default_rng(5)
    ends: list[tuple[int, int]] = []
    refs: list[str] = []
    shapes: list[np.ndarray] = []
    for ref, stops in ROADS.items():
        for a, b in pairwise(stops):
            i, j = names.index(a), names.index(b)
            k = max(4, int(np.hypot(*(at[j] - at[i])) / 0.03))
            share = np.linspace(0, 1, k)[:, None]
            bend = rng.normal(0, 0.012, (k, 2)).cumsum(axis=0)
            bend -= share * bend[-1]
            bend[0] = bend[-1] = 0
            shape = at[i] + share * (at[j] - at[i]) + bend
            ends += [(i, j), (j, i)]
            refs += [ref, ref]
            shapes += [shape, shape[::-1]]
    flat = np.vstack(shapes)
    texts, (node_codes, ref_codes, none, town_codes) = encode_texts(
        names, refs, [""] * len(refs), names
    )
    return RoadNetwork.from_edges(
        [tail for tail, _ in ends], [head for _, head in ends], lon=at[:, 0], lat=at[:, 1],
        node_name=node_codes, ref=ref_codes, name=none,
        shape_first=np.concatenate([[0], np.cumsum([len(shape) for shape in shapes])]),
        shape_lon=flat[:, 0], shape_lat=flat[:, 1], texts=texts,
        points=NamedPoints(
            at[:, 0] + 0.02, at[:, 1] + 0.02,
            np.full(len(names), POINT_KINDS.index("city"), np.uint8), town_codes,
            np.arange(len(names))[::-1] * 40_000 + 60_000,
        ),
        source=Source("tall.osm", "5e1d" * 16, "2026-01-15T00:00:00Z", "CC0", "Made for tests"),
    )  # fmt: skip


@cache
def california() -> RoadNetwork | None:
    """The real motorways of California; None where the extract is not."""
    if not EXTRACT.is_file():
        return None
    return load_network(EXTRACT, country="US-CA", infer_links=True)
