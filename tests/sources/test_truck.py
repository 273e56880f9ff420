"""What a heavy vehicle reads in the tags of a road."""

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.errors import ScenarioError
from platoon_osm.network.restrictions import decode
from platoon_osm.sources.restricting_tags import LIMITED_FOR
from platoon_osm.sources.truck import (
    BACKWARD,
    BOTH,
    FORWARD,
    TruckRules,
    is_driving_tag,
    read_way,
)
from platoon_osm.vehicles.access import Way, read_value
from platoon_osm.vehicles.judgement import judge
from platoon_osm.vehicles.limits import LIMITS, read_limit
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE as TRUCK
from platoon_osm.vehicles.profile import VEHICLES

MPH, KNOT = 1.609344, 1.852
FREE = TruckRules(limiter_kmh=150)
DEFAULTED = "speed defaulted from road class"
ODD_SPEED = "maxspeed not understood"
CAPPED = "speed capped for trucks"
ONE_WAY = "direction defaulted to one-way (motorway without oneway)"


def way(rules=FREE, **tags):
    """Read a two-way primary road with some tags; "__" stands for ":" in a key."""
    named = {key.replace("__", ":"): value for key, value in tags.items()}
    return read_way({"highway": "primary", **named}, rules)


@pytest.mark.parametrize(
    ("highway", "kmh"),
    [
        ("motorway", 120), ("trunk", 90), ("primary", 70), ("secondary", 60), ("tertiary", 50),
        ("motorway_link", 50), ("primary_link", 50), ("unclassified", 40), ("", 40),
    ],
)  # fmt: skip
def test_speed_from_the_class_is_counted(highway, kmh):
    reading = read_way({"highway": highway, "oneway": "yes"}, FREE)
    assert reading.speed_kmh == kmh
    assert reading.remarks == (DEFAULTED,)


@pytest.mark.parametrize(
    ("tags", "kmh", "remarks"),
    [
        # Trucks over 12 t: 80 on motorways of Italy, 70 elsewhere out of town.
        ({"maxspeed": "100"}, 70, (CAPPED,)),
        ({"maxspeed": "80"}, 70, (CAPPED,)),
        ({"maxspeed": "60"}, 60, ()),
        ({"maxspeed": "none"}, 70, (CAPPED,)),
        ({"maxspeed": "IT:rural"}, 70, (CAPPED,)),
        ({"maxspeed": "IT:urban"}, 50, ()),
        ({"maxspeed": "IT:motorway"}, 80, (CAPPED,)),
        ({"highway": "motorway", "maxspeed": "100"}, 80, (CAPPED,)),
        ({"highway": "motorway_link", "maxspeed": "100"}, 80, (CAPPED,)),
        # A sign for trucks stands above the country's rule, but not above the limiter.
        ({"maxspeed": "130", "maxspeed:hgv": "85"}, 85, ()),
        ({"maxspeed": "130", "maxspeed:hgv": "100"}, 90, (CAPPED,)),
        ({"maxspeed": "130", "maxspeed:hgv": "60"}, 60, ()),
        ({"maxspeed": "50", "maxspeed:hgv": "70"}, 70, ()),
        ({"maxspeed": "60", "maxspeed:hgv": "?"}, 60, (ODD_SPEED,)),
        ({"maxspeed:hgv": "?"}, 70, (ODD_SPEED, DEFAULTED)),
        ({"maxspeed": "fast"}, 70, (ODD_SPEED, DEFAULTED)),
        ({"maxspeed:forward": "40", "maxspeed": "60"}, 40, ()),
        ({"maxspeed:forward": "?", "maxspeed": "60"}, 60, (ODD_SPEED,)),
        ({"maxspeed:hgv:forward": "30", "maxspeed:hgv": "60"}, 30, ()),
        ({"maxspeed:backward": "40", "maxspeed": "60"}, 60, ()),
    ],
)
def test_which_tag_decides_and_what_caps_it(tags, kmh, remarks):
    reading = read_way({"highway": "primary", "oneway": "yes", **tags}, TruckRules("IT"))
    assert reading.speed_kmh == pytest.approx(kmh)
    assert reading.remarks == remarks
    assert reading.backward_kmh == reading.speed_kmh


