"""Drivers who are over a limit before they begin: they rest first, or are told what is too much."""

import math
from dataclasses import replace
from datetime import datetime

import numpy as np
import pytest
from bundled import italy

import platoon_osm as po
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.driving.limits import Limits
from platoon_osm.driving.rules import Rules
from platoon_osm.errors import NoLegalTripError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.texts import TextTable

WEDNESDAY = datetime(2026, 3, 4, 6)


def plan(rules="eu561", *, named="earliest_departure", company=False, **state):
    net = italy()
    trips = [po.Trip("A", "Milano", "Bologna", driver=state, **{named: WEDNESDAY})]
    if company:
        trips.append(po.Trip("B", "Torino", "Bologna", earliest_departure=WEDNESDAY))
    return po.plan_joint(net, po.paper_weights(net), trips, rules=rules)


def leaves_h(made):
    own = made.timetable.vehicles[0]
    return (own.departure_s - own.earliest_departure_s) / 3600


RESTS_FIRST = [
    # rules, what it has behind it, hours of rest at the origin; Monday 0:00 is 114 h later
    ("eu561", {"driven_since_break_h": 5, "driven_today_h": 5}, 0.75),
    ("eu561", {"driven_since_break_h": 5, "driven_today_h": 5, "first_part_taken": True}, 0.5),
    ("eu561", {"driven_today_h": 9.5}, 9),
    ("eu561", {"driven_today_h": 9.5, "long_days_used": 2}, 9),
    ("eu561", {"driven_today_h": 10.5}, 9),
    ("eu561", {"driven_today_h": 10.5, "reduced_rests_used": 3}, 11),
    ("eu561", {"driven_today_h": 12, "duty_h": 14}, 9),
    ("eu561", {"driven_today_h": 5, "duty_h": 15}, 9),
    ("eu561", {"driven_this_week_h": 57}, 114),
    ("eu561", {"driven_this_week_h": 40, "driven_last_week_h": 51}, 114),
    ("eu561", {"driven_last_week_h": 91}, 114),
    ("eu561", {"since_weekly_rest_h": 144}, 45),
    ("eu561", {"driven_since_break_h": 5, "driven_today_h": 5, "drivers": 2}, 0.75),
    ("eu561", {"driven_today_h": 10.5, "drivers": 2}, 9),
    ("eu561", {"driven_today_h": 9.5, "long_days_used": 2, "drivers": 2}, 9),
    ("eu561", {"driven_this_week_h": 57, "drivers": 2}, 114),
    ("us395", {"driven_since_break_h": 8.5, "driven_today_h": 8.5}, 10),
    ("us395", {"driven_today_h": 11.5}, 10),
    ("us395", {"driven_today_h": 5, "duty_h": 14.5}, 10),
    ("us395", {"driven_today_h": 15, "duty_h": 20}, 10),
    ("us395", {"driven_this_week_h": 71}, 34),
]


@pytest.mark.parametrize(("rules", "state", "rests_h"), RESTS_FIRST, ids=str)
def test_a_rest_at_the_origin_comes_first_where_it_mends_it(rules, state, rests_h):
    made = plan(rules, **state)
    assert leaves_h(made) == pytest.approx(rests_h)
    assert po.inspect_plan(made) == []


@pytest.mark.parametrize(("rules", "state", "rests_h"), RESTS_FIRST[3:6], ids=str)
def test_so_it_does_in_company(rules, state, rests_h):
    made = plan(rules, company=True, **state)
    assert leaves_h(made) >= rests_h - 1e-6
    assert po.inspect_plan(made) == []


TOO_LATE = [
    ({"duty_h": 15.5, "driven_today_h": 5}, "daily rest of its driver ended 15 h 30 min before",
     "the next has to begin within 15 h 00 min"),
    ({"duty_h": 14, "reduced_rests_used": 3}, "daily rest of its driver ended 14 h 00 min before",
     "the next has to begin within 13 h 00 min"),
    ({"duty_h": 22, "drivers": 2}, "daily rest of its driver ended 22 h 00 min before",
     "the next has to begin within 21 h 00 min"),
    ({"since_weekly_rest_h": 145}, "weekly rest of its driver ended 145 h 00 min before",
     "the next has to begin within 144 h 00 min"),
]  # fmt: skip


@pytest.mark.parametrize("named", ["earliest_departure", "latest_arrival", "latest_departure"])
@pytest.mark.parametrize(("state", "ended", "begins"), TOO_LATE, ids=str)
def test_a_rest_that_had_to_begin_before_is_told(state, ended, begins, named):
    with pytest.raises(NoLegalTripError) as refused:
        plan(named=named, **state)
    said = str(refused.value)
    assert said.startswith("A: no trip keeps the driving rules 'eu561': the last ")
    assert ended in said
    assert begins in said
    # To leave later makes it no better: that rest is late already.
    assert said.endswith("; let it rest before, and give its state after that")
    assert "\n" not in said


