"""What restrictions mean for a vehicle: values, keys, limits, barriers, tunnels."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.network.restrictions import encode
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.vehicles.access import BARRIERS, VALUES, Way, read_value
from platoon_osm.vehicles.closures import Closures
from platoon_osm.vehicles.judgement import judge
from platoon_osm.vehicles.limits import LIMITS, read_limit
from platoon_osm.vehicles.profile import VEHICLES, Vehicle, vehicle_of

TRUCK, VAN = VEHICLES["eu-40t"], VEHICLES["van-3.5t"]


def way(tags, vehicle=TRUCK):
    return judge([tags], vehicle).way


@pytest.mark.parametrize(
    ("tags", "truck", "van"),
    [
        ({}, Way.OPEN, Way.OPEN),
        ({"access": "yes"}, Way.OPEN, Way.OPEN),
        ({"access": "official"}, Way.OPEN, Way.OPEN),
        ({"access": "no"}, Way.CLOSED, Way.CLOSED),
        ({"access": "no", "hgv": "yes"}, Way.OPEN, Way.CLOSED),
        ({"access": "yes", "hgv": "no"}, Way.CLOSED, Way.OPEN),
        ({"hgv": "no", "goods": "yes"}, Way.CLOSED, Way.OPEN),
        ({"goods": "no", "hgv": "designated"}, Way.OPEN, Way.CLOSED),
        ({"motor_vehicle": "no", "access": "yes"}, Way.CLOSED, Way.CLOSED),
        ({"vehicle": "no", "motor_vehicle": "yes"}, Way.OPEN, Way.OPEN),
        ({"motorcar": "no"}, Way.OPEN, Way.OPEN),
        ({"access": "customers"}, Way.ENDS, Way.ENDS),
        ({"hgv": "destination"}, Way.ENDS, Way.OPEN),
        ({"hgv": "delivery"}, Way.ENDS, Way.OPEN),
        ({"access": "private"}, Way.ENDS, Way.ENDS),
        ({"access": "permit"}, Way.ENDS, Way.ENDS),
        ({"hgv": "no;destination"}, Way.CLOSED, Way.OPEN),
        ({"hgv": "destination;delivery"}, Way.ENDS, Way.OPEN),
        ({"hgv": " No "}, Way.CLOSED, Way.OPEN),
        ({"access": "agricultural;forestry"}, Way.CLOSED, Way.CLOSED),
        ({"access": "hov"}, Way.CLOSED, Way.CLOSED),
        ({"access": "psv"}, Way.CLOSED, Way.CLOSED),
        ({"access": "bus"}, Way.CLOSED, Way.CLOSED),
        ({"access": "military"}, Way.CLOSED, Way.CLOSED),
        ({"access": "nonsense"}, Way.CLOSED, Way.CLOSED),
        ({"hov": "only"}, Way.CLOSED, Way.CLOSED),
        ({"hov": "designated"}, Way.CLOSED, Way.CLOSED),
        ({"hov": "lane"}, Way.OPEN, Way.OPEN),
        ({"hov": "designated", "hgv": "yes"}, Way.OPEN, Way.CLOSED),
        ({"bus": "designated"}, Way.OPEN, Way.OPEN),
        ({"psv": "only"}, Way.CLOSED, Way.CLOSED),
        ({"trailer": "no"}, Way.CLOSED, Way.OPEN),
        ({"hgv_articulated": "no"}, Way.CLOSED, Way.OPEN),
        ({"maxheight": "3.8"}, Way.CLOSED, Way.OPEN),
        ({"maxheight": "4"}, Way.OPEN, Way.OPEN),
        ({"maxheight": "2.5"}, Way.CLOSED, Way.CLOSED),
        ({"maxheight": "below_default"}, Way.CLOSED, Way.OPEN),
        ({"maxheight:physical": "3.9"}, Way.CLOSED, Way.OPEN),
        ({"maxwidth": "2.3"}, Way.CLOSED, Way.OPEN),
        ({"maxlength": "12"}, Way.CLOSED, Way.OPEN),
        ({"maxweight": "3.5"}, Way.CLOSED, Way.OPEN),
        ({"maxweight": "40"}, Way.OPEN, Way.OPEN),
        ({"maxweight": "3.5", "maxweight:hgv": "44"}, Way.OPEN, Way.OPEN),
        ({"maxweightrating:hgv": "3.5"}, Way.CLOSED, Way.OPEN),
        ({"maxweight:vehicle": "3.5"}, Way.CLOSED, Way.OPEN),
        ({"maxheight:access": "2.5"}, Way.CLOSED, Way.CLOSED),
        ({"maxweight:trailer": "3"}, Way.CLOSED, Way.OPEN),
        ({"maxweight:hgv": "44", "maxweight:trailer": "12"}, Way.CLOSED, Way.OPEN),
        ({"maxweightrating": "2.8"}, Way.CLOSED, Way.CLOSED),
        ({"maxaxleload": "10"}, Way.CLOSED, Way.OPEN),
        ({"maxweight:conditional": "3.5 @ (trailer)"}, Way.CLOSED, Way.OPEN),
        ({"hgv:conditional": "no @ (weight>7.5)"}, Way.CLOSED, Way.OPEN),
        ({"barrier": "gate"}, Way.OPEN, Way.OPEN),
        ({"barrier": "gate", "access": "no"}, Way.CLOSED, Way.CLOSED),
        ({"barrier": "gate", "locked": "yes"}, Way.CLOSED, Way.CLOSED),
        ({"barrier": "bollard"}, Way.CLOSED, Way.CLOSED),
        ({"barrier": "bollard", "motor_vehicle": "yes"}, Way.OPEN, Way.OPEN),
        ({"barrier": "bollard", "bicycle": "yes"}, Way.CLOSED, Way.CLOSED),
        ({"barrier": "height_restrictor", "maxheight": "2.2"}, Way.CLOSED, Way.CLOSED),
        ({"barrier": "toll_booth"}, Way.OPEN, Way.OPEN),
        ({"hazmat": "no"}, Way.OPEN, Way.OPEN),
    ],
)
def test_who_may_pass(tags, truck, van):
    assert way(tags) == truck
    assert way(tags, VAN) == van


@pytest.mark.parametrize(
    ("tags", "codes"),
    [
        ({"hazmat": "no"}, "BCDE"),
        ({"hazmat:water": "no"}, "BCDE"),
        ({"hazmat:adr_tunnel_cat": "B"}, "B"),
        ({"hazmat:adr_tunnel_cat": "D"}, "BCD"),
        ({"hazmat:adr_tunnel_cat": "E"}, "BCDE"),
        ({"hazmat:adr_tunnel_cat": "A"}, ""),
        ({"hazmat:C": "no"}, "BC"),
        ({"hazmat:1.3": "no"}, "BCDE"),
    ],
)
def test_dangerous_goods(tags, codes):
    closed = "".join(
        code for code in "BCDE" if way(tags, vehicle_of({"tunnel_code": code})) == Way.CLOSED
    )
    assert closed == codes
    assert way(tags) == Way.OPEN


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("3.8", "m", 3.8), ("3,8 m", "m", 3.8), ("3.8m", "m", 3.8), ("380 cm", "m", 3.8),
        ("12'6\"", "m", 3.81), ("12' 6\"", "m", 3.81), ("12'-6\"", "m", 3.81),
        ("12 ft 6 in", "m", 3.81), ("12ft6in", "m", 3.81), ("12.5 ft", "m", 3.81),
        ("12’6”", "m", 3.81), ("4;3.5", "m", 3.5), ("4 m|3.8 m", "m", 3.8),
        ("none", "m", float("inf")), ("default", "m", float("inf")),
        ("below_default", "m", 3.99), ("low", "m", None), ("", "m", None), ("0", "m", None),
        ("3.5", "t", 3.5), ("7,5 t", "t", 7.5), ("3500 kg", "t", 3.5), ("7.5t", "t", 7.5),
        ("10,000 lbs", "t", 4.536), ("20 st", "t", 18.144), ("5 tons", "t", 4.536),
        ("10 lt", "t", 10.160), ("unsigned", "t", float("inf")), ("40000", "t", None),
    ],
)  # fmt: skip
def test_what_a_limit_says(text, unit, value):
    found = read_limit(text, unit)
    assert found == (value if value is None else pytest.approx(value, abs=1e-3))


def test_the_reason_is_told_in_words():
    assert judge([{"maxheight": "3.5"}], TRUCK).reasons == (
        "max. height 3.5 m (the vehicle has 4 m)",
    )
    layers = [{"hgv": "destination"}, {"barrier": "bollard"}]
    assert judge(layers, TRUCK).reasons == ("a bollard stands there",)
    assert judge(layers[:1], TRUCK).kinds == ("hgv",)


def test_little_room_is_told_of_and_much_is_not():
    tight = judge([{"maxheight": "4.05", "maxweight": "41"}], TRUCK)
    assert tight.way == Way.OPEN
    assert [(one.key, one.limit) for one in tight.margins] == [
        ("maxheight", 4.05),
        ("maxweight", 41),
    ]
    assert judge([{"maxheight": "4.2", "maxweight": "44"}], TRUCK).margins == ()


def test_hours_that_nobody_knows_leave_the_road_open_and_are_told():
    judged = judge([{"hgv:conditional": "no @ (22:00-06:00)"}], TRUCK)
    assert (judged.way, judged.undecided) == (Way.OPEN, True)
    closed = judge([{"access": "no", "access:conditional": "yes @ (06:00-10:00)"}], TRUCK)
    assert (closed.way, closed.undecided) == (Way.CLOSED, True)


@given(st.lists(st.sampled_from(sorted(set(VALUES) - {""})), min_size=1), st.sampled_from(";,|"))
def test_a_list_is_as_strict_as_its_strictest_part(values, divider):
    assert read_value(divider.join(values)) == (max(VALUES[value] for value in values), ())


@given(st.text())
def test_what_is_not_in_the_table_is_closed_and_told(text):
    found, unknown = read_value(text)
    assert isinstance(found, Way)
    if unknown:
        assert found == Way.CLOSED


@given(st.sampled_from(sorted(LIMITS)), st.floats(0.6, 90, allow_nan=False), st.floats(0.6, 90))
def test_a_lower_limit_never_opens_a_road(key, one, other):
    low, high = sorted((one, other))
    assert way({key: f"{low:.2f}"}) >= way({key: f"{high:.2f}"})


@given(st.sampled_from(sorted(LIMITS)), st.text(max_size=12), st.sampled_from(sorted(BARRIERS)))
def test_no_text_stops_the_judging(key, text, barrier):
    for vehicle in (TRUCK, VAN, Vehicle("gas", tunnel_code="B")):
        judge([{key: text, "barrier": barrier, "access": text}], vehicle)


def test_a_network_is_judged_once_for_each_distinct_restriction():
    rows = ["", encode([{"maxheight": "3.5"}]), encode([{"hgv": "destination"}]), ""]
    net = RoadNetwork.from_edges(
        [0, 1, 2, 3], [1, 2, 3, 0], [1000.0, 2000, 3000, 4000],
        lon=[9, 9.1, 9.1, 9], lat=[45, 45, 45.1, 45.1], restriction=rows,
    )  # fmt: skip
    closures = net.attached(Closures)
    assert closures.of(TRUCK).closed.tolist() == [False, True, False, False]
    assert closures.of(TRUCK).ends.tolist() == [False, False, True, False]
    assert not closures.of(VAN).closed.any()
    assert closures.km_by_reason(TRUCK) == {"ends only: hgv": 3.0, "closed: maxheight": 2.0}
    assert closures.on(1, TRUCK).reasons == ("max. height 3.5 m (the vehicle has 4 m)",)
    assert closures.layers(2) == ({"hgv": "destination"},)