@pytest.mark.parametrize(
    ("tags", "forward", "backward"),
    [
        ({"maxspeed": "60"}, 60, 60),
        ({"maxspeed": "60", "maxspeed:backward": "40"}, 60, 40),
        ({"maxspeed:forward": "50", "maxspeed:backward": "40"}, 50, 40),
        ({"maxspeed:forward": "50", "maxspeed": "60"}, 50, 60),
        ({"maxspeed": "60", "maxspeed:hgv:backward": "30"}, 60, 30),
        ({"maxspeed": "60", "maxspeed:backward": "?"}, 60, 60),
        ({"maxspeed": "60", "maxspeed:backward": "none"}, 60, 70),
        ({"maxspeed:backward": "45"}, 70, 45),
    ],
)
def test_each_direction_of_a_two_way_road_has_its_own_limit(tags, forward, backward):
    reading = way(TruckRules("IT"), **tags)
    assert reading.direction == BOTH
    assert (reading.speed_kmh, reading.backward_kmh) == (forward, backward)


def test_a_remark_about_either_direction_counts_once_for_the_way():
    reading = way(maxspeed="fast", maxspeed__backward="slow")
    assert sorted(reading.remarks) == [ODD_SPEED, DEFAULTED]
    assert way(maxspeed="60", maxspeed__backward="slow").remarks == (ODD_SPEED,)


def test_against_the_way_the_backward_limit_counts():
    reading = way(oneway="-1", maxspeed="60", maxspeed__backward="40", maxspeed__forward="50")
    assert (reading.direction, reading.speed_kmh) == (BACKWARD, 40)


@pytest.mark.parametrize(
    ("tags", "direction"),
    [
        ({"oneway": "yes"}, FORWARD), ({"oneway": "true"}, FORWARD), ({"oneway": "1"}, FORWARD),
        ({"oneway": " YES "}, FORWARD),
        ({"oneway": "-1"}, BACKWARD), ({"oneway": "reverse"}, BACKWARD),
        ({"oneway": "no"}, BOTH), ({"oneway": "false"}, BOTH), ({"oneway": "0"}, BOTH), ({}, BOTH),
        ({"junction": "roundabout"}, FORWARD), ({"junction": "circular"}, FORWARD),
        ({"junction": "roundabout", "oneway": "-1"}, BACKWARD),
        ({"highway": "motorway", "oneway": "no"}, BOTH),
        ({"highway": "motorway", "oneway": "-1"}, BACKWARD),
    ],
)  # fmt: skip
def test_direction(tags, direction):
    reading = way(maxspeed="50", **tags)
    assert reading.direction == direction
    assert reading.remarks == ()


@pytest.mark.parametrize("highway", ["motorway", "motorway_link"])
def test_a_motorway_without_oneway_is_one_way_and_counted(highway):
    reading = way(highway=highway, maxspeed="50")
    assert (reading.direction, reading.remarks) == (FORWARD, (ONE_WAY,))


def test_a_direction_nobody_understands_is_counted():
    assert way(oneway="perhaps", maxspeed="50").remarks == ("oneway not understood",)


@pytest.mark.parametrize("value", ["reversible", "alternating", "Reversible"])
def test_a_carriageway_that_changes_its_direction_is_closed_but_at_known_hours(value):
    reading = way(highway="motorway", oneway=value, maxspeed="50")
    assert not reading.allowed
    assert reading.remarks == (
        "carriageways that change their direction, closed but at known hours",
    )
    known = way(
        oneway=value, oneway__conditional="yes @ (Mo-Fr 05:00-11:00); -1 @ (Mo-Fr 12:00-20:00)"
    )
    assert known.direction == BOTH
    (layer,), (back,) = decode(known.restriction), decode(known.backward_restriction)
    morning, evening = datetime(2026, 3, 2, 8), datetime(2026, 3, 2, 15)
    for one, opens in ((layer, (True, False)), (back, (False, True))):
        found = tuple(judge([one], TRUCK, at).way == Way.OPEN for at in (morning, evening))
        assert found == opens
        assert judge([one], TRUCK).way == Way.CLOSED


