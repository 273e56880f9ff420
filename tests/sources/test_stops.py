"""Which tags make a stop for trucks, what is kept of them, and which things are one stop."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import MOTORWAY, row, write

from platoon_osm.network.columns import POINT_KINDS, STOP_KINDS
from platoon_osm.network.restrictions import decode
from platoon_osm.network.stop_tags import kilowatts, stay_s
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.stops.features import STOP_TAGS, TRUCK_KEYS, read_stop
from platoon_osm.sources.stops.merging import StopPlace, merged_stops
from platoon_osm.sources.stops.sides import RoadSides

PARKING, FUEL, CHARGING = (
    {"amenity": kind} for kind in ("parking", "fuel", "charging_station")
)  # fmt: skip


def reading(**tags):
    """Return kind and capacity of a stop, or why it is none."""
    counts = Counter()
    found = read_stop({key.replace("__", ":"): value for key, value in tags.items()}, counts)
    return (found.kind, found.capacity) if found and found.trucks else sorted(counts)


TRUCKS = [
    # areas
    ({"highway": "services"}, ("services", -1)),
    ({"highway": "rest_area", "capacity:hgv": "25"}, ("rest_area", 25)),
    ({"highway": "rest_area", "capacity": "25"}, ("rest_area", -1)),
    ({"highway": "rest_area", "access": "private"}, ["service and rest areas not open to trucks"]),
    ({"highway": "rest_area", "access": "no", "hgv": "yes"}, ("rest_area", -1)),
    ({"highway": "rest_area", "access": "customers"}, ("rest_area", -1)),
    ({"highway": "services", "hgv": "no"}, ("services", -1)),
    ({"highway": "services", "disused": "yes"}, ["service and rest areas out of use"]),
    # parkings
    (PARKING, ["parking places that say nothing of trucks"]),
    ({**PARKING, "capacity": "80"}, ["parking places that say nothing of trucks"]),
    ({**PARKING, "hgv": "yes", "capacity": "80"}, ("parking", -1)),
    ({**PARKING, "hgv": "designated", "capacity": "80"}, ("parking", 80)),
    ({**PARKING, "hgv": "designated", "capacity": "80", "access": "yes"}, ("parking", -1)),
    ({**PARKING, "hgv": "designated", "capacity": "80", "motorcar": "yes"}, ("parking", -1)),
    ({**PARKING, "hgv": "only", "capacity": "80"}, ("parking", 80)),
    ({**PARKING, "hgv": "yes", "capacity": "80", "motorcar": "no"}, ("parking", 80)),
    ({**PARKING, "hgv": "yes", "capacity": "80", "access": "private"}, ("parking", 80)),
    ({**PARKING, "hgv": "designated", "capacity": "80", "capacity:hgv": "12"}, ("parking", 12)),
    ({**PARKING, "hgv": "no"}, ["parking places not open to trucks"]),
    ({**PARKING, "hgv": "private"}, ["parking places not open to trucks"]),
    ({**PARKING, "hgv": "customers"}, ("parking", -1)),
    ({**PARKING, "truck": "yes"}, ("parking", -1)),
    ({**PARKING, "access": "hgv", "capacity": "9"}, ("parking", 9)),
    ({**PARKING, "parking": "truck"}, ("parking", -1)),
    ({**PARKING, "hgv:parking": "yes"}, ("parking", -1)),
    ({**PARKING, "hgv:parking": "no"}, ["parking places not open to trucks"]),
    ({**PARKING, "capacity:hgv": "7"}, ("parking", 7)),
    ({**PARKING, "capacity:truck": "7"}, ("parking", 7)),
    ({**PARKING, "capacity:hgv": "yes"}, ("parking", -1)),
    ({**PARKING, "capacity:hgv": "0"}, ["parking places not open to trucks"]),
    ({**PARKING, "capacity:hgv": "no"}, ["parking places not open to trucks"]),
    ({**PARKING, "capacity:hgv": "7", "access": "private"}, ["parking places not open to trucks"]),
    ({**PARKING, "capacity:hgv": "7", "access": "no"}, ["parking places not open to trucks"]),
    (
        {**PARKING, "capacity:hgv": "7", "access": "club"},
        ["access of stops not understood, taken as closed", "parking places not open to trucks"],
    ),
    # pumps
    (FUEL, ["fuel places that say nothing of trucks"]),
    ({**FUEL, "fuel:diesel": "yes"}, ["fuel places that say nothing of trucks"]),
    ({**FUEL, "fuel:cng": "yes"}, ["fuel places that say nothing of trucks"]),
    ({**FUEL, "fuel:HGV_diesel": "yes"}, ("fuel", -1)),
    ({**FUEL, "fuel:HGV_diesel": "no"}, ["fuel places that say nothing of trucks"]),
    ({**FUEL, "fuel:lng": "yes"}, ("fuel", -1)),
    ({**FUEL, "hgv": "yes"}, ("fuel", -1)),
    ({**FUEL, "hgv": "no", "fuel:lng": "yes"}, ["fuel places not open to trucks"]),
    ({**FUEL, "hgv:lanes": "2"}, ("fuel", -1)),
    ({**FUEL, "capacity:hgv": "4"}, ("fuel", 4)),
    ({**FUEL, "fuel:lng": "yes", "access": "private"}, ["fuel places not open to trucks"]),
    # chargers
    (CHARGING, ["charging places that say nothing of trucks"]),
    ({**CHARGING, "socket:type2_combo": "4"}, ["charging places that say nothing of trucks"]),
    ({**CHARGING, "socket:mcs": "2"}, ("charging", -1)),
    ({**CHARGING, "hgv": "designated"}, ("charging", -1)),
    ({**CHARGING, "truck": "yes"}, ("charging", -1)),
    ({**CHARGING, "capacity:hgv": "4"}, ("charging", 4)),
    ({**CHARGING, "hgv": "yes", "construction": "yes"}, ["charging places out of use"]),
    # neither
    ({"amenity": "restaurant", "hgv": "yes"}, []),
    ({"highway": "motorway", "hgv": "yes"}, []),
]  # fmt: skip


@pytest.mark.parametrize(("tags", "told"), TRUCKS, ids=[str(tags) for tags, _ in TRUCKS])
def test_what_is_a_stop_for_trucks(tags, told):
    assert reading(**tags) == told


@pytest.mark.parametrize(
    "text", ["ca. 20", "many", "20-30", "~20", "20+", "٢٠", "-3", "12345678901"]
)
def test_a_capacity_that_cannot_be_read_is_counted(text):
    counts = Counter()
    found = read_stop({**PARKING, "capacity:hgv": text}, counts)
    assert (found.capacity, dict(counts)) == (-1, {"capacities for trucks not understood": 1})


def test_what_cannot_be_read_of_fuels_powers_and_stays_is_counted():
    counts = Counter()
    tags = {
        "amenity": "charging_station", "hgv": "yes", "socket:mcs:output": "plenty",
        "socket:type2_combo:output": "350 kW", "socket:type2_combo": "2", "maxstay": "a while",
        "fuel:lng": "perhaps", "fuel:diesel": "yes", "fuel:octane_95": "perhaps",
    }  # fmt: skip
    found = read_stop(tags, counts)
    assert dict(counts) == {
        "charging powers not understood": 1, "fuels not understood": 1,
        "longest stays not understood": 1,
    }  # fmt: skip
    assert "socket:mcs:output" not in found.tags
    assert found.tags["socket:type2_combo:output"] == "350 kW"
    assert "fuel:octane_95" not in found.tags


@pytest.mark.parametrize(
    ("text", "kw"),
    [
        ("150 kW", 150), ("150", 150), ("22000 W", 22), ("1 MW", 1000), ("3,75 MW", 3750),
        ("150 kW;350 kW", 350), ("43kva", 43), ("0", None), ("fast", None), ("150 kW;fast", None),
        ("99999", None), ("", None), ("-5", None),
    ],
)  # fmt: skip
def test_powers(text, kw):
    assert kilowatts(text) == (None if kw is None else pytest.approx(kw))


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("2 h", 7200), ("45 min", 2700), ("45 minutes", 2700), ("1.5 hours", 5400), ("2h", 7200),
        ("00:45", 2700), ("24:00", 86400), ("1 day", 86400), ("no", None), ("2", None), ("", None),
    ],
)  # fmt: skip
def test_longest_stays(text, seconds):
    assert stay_s(text) == seconds


KEYS = st.sampled_from(
    [*TRUCK_KEYS, "access", "parking", "capacity", "fee", "maxstay", "fuel:lng", "fuel:diesel",
     "fuel:HGV_diesel", "socket:mcs", "socket:mcs:output", "hgv:lanes", "motorcar", "disused",
     "maxheight", "name"]
)  # fmt: skip
TEXTS = st.one_of(
    st.sampled_from(["yes", "no", "designated", "only", "private", "customers", "20", "0", "many",
                     "hgv", "150 kW", "2 h", "", " "]),
    st.text(max_size=6),
)  # fmt: skip


@given(st.sampled_from(STOP_TAGS), st.dictionaries(KEYS, TEXTS, max_size=5))
def test_whatever_the_tags_a_thing_is_a_stop_or_counted(tag, more):
    counts = Counter()
    found = read_stop({**more, tag[0]: tag[1]}, counts)
    assert (found is not None) or sum(counts.values()) > 0
    if found is not None:
        assert found.kind in STOP_KINDS
        assert found.capacity >= -1
        assert found.trucks or found.kind == "fuel"
        assert found.trucks or counts["fuel places that say nothing of trucks"] == 1
        closed = more.get("hgv", "").strip().lower() in ("no", "private")
        assert not closed or tag[0] == "highway"


# -- read from files -----------------------------------------------------------------------------

NODES = row(3) | {
    # A service area, 60 m south of the road, with a fuel station, a parking and chargers in it.
    20: (11.002, 44.9990, {}), 21: (11.006, 44.9990, {}), 22: (11.006, 44.9996, {}),
    23: (11.002, 44.9996, {}),
    30: (11.003, 44.9992, {**FUEL, "fuel:diesel": "yes", "fuel:cng": "yes"}),
    31: (11.004, 44.9993, {**PARKING, "hgv": "designated", "capacity": "40", "fee": "no"}),
    32: (11.005, 44.9993, {**CHARGING, "hgv": "yes", "socket:mcs:output": "1 MW",
                           "maxheight": "4.5"}),
    33: (11.0055, 44.9991, {**PARKING, "capacity:hgv": "15"}),
    # Opposite, 60 m to the north: another stop though it is not 300 m away.
    40: (11.004, 45.0006, {**PARKING, "hgv": "yes", "name": "Nord"}),
    # A rest area that is a point, with a fuel station near to it.
    50: (11.012, 44.9993, {"highway": "rest_area", "name": "Rest"}),
    51: (11.013, 44.9993, {**FUEL, "hgv": "yes", "brand": "Oil"}),
    # For others.
    60: (11.018, 44.9993, {**PARKING, "capacity": "500"}),
    61: (11.018, 44.9994, {**FUEL, "fuel:diesel": "yes"}),
}  # fmt: skip
WAYS = {
    1: ([1, 2, 3], MOTORWAY),
    2: ([20, 21, 22, 23, 20], {"highway": "services", "name": "Area"}),
}


def told(net):
    """Return stops by name, with what they offer."""
    return {stop.name: stop for stop in net.stops()}


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_one_stop_with_several_offers(tmp_path, suffix):
    net = read_osm(write(tmp_path, NODES, WAYS, suffix=suffix))
    stops = told(net)
    assert sorted(stops) == ["Area", "Nord", "Rest"]
    area, north, rest = (stops[name] for name in ("Area", "Nord", "Rest"))
    assert (area.kind, area.offers, area.capacity) == (
        "services",
        ("parking", "fuel", "charging"),
        55,
    )
    assert (area.fuels, area.power_kw, area.fee) == (("cng", "diesel"), 1000.0, False)
    assert (area.lon, area.lat) == pytest.approx((11.004, 44.9993))
    assert {"amenity": "charging_station", "hgv": "yes", "maxheight": "4.5",
            "socket:mcs:output": "1 MW"} in decode(area.tags)  # fmt: skip
    assert (north.kind, north.capacity, north.fee) == ("parking", None, None)
    assert (rest.kind, rest.offers, rest.fuels) == ("rest_area", ("parking", "fuel"), ())
    report = net.report()
    assert report["service and rest areas"] == 2
    assert report["truck parkings beside them"] == 1
    assert report["fuel places that say nothing of trucks"] == 2


def test_an_area_that_is_a_relation_is_one_too(tmp_path):
    ways = {1: WAYS[1], 2: ([20, 21, 22], {}), 3: ([22, 23, 20], {})}
    members = [("way", 2, "outer"), ("way", 3, "outer")]
    relations = {
        7: (members, {"type": "multipolygon", "highway": "services", "name": "Area"}),
        8: (members, {"type": "multipolygon", **PARKING}),
        9: ([("way", 1, "outer")], {"type": "boundary", "place": "town"}),
    }  # fmt: skip
    for suffix in (".osm", ".osm.pbf"):
        net = read_osm(write(tmp_path, NODES, ways, suffix=suffix, relations=relations))
        area = told(net)["Area"]
        assert (area.capacity, area.offers) == (55, ("parking", "fuel", "charging"))
        assert (area.lon, area.lat) == pytest.approx((11.004, 44.9993))


def test_the_place_of_a_hollow_area_is_within_it(tmp_path):
    corners = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3)]
    nodes = row(3) | {
        100 + k: (11.0 + x / 1000, 44.996 + y / 1000, {}) for k, (x, y) in enumerate(corners)
    }
    ring = [*range(100, 108), 100]
    net = read_osm(write(tmp_path, nodes, {1: WAYS[1], 2: (ring, {"highway": "rest_area"})}))
    (stop,) = net.stops()
    x, y = (stop.lon - 11.0) * 1000, (stop.lat - 44.996) * 1000
    assert 0 < x < 3
    assert 0 < y < 3
    assert not (1 <= x <= 3 and 1 <= y <= 2)


def test_tunnels_with_a_category_are_kept_once(tmp_path):
    tunnel = {**MOTORWAY, "tunnel": "yes", "name": "Galleria", "hazmat:adr_tunnel_cat": "C"}
    ways = {
        1: ([1, 2], MOTORWAY), 2: ([2, 3], tunnel), 3: ([3, 4], {**tunnel, "maxspeed": "70"}),
        4: ([4, 5], {**MOTORWAY, "tunnel": "yes"}),
        5: ([5, 6], {**tunnel, "hazmat:adr_tunnel_cat": "Z"}),
    }  # fmt: skip
    net = read_osm(write(tmp_path, row(6), ways))
    bored = np.flatnonzero(net.points.kind == POINT_KINDS.index("tunnel"))
    assert [net.texts[net.points.name[k]] for k in bored] == ["Galleria"]
    assert net.stops() == ()
    report = net.report()
    assert report["tunnels with an ADR category"] == 1
    assert report["ways in tunnels without an ADR category"] == 1
    assert report["categories of tunnels not understood"] == 1


# -- what belongs together -----------------------------------------------------------------------


@st.composite
def places(draw):
    """Draw things near each other, some with an outline."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    found = []
    for number in range(draw(st.integers(1, 9))):
        tags = draw(
            st.sampled_from(
                [{"highway": "services"}, {"highway": "rest_area"}, FUEL, {**FUEL, "hgv": "yes"},
                 {**PARKING, "capacity:hgv": "5"}, {**PARKING, "hgv": "yes"},
                 {**CHARGING, "hgv": "yes"}]
            )
        )  # fmt: skip
        lon, lat = 11 + rng.uniform(-0.005, 0.005, 1)[0], 45 + rng.uniform(-0.004, 0.004, 1)[0]
        ring = np.zeros((0, 2))
        if draw(st.booleans()):
            half = rng.uniform(1e-4, 4e-3, 2)
            ring = np.array([lon, lat]) + half * [[-1, -1], [1, -1], [1, 1], [-1, 1]]
        found.append(StopPlace(read_stop(tags, Counter()), lon, lat, ("node", number), ring))
    return found


