"""Which tag of a road decides how fast it is driven, by country and kind of road."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import row, write

from platoon_osm.sources.country.law import law_of, laws
from platoon_osm.sources.load import load_network
from platoon_osm.sources.speeds.of_road import (
    BY_LAW,
    CAPPED,
    CLASS_SPEEDS_KMH,
    DEFAULTED,
    LOWEST,
    ODD,
    car_kmh,
    truck_kmh,
)
from platoon_osm.sources.truck import TruckRules

MPH = 1.609344


def read(country=None, limiter=None, **tags):
    """Return truck's and car's speed on a primary road with some tags, and what was remarked."""
    named = {"highway": "primary"} | {k.replace("__", ":"): v for k, v in tags.items()}
    remarks = []
    rules = TruckRules(country, limiter)
    truck = truck_kmh(named, "forward", rules, remarks)
    return pytest.approx(truck), pytest.approx(car_kmh(named, "forward", rules)), remarks


@pytest.mark.parametrize(
    ("country", "tags", "truck", "car"),
    [
        ("DE", {"highway": "motorway", "maxspeed": "none"}, 80, 150),
        ("DE", {"maxspeed": "100"}, 60, 100),
        ("DE", {"highway": "trunk", "maxspeed": "100", "motorroad": "yes"}, 80, 100),
        ("DE", {"highway": "trunk", "maxspeed": "120", "oneway": "yes"}, 80, 120),
        ("DE", {"highway": "trunk", "maxspeed": "90", "oneway": "no"}, 60, 90),
        ("DE", {"maxspeed": "90", "oneway": "yes", "dual_carriageway": "no"}, 60, 90),
        ("FR", {"highway": "motorway", "maxspeed": "130"}, 90, 130),
        ("FR", {"maxspeed": "80"}, 60, 80),
        ("GB", {"highway": "motorway", "maxspeed": "70 mph"}, 90, 70 * MPH),
        ("GB", {"maxspeed": "60 mph"}, 50 * MPH, 60 * MPH),
        ("GB", {"maxspeed": "70 mph", "dual_carriageway": "yes"}, 90, 70 * MPH),
        ("GB", {"maxspeed:type": "GB:nsl_dual"}, 90, 70 * MPH),
        ("GB", {"maxspeed:type": "GB:nsl_single"}, 50 * MPH, 60 * MPH),
        ("PT", {"source:maxspeed": "PT:urban"}, 40, 50),
        ("PT", {"maxspeed": "60", "zone:traffic": "PT:urban"}, 40, 60),
        ("US-CA", {"highway": "motorway", "maxspeed": "65 mph"}, 55 * MPH, 65 * MPH),
        ("US-NY", {"highway": "motorway", "maxspeed": "65 mph"}, 65 * MPH, 65 * MPH),
        ("US-NY", {"highway": "motorway"}, 65 * MPH, 65 * MPH),
        ("US-TX", {"highway": "motorway", "maxspeed": "85 mph"}, 85 * MPH, 85 * MPH),
        ("US-WA", {"highway": "motorway", "maxspeed": "70 mph"}, 60 * MPH, 70 * MPH),
        ("CA-ON", {"highway": "motorway", "maxspeed": "110"}, 105, 110),
        ("AU", {"highway": "motorway", "maxspeed": "110"}, 100, 110),
        ("NZ", {"maxspeed": "100"}, 90, 100),
        ("JP", {"highway": "motorway", "maxspeed": "100"}, 80, 100),
        ("BR", {"highway": "trunk", "maxspeed": "110", "oneway": "yes"}, 90, 110),
        (None, {"highway": "motorway", "maxspeed": "130"}, 90, 130),
    ],
)  # fmt: skip
def test_the_law_of_the_country_and_its_limiter_cap(country, tags, truck, car):
    assert read(country, **{k.replace(":", "__"): v for k, v in tags.items()})[:2] == (truck, car)


@pytest.mark.parametrize(
    ("tags", "truck", "car", "remarks"),
    [
        ({"maxspeed:type": "DE:urban"}, 50, 50, [BY_LAW]),
        ({"highway": "motorway", "maxspeed:type": "DE:urban"}, 50, 50, [BY_LAW]),
        ({"source:maxspeed": "DE:rural"}, 60, 100, [BY_LAW, CAPPED]),
        ({"zone:maxspeed": "DE:30"}, 30, 30, [BY_LAW]),
        ({"zone:traffic": "DE:urban;DE:rural"}, 50, 50, [BY_LAW]),
        ({"zone:traffic:forward": "DE:urban", "zone:traffic": "DE:rural"}, 50, 50, [BY_LAW]),
        ({"zone:traffic:backward": "DE:urban"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"highway": "motorway", "zone:traffic": "NL:rural"}, 80, 130, [BY_LAW, CAPPED]),
        # A number on the road stands before the kind of place, and the other keys say other things.
        ({"maxspeed": "70", "source:maxspeed": "DE:urban"}, 50, 70, [CAPPED]),
        ({"maxspeed:type": "sign"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"source:maxspeed": "survey 2013;30"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"source:maxspeed": "urban"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"maxspeed:advisory": "30"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"maxspeed": "signals"}, 60, 70, [ODD, DEFAULTED, CAPPED]),
        ({"maxspeed": "fast"}, 60, 70, [ODD, DEFAULTED, CAPPED]),
        ({"maxspeed": "walk"}, 7, 7, []),
        ({"maxspeed:lanes": "80|50"}, 50, 50, []),
        ({"maxspeed": "60", "maxspeed:lanes": "80|50"}, 60, 60, []),
        ({"maxspeed": "50/80"}, 50, 50, [LOWEST]),
        # Not understood: never faster than the class would be.
        ({"maxspeed": "100?"}, 60, 70, [LOWEST, CAPPED]),
        ({"maxspeed": "100", "maxspeed:hgv": "40?"}, 40, 100, [LOWEST, CAPPED]),
        ({"maxspeed": "50", "maxspeed:hgv": "80?"}, 50, 50, [LOWEST]),
        ({"maxspeed": "50", "maxspeed:hgv": "80"}, 80, 50, []),
        ({"maxspeed:hgv": "DE:rural:hgv"}, 60, 70, [DEFAULTED, CAPPED]),
        ({"maxspeed": "50", "maxspeed:goods": "40"}, 40, 40, []),
        ({"maxspeed": "100", "maxspeed:goods": "80"}, 60, 80, [CAPPED]),
        ({"maxspeed": "100; 50 (hgv)"}, 50, 100, []),
        ({"maxspeed": "50 (hgv)"}, 50, 70, []),
    ],
)
def test_which_tag_decides(tags, truck, car, remarks):
    found = read("DE", **{k.replace(":", "__"): v for k, v in tags.items()})
    assert found == (truck, car, remarks)


KEYS = st.sampled_from(
    ["maxspeed", "maxspeed:forward", "maxspeed:hgv", "maxspeed:goods", "maxspeed:lanes",
     "maxspeed:type", "zone:traffic", "source:maxspeed", "maxspeed:advisory"]
)  # fmt: skip
VALUES = st.sampled_from(
    ["fast", "120?", "ca. 90 or more", "60/80", "100 (dry)", "signals", "sign", "?", "", "70100"]
)


@settings(max_examples=300, deadline=None)
@given(
    st.dictionaries(KEYS, VALUES, max_size=5),
    st.sampled_from([*CLASS_SPEEDS_KMH, "motorway_link", "residential"]),
    st.sampled_from([None, *laws()]),
)
def test_no_text_that_is_not_understood_makes_a_road_faster(tags, highway, country):
    rules = TruckRules(country)
    bare = {"highway": highway}
    with_them = bare | tags
    assert truck_kmh(with_them, "forward", rules, []) <= truck_kmh(bare, "forward", rules, [])
    assert car_kmh(with_them, "forward", rules) <= car_kmh(bare, "forward", rules)


@settings(max_examples=200, deadline=None)
@given(
    st.sampled_from([*CLASS_SPEEDS_KMH, "trunk_link"]),
    st.sampled_from(["130", "none", "75 mph", "90", "fast"]),
    st.sampled_from(sorted(laws())),
    st.sampled_from(["yes", "no"]),
)
def test_no_truck_is_faster_than_its_law_and_limiter(highway, limit, country, oneway):
    tags = {"highway": highway, "maxspeed": limit, "oneway": oneway}
    law, rules = law_of(country), TruckRules(country)
    kind = "motorway" if highway == "motorway" else "dual" if highway[:5] == "trunk" else "rural"
    kind = "rural" if kind == "dual" and oneway == "no" else kind
    speed = truck_kmh(tags, "forward", rules, [])
    assert 3 <= speed <= min(law.truck_kmh(kind), rules.limiter)


def test_a_limiter_that_is_asked_for_holds_everywhere():
    rules = TruckRules(limiter_kmh=85)
    assert [rules.within(code).limiter for code in ("AU", "US-NY", "IT", "")] == [85] * 4
    free = TruckRules()
    assert [free.within(code).limiter for code in ("AU", "US-NY", "IT", "", "ZW")] == [
        100, 150, 90, 90, 90,
    ]  # fmt: skip


def test_a_country_without_a_truck_limit_is_counted(tmp_path):
    tags = {"highway": "motorway", "oneway": "yes", "maxspeed": "90"}
    file = write(tmp_path, row(3), {10: ([1, 2, 3], tags)})
    net = load_network(file, country="IS")
    assert net.load_report.counts["no truck limit in the table: IS, motorway roads"] == 1
    assert "no limit of trucks' own in IS" in net.load_report.remarks[0]
    two = load_network(file, country="US-NY")
    assert "capped by no limiter and no limit of trucks' own in US-NY" in two.load_report.remarks[0]