@pytest.mark.parametrize(
    ("tags", "forward", "backward"),
    [
        # who may drive along and against: t(ruck), v(an)
        ({"oneway": "yes", "oneway:hgv": "no"}, "tv", "t"),
        ({"oneway": "no", "oneway:hgv": "yes"}, "tv", "v"),
        ({"oneway": "yes", "oneway:motor_vehicle": "no"}, "tv", "tv"),
        ({"oneway": "yes", "oneway:bicycle": "no"}, "tv", ""),
        ({"hgv:forward": "no"}, "v", "tv"),
        ({"hgv": "no", "hgv:backward": "yes"}, "v", "tv"),
        ({"access:backward": "no"}, "tv", ""),
        ({"maxheight:forward": "3.5"}, "v", "tv"),
        ({"maxweight:backward": "7.5", "maxweight": "44"}, "tv", "v"),
        ({"maxweight:hgv:forward": "7.5"}, "v", "tv"),
        ({"hgv:forward:conditional": "no @ (weight>7.5)"}, "v", "tv"),
        ({"oneway": "-1", "hgv:forward": "no"}, "", "tv"),
        ({"hgv:lanes": "no|yes"}, "tv", "tv"),
        ({"hgv:lanes": "no|no"}, "v", "v"),
        ({"hgv:lanes": "no|"}, "tv", "tv"),
        ({"access:lanes:forward": "no|no"}, "", "tv"),
        ({"oneway": "yes", "oneway:conditional": "no @ (weight>7.5)"}, "tv", "t"),
        ({"oneway:conditional": "yes @ (weight>7.5)"}, "tv", "v"),
    ],
)
def test_each_direction_is_read_by_itself(tags, forward, backward):
    reading = read_way({"highway": "primary", "maxspeed": "50", **tags}, FREE)
    texts = {
        FORWARD: (reading.restriction, None),
        BACKWARD: (None, reading.restriction),
        BOTH: (reading.restriction, reading.backward_restriction),
    }[reading.direction]
    for text, expected in zip(texts, (forward, backward), strict=True):
        found = (
            ""
            if text is None
            else "".join(
                letter
                for letter, vehicle in (("t", TRUCK), ("v", VEHICLES["van-3.5t"]))
                if judge(decode(text), vehicle).way == Way.OPEN
            )
        )
        assert found == expected


@pytest.mark.parametrize(
    "key",
    ["maxbogieweight", "maxaxles", "hgv:minaxles", "maxweight:bridge", "access:bdouble",
     "vehicle:weird", "vehicle:emergency", "oneway:tram"],
)  # fmt: skip
def test_what_sounds_like_a_restriction_and_is_not_read_is_counted(key):
    remarks = way(**{key: "9", "maxspeed": "50"}).remarks
    assert f"restrictions not read: {key}" in remarks
    assert is_driving_tag(key)


NAMES = st.sampled_from(
    ["hgv", "goods", "motor_vehicle", "vehicle", "access", "hazmat", "trailer", "hov", "bus",
     "maxheight", "maxweight", "maxwidth", "maxlength", "maxaxleload", "maxweightrating",
     "maxbogieweight", "hgv_articulated", "oneway"]
)  # fmt: skip
TAILS = st.sampled_from(
    ["", ":hgv", ":forward", ":backward", ":lanes", ":conditional", ":physical", ":goods",
     ":hgv:forward", ":forward:conditional", ":water", ":x", "_y", ":bus"]
)  # fmt: skip


@given(NAMES, TAILS, st.text(max_size=8) | st.sampled_from(["no", "yes", "3.5", "no @ (Su)"]))
def test_no_such_tag_is_passed_over_in_silence(name, tail, value):
    plain = way(maxspeed="50")
    reading = read_way({"highway": "primary", "maxspeed": "50", name + tail: value}, FREE)
    changed = reading != plain
    opens = read_value(value)[0] == Way.OPEN or not value.strip()
    harmless = opens or read_limit(value, "m") == float("inf") or name in ("hov", "bus", "oneway")
    lane_free = tail == ":lanes" and not all(part.strip() for part in value.split("|"))
    assert changed or harmless or lane_free


@pytest.mark.parametrize("limit", LIMITS)
@pytest.mark.parametrize("whom", ["", *(f":{one}" for one in sorted(LIMITED_FOR))])
def test_every_limit_that_is_kept_is_judged(limit, whom):
    reading = way(**{limit + whom: "0.6"})
    assert judge(decode(reading.restriction), TRUCK).way == Way.CLOSED


@pytest.mark.parametrize(
    ("tags", "restriction"),
    [
        ({}, ""),
        ({"hgv": "yes"}, ""),
        ({"hgv": "designated"}, ""),
        ({"hgv": "no"}, "hgv=no"),
        ({"hgv": " No "}, "hgv=No"),
        ({"access": "private"}, "access=private"),
        ({"access": "yes"}, ""),
        ({"motor_vehicle": "permissive"}, ""),
        # The tag that is about trucks decides before those about all.
        ({"access": "no", "hgv": "yes"}, "access=no hgv=yes"),
        ({"access": "yes", "hgv": "no"}, "access=yes hgv=no"),
        ({"hgv:conditional": "no @ (22:00-06:00)"}, "hgv:conditional=no%20@%20(22:00-06:00)"),
        ({"maxheight": "3.5", "name": "Via Roma"}, "maxheight=3.5"),
        ({"maxheight": "default"}, ""),
        ({"hov:lanes": "designated||"}, ""),
        ({"hov:lanes": "designated|yes|yes"}, ""),
        ({"lanes:bus": "1", "lanes": "3"}, ""),
        ({"hgv:national_network": "yes"}, ""),
        ({"hazmat:1.1": "no"}, "hazmat:1.1=no"),
    ],
)
def test_what_is_restricted_is_kept(tags, restriction):
    reading = way(**tags)
    assert reading.allowed
    assert (reading.restriction, reading.backward_restriction) == (restriction, restriction)