@settings(max_examples=40)
@given(places(), st.randoms())
def test_every_part_is_in_one_stop_whatever_the_order(found, random):
    apart = RoadSides(np.array([[10.9, 45.0, 11.1, 45.0]]))
    stops = merged_stops(found, apart)
    mixed = list(found)
    random.shuffle(mixed)
    assert merged_stops([*mixed, *found], apart) == stops
    # Each truck place is in exactly one stop; spaces are neither lost nor counted twice.
    spaces = sum(place.reading.capacity for place in found if place.reading.capacity > 0)
    assert sum(max(stop.capacity, 0) for stop in stops) == spaces
    trucks = {place.reading.kind for place in found if place.reading.trucks}
    assert bool(stops) == bool(trucks)
    own = [place for place in found if place.reading.kind in ("services", "rest_area")]
    for stop in stops:
        # An area with an outline says itself what is in it.
        if stop.kind in ("fuel", "charging") and not any(len(place.ring) for place in own):
            near = [p for p in own if (p.lat > 45) == (stop.lat > 45)]
            gap = [
                np.hypot((p.lon - stop.lon) * 78_850, (p.lat - stop.lat) * 111_140) for p in near
            ]
            assert all(metres > 299 for metres in gap)


@settings(max_examples=25)
@given(st.integers(0, 2**32))
def test_the_sides_of_roads_are_those_of_shapely(seed):
    import shapely

    rng = np.random.default_rng(seed)
    start = np.array([11, 45]) + rng.uniform(-0.05, 0.05, (40, 2))
    roads = np.hstack([start, start + rng.uniform(-0.04, 0.04, (40, 2))])
    a = np.array([11, 45]) + rng.uniform(-0.05, 0.05, (20, 2))
    lines = np.hstack([a, a + rng.uniform(-0.003, 0.003, (20, 2))])
    drawn = shapely.MultiLineString([[one[:2], one[2:]] for one in roads])
    expected = [drawn.intersects(shapely.LineString([one[:2], one[2:]])) for one in lines]
    assert RoadSides(roads)(lines).tolist() == expected
    assert RoadSides(np.zeros((0, 4)))(lines).tolist() == [False] * 20
    assert RoadSides(roads)(lines[:0]).tolist() == []


