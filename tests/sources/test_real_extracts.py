"""Real extracts of OpenStreetMap, where they are: counts, lengths and known distances."""

from itertools import pairwise

import numpy as np
import pytest
from places import SHARED as BESIDE

from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.road_network import ROAD_CLASSES
from platoon_osm.search.engine import many_to_many
from platoon_osm.sources.load import load_network

SHARED = BESIDE / "data" / "osm"
SAN_DIEGO, SACRAMENTO = (-117.16, 32.715), (-121.494, 38.58)
LOS_ANGELES, SAN_FRANCISCO = (-118.243, 34.052), (-122.41, 37.775)


def extract(name):
    path = SHARED / name
    if not path.is_file():
        pytest.skip(f"real extract {name} is not in ../shared/data/osm")
    return path


@pytest.fixture(scope="module")
def california():
    return load_network(extract("california-motorway.osm.pbf"), country="US-CA")


@pytest.fixture(scope="module")
def joined():
    return load_network(
        extract("california-motorway.osm.pbf"), country="US-CA", infer_links=True
    )  # fmt: skip


def test_california_is_counted(california):
    counts = california.report()
    assert counts["ways of these classes"] == 28_506
    dropped = sum(n for name, n in counts.counts.items() if name.startswith("ways dropped: closed"))
    assert counts["ways kept"] + dropped == 28_506
    assert counts["nodes missing from ways"] == 0
    assert 14_800e3 < california.length_m.sum() < 15_089e3
    # 55 mph, but for a few roads with a sign for trucks, which only the limiter caps.
    assert np.median(california.speed_mps) * 3.6 == pytest.approx(55 * 1.609344)
    assert california.speed_mps.max() * 3.6 <= 90
    assert california.source.sha256


def test_california_says_that_it_lacks_its_ramps(california):
    assert any("--infer-links" in remark for remark in california.report().remarks)


@pytest.mark.parametrize(
    ("start", "end", "km"),
    [
        (SAN_DIEGO, SACRAMENTO, 810), (SACRAMENTO, SAN_DIEGO, 810),
        (LOS_ANGELES, SAN_FRANCISCO, 615), (SAN_FRANCISCO, LOS_ANGELES, 615),
    ],
)  # fmt: skip
def test_long_routes_of_california(joined, start, end, km):
    origin, destination = joined.locate(start, "origin"), joined.locate(end, "destination")
    assert origin.distance_m < 3_000
    assert destination.distance_m < 3_000
    table = many_to_many(
        joined, joined.length_m,
        [node for node, _ in origin.candidates], [node for node, _ in destination.candidates],
    )  # fmt: skip
    assert table.min() / 1000 == pytest.approx(km, rel=0.03)


def test_most_of_california_hangs_together(joined, california):
    main = joined.strong_component() == 0
    mapped = ~joined.inferred
    inside = mapped & main[joined.tail] & main[joined.head]
    assert joined.length_m[inside].sum() >= 0.75 * joined.length_m[mapped].sum()
    # Inferring adds connectors; it neither lengthens nor loses a mapped road.
    assert joined.length_m[mapped].sum() == pytest.approx(california.length_m.sum())


def test_connectors_of_california_are_marked(joined):
    added = joined.inferred
    assert added.sum() == joined.report()["connectors inferred"] > 1_000
    assert (joined.way_id[added] == 0).all()
    assert (joined.way_id[~added] > 0).all()
    assert len(np.unique(joined.node_id)) == joined.n


@pytest.mark.parametrize("place", [SAN_DIEGO, SACRAMENTO, LOS_ANGELES, SAN_FRANCISCO])
def test_places_are_found_near_where_they_are_even_without_ramps(california, place):
    """Though next to nothing is strongly connected, no place is moved to that part."""
    for role in ("origin", "destination"):
        assert california.locate(place, role).candidates[0][1] < 5_000


@pytest.mark.parametrize(
    ("name", "motorway_km", "link_km"),
    [("harrisburg.osm.pbf", 75.9, 33.1), ("north-bayreuth.osm.gz", 21.9, 5.4)],
)
def test_lengths_of_the_complete_extracts(name, motorway_km, link_km):
    for kind, km in (("motorway", motorway_km), ("motorway_link", link_km)):
        net = load_network(extract(name), [kind])
        # A two-way ramp is one road, though it is two edges; a forbidden turn copies pieces.
        drawn = set()
        for edge in range(net.m):
            drawn |= {tuple(sorted(pair)) for pair in pairwise(map(tuple, net.shape(edge)))}
        (lon, lat), (to_lon, to_lat) = np.array(sorted(drawn)).transpose(1, 2, 0)
        length_m = distance_m(lon, lat, to_lon, to_lat).sum()
        assert net.road_class.tolist() == [ROAD_CLASSES.index(kind)] * net.m
        assert length_m / 1000 == pytest.approx(km, rel=0.03)


def test_junction_names_of_bayreuth():
    net = load_network(extract("north-bayreuth.osm.gz"), country="DE")
    assert net.report()["named junctions"] == 7
    names = {net.junction_name(v) for v in range(net.n)} - {""}
    assert names == {"Kulmbach/Neudrossenfeld", "Dreieck Bayreuth / Kulmbach", "Bindlacher Berg"}
    assert net.locate("bindlacher berg").distance_m == 0