@pytest.mark.parametrize(
    ("rules", "state", "told"),
    [
        ("eu561", {"driven_since_break_h": 5, "driven_today_h": 5},
         "its driver has driven 5 h 00 min since its last break, 4 h 30 min allowed"),
        ("eu561", {"driven_today_h": 10},
         "its driver has driven 10 h 00 min since its last daily rest, 10 h 00 min allowed"),
        ("eu561", {"driven_today_h": 9.5, "long_days_used": 2},
         "its driver has driven 9 h 30 min since its last daily rest, 9 h 00 min allowed"),
        ("eu561", {"driven_this_week_h": 57},
         "its driver has driven 57 h 00 min this week, 56 h 00 min allowed"),
        ("eu561", {"driven_last_week_h": 51, "driven_this_week_h": 40, "drivers": 2},
         "its driver has driven 91 h 00 min this week and last, 90 h 00 min allowed"),
        ("eu561", {"since_weekly_rest_h": 144},
         "the last weekly rest of its driver ended 144 h 00 min before the trip, and the next has "
         "to begin within 144 h 00 min"),
        ("eu561", {"duty_h": 14.98, "driven_today_h": 1},
         "after what its driver did before, it comes no farther than A1/A51 Milano (its km 0)"),
        ("us395", {"duty_h": 14.5, "driven_today_h": 1},
         "the last daily rest of its driver ended 14 h 30 min before the trip, and nothing may be "
         "driven after 14 h 00 min"),
        ("us395", {"driven_this_week_h": 71},
         "its driver has driven 71 h 00 min this week, 70 h 00 min allowed"),
    ],
)  # fmt: skip
def test_who_may_not_rest_at_the_origin_is_told_what_is_too_much(rules, state, told):
    """A state that holds whenever the vehicle leaves is one that it leaves with."""
    with pytest.raises(NoLegalTripError) as refused:
        plan(rules, named="latest_arrival", **state)
    assert str(refused.value) == (
        f"A: no trip keeps the driving rules '{rules}': {told}; give an earliest departure, from "
        "which on it rests, or let it rest before, and give its state after that"
    )


@pytest.mark.parametrize(
    ("rules", "state"),
    [
        ("eu561", {"driven_last_week_h": 57}), ("eu561", {"long_days_used": 3}),
        ("eu561", {"reduced_rests_used": 4}), ("us395", {"driven_last_week_h": 100}),
        ("us395", {"since_weekly_rest_h": 300}), ("us395", {"long_days_used": 7}),
        ("eu561", {"duty_h": 15.5, "drivers": 2}),
    ],
)  # fmt: skip
def test_what_binds_nothing_that_follows_is_no_reason_to_wait(rules, state):
    made = plan(rules, **state)
    assert leaves_h(made) == 0
    assert po.inspect_plan(made) == []


def long_road(hours, names=("Start", "Fork", "End")):
    """Return a road with a junction after an hour, and then one edge of so many hours."""
    texts = TextTable.from_strings(["", *names, "A9"])
    length_m = np.array([1.0, hours, 1.0, 1.0]) * 3600 * 20.0
    # From the fork another road leads off, so that trucks may leave there.
    return RoadNetwork.from_edges(
        [0, 1, 1, 3], [1, 2, 3, 1], length_m, lon=[9.0, 9.5, 12.0, 9.6],
        lat=[45.0, 45.0, 45.0, 45.3], speed_mps=20.0, texts=texts, node_name=[1, 2, 3, 0],
        node_ref=[0] * 4, ref=[4, 4, 0, 0], name=[0] * 4,
    )  # fmt: skip


def drive_along(net, rules, drivers=1):
    cost = net.length_m
    trip = po.Trip("A", 0, 2, earliest_departure=WEDNESDAY, driver={"drivers": drivers})
    return po.plan_joint(net, EdgeWeights(cost, cost, cost, "m", {}), [trip], rules=rules)


@pytest.mark.parametrize(
    ("rules", "drivers", "hours", "told"),
    [
        ("eu561", 1, 5, "5 h 00 min with no place to stop, and 4 h 30 min"),
        ("eu561", 2, 5, "5 h 00 min with no place to stop, and 4 h 30 min"),
        ("us395", 1, 8.5, "8 h 30 min with no place to stop, and 8 h 00 min"),
    ],
)  # fmt: skip
def test_a_road_too_long_to_be_driven_at_a_stretch_is_told(rules, drivers, hours, told):
    net = long_road(hours)
    with pytest.raises(NoLegalTripError) as refused:
        drive_along(net, rules, drivers)
    assert str(refused.value) == (
        f"A: no trip keeps the driving rules '{rules}': A9 from Fork (its km 72) to End (its km "
        f"{72 + 72 * hours:.0f}) takes {told} may be driven without a break; give a map with a "
        "truck parking there, or close that road, for another way"
    )
    # Half an hour less, which is allowed to the second, and it is driven.
    assert po.inspect_plan(drive_along(long_road(hours - 0.5), rules, drivers)) == []


def test_what_two_drivers_could_do_is_told():
    """Days of 3 h, no rest long enough: each of two may drive 3 h, and both together all."""
    alone = Limits(day_s=3 * 3600.0, long_day_s=3 * 3600.0, rest_s=math.inf)
    team = replace(alone, day_s=6 * 3600.0, long_day_s=6 * 3600.0, change_s=300.0, break_s=300.0)
    net = long_road(2.5)
    with pytest.raises(NoLegalTripError, match=r"one driver comes no farther than Fork \(its km"):
        drive_along(net, Rules("ours", "", alone, team))
    with pytest.raises(NoLegalTripError, match=r"no farther than Fork \(its km 72\), where it can"):
        drive_along(net, Rules("ours", "", alone))