def test_answers_of_overpass_are_read_alike(tmp_path):
    import json

    from platoon_osm.sources.overpass.answers import read_overpass_cache
    from platoon_osm.sources.truck import TruckRules

    corners = [{"lon": lon, "lat": lat} for lon, lat, _ in (NODES[k] for k in (20, 21, 22, 23, 20))]
    member = {"type": "way", "ref": 2, "role": "outer", "geometry": corners}
    area = {"type": "multipolygon", "highway": "services", "name": "Area"}
    elements = [
        *({"type": "node", "id": k, "lon": lon, "lat": lat, "tags": tags}
          for k, (lon, lat, tags) in NODES.items()),
        {"type": "way", "id": 1, "nodes": [1, 2, 3], "tags": MOTORWAY},
        {"type": "relation", "id": 7, "members": [member], "tags": area},
    ]  # fmt: skip
    path = tmp_path / "answer.json"
    path.write_text(json.dumps({"elements": elements}))
    net = read_overpass_cache(path, ["motorway"], TruckRules())
    file = read_osm(write(tmp_path, NODES, WAYS))
    assert [(s.name, s.offers, s.capacity, s.tags) for s in net.stops()] == [
        (s.name, s.offers, s.capacity, s.tags) for s in file.stops()
    ]
    for reason in ("fuel places that say nothing of trucks", "service and rest areas"):
        assert net.report()[reason] == file.report()[reason] > 0