@pytest.mark.parametrize(
    ("tags", "closed_by"),
    [
        ({"access": "no"}, "access"),
        ({"motor_vehicle": "no"}, "motor_vehicle"),
        ({"vehicle": "no"}, "vehicle"),
        ({"motor_vehicle": "agricultural"}, "motor_vehicle"),
        ({"vehicle": "yes", "motor_vehicle": "no"}, "motor_vehicle"),
        ({"hgv": "no", "goods": "no"}, "hgv, goods"),
        ({"hov": "only"}, "hov"),
        ({"hov:lanes": "designated|designated"}, "hov"),
        ({"access": "psv"}, "access"),
    ],
)
def test_a_road_that_nobody_we_plan_for_may_drive_is_none(tags, closed_by):
    reading = way(**tags)
    assert (reading.allowed, reading.closed_by) == (False, closed_by)


@pytest.mark.parametrize(
    ("tags", "toll"),
    [
        ({}, False),
        ({"toll": "yes"}, True),
        ({"toll": "no"}, False),
        ({"toll": " NO "}, False),
        ({"toll": "no", "toll:hgv": "yes"}, True),
        ({"toll": "yes", "toll:hgv": "no"}, False),
        ({"toll": "no", "toll:N3": "yes"}, True),
        ({"toll:N3": "no", "toll:hgv": "yes"}, True),
        ({"toll": "hgv"}, True),
    ],
)
def test_toll(tags, toll):
    assert way(**tags).toll is toll


def test_conditions_are_kept_for_the_vehicle_that_asks():
    reading = way(
        maxspeed="60", maxspeed__conditional="40 @ wet", hgv__conditional="no @ (Su)",
        access__conditional="no @ winter",
    )  # fmt: skip
    assert reading.speed_kmh == 60
    assert reading.allowed
    assert "hgv:conditional" in reading.restriction
    assert set(reading.remarks) == {
        "speed limits at some hours or in some weather, not judged",
        "restrictions read: hgv:conditional", "restrictions read: access:conditional",
    }  # fmt: skip


def test_a_speed_limit_for_heavy_vehicles_is_that_of_a_truck_and_not_of_a_van():
    reading = way(maxspeed="100", maxspeed__conditional="60 @ (weight>7.5)")
    assert (reading.speed_kmh, reading.posted_kmh) == (60, 100)


def test_the_tags_that_are_read_are_those_that_are_asked_for():
    for key in ("highway", "oneway", "hgv", "toll:N3", "maxspeed:hgv:backward", "x:conditional",
                "source:maxspeed", "maxspeed:type", "zone:traffic", "motorroad"):  # fmt: skip
        assert is_driving_tag(key)
    for key in ("name", "ref", "surface", "min_speed", "source:name"):
        assert not is_driving_tag(key)


@pytest.mark.parametrize(
    ("country", "kmh"),
    [("IT", 80), ("DE", 80), ("AT", 80), ("NL", 80), ("FR", 90), ("BE", 90), ("US-CA", 55 * MPH),
     (None, 90)],
)  # fmt: skip
def test_country_caps(country, kmh):
    rules = TruckRules(country)
    assert rules.cap_kmh == pytest.approx(kmh)
    assert way(rules, highway="motorway", maxspeed="120").speed_kmh == pytest.approx(kmh)


def test_the_limiter_caps_what_the_country_allows():
    assert TruckRules("FR", 85).cap_kmh == 85
    assert TruckRules("IT", 85).cap_kmh == 80
    assert TruckRules(limiter_kmh=70).cap_kmh == 70


@pytest.mark.parametrize(
    ("country", "limiter", "said"),
    [
        ("XX", 90, "country 'XX' has no truck limit here; use AL, AT"),
        ("ita", 90, "country 'ita'"),
        (["IT"], 90, "country ['IT']"),
        (None, 0, "limiter_kmh 0: a speed limiter lies between 3 and 150 km/h"),
        (None, -90, "limiter_kmh -90"),
        (None, float("nan"), "limiter_kmh nan"),
        (None, float("inf"), "limiter_kmh inf"),
        (None, "90", "limiter_kmh '90'"),
    ],
)
def test_rules_that_cannot_be(country, limiter, said):
    with pytest.raises(ScenarioError) as caught:
        TruckRules(country, limiter)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