def test_an_area_across_the_date_line_lies_in_its_middle(tmp_path):
    corners = [(179.999, -17.001), (-179.997, -17.001), (-179.997, -17.0005), (179.999, -17.0005)]
    nodes = {1: (179.99, -17.0, {}), 2: (-179.99, -17.0, {})} | {
        20 + k: (*corner, {}) for k, corner in enumerate(corners)
    }
    nodes[30] = (-179.998, -17.0008, {**PARKING, "capacity:hgv": "5"})
    ways = {1: ([1, 2], MOTORWAY), 2: ([20, 21, 22, 23, 20], {"highway": "rest_area"})}
    (stop,) = read_osm(write(tmp_path, nodes, ways)).stops()
    assert (stop.lon, stop.lat) == pytest.approx((-179.999, -17.00075))
    assert stop.capacity == 5


@pytest.mark.parametrize("shape", ["way", "relation"])
def test_an_area_on_the_antimeridian_is_one_stop_in_its_middle(tmp_path, shape):
    nodes = {
        number: ((lon + 168.996 + 180) % 360 - 180, lat, tags)
        for number, (lon, lat, tags) in NODES.items()
    }
    ways, relations = WAYS, {}
    if shape == "relation":
        ways = {1: WAYS[1], 2: ([20, 21, 22], {}), 3: ([22, 23, 20], {})}
        members = [("way", 2, "outer"), ("way", 3, "outer")]
        tags = {"type": "multipolygon", "highway": "services", "name": "Area"}
        relations = {7: (members, tags), 8: (members, {"type": "multipolygon", **PARKING})}
    area = told(read_osm(write(tmp_path, nodes, ways, relations=relations)))["Area"]
    here = told(read_osm(write(tmp_path, NODES, ways, relations=relations)))["Area"]
    assert (area.capacity, area.offers, area.tags) == (here.capacity, here.offers, here.tags)
    assert abs(area.lon) == pytest.approx(180.0)
    assert area.lat == pytest.approx(here.lat)
