"""Stretches cut within edges, and timetables with pauses: against sums by hand."""

import itertools
from dataclasses import replace
from datetime import datetime

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network

from platoon_osm import Trip, paper_weights, plan_joint
from platoon_osm.planning.timing.days import Day, Duty, Stand
from platoon_osm.planning.timing.schedule import schedule
from platoon_osm.planning.timing.stops import cut_plan, time_to
from platoon_osm.plans.laid_out import laid_out
from platoon_osm.plans.pauses import PausePlace

SIX = datetime(2026, 3, 2, 6)
CAFE = PausePlace("Café", "services", 9.1, 45.0)


@pytest.fixture(scope="module")
def net():
    # 0 - 1 - 2 - 3 of 10, 20 and 30 km, and 4 - 1 of 5 km; 80 km/h
    return network([0, 1, 2, 4], [1, 2, 3, 1], [10e3, 20e3, 30e3, 5e3])


def planned(net, **times):
    trips = [Trip("A", 0, 3, earliest_departure=SIX), Trip("B", 4, 3, **times)]
    plan = plan_joint(net, paper_weights(net), trips, "C", master="A", patience_min=600)
    return replace(plan, timetable=None), trips


def together(plan):
    return next(k for k, stretch in enumerate(plan.stretches) if stretch.together)


@settings(max_examples=60)
@given(
    st.lists(
        st.tuples(st.integers(0, 1), st.integers(0, 999)), min_size=1, max_size=4, unique=True
    ).filter(lambda places: (0, 0) not in places)
)
def test_pieces_of_a_cut_stretch_are_the_stretch(places):
    net = network([0, 1, 2, 4], [1, 2, 3, 1], [10e3, 20e3, 30e3, 5e3])
    plan, _ = planned(net)
    k = together(plan)
    whole = plan.stretches[k]
    cut = cut_plan(net, plan, {k: [(at, share / 1000) for at, share in places]})
    parts = [one for one in cut.stretches if one.together]
    assert len(parts) == len(places) + 1
    for name in ("length_m", "drive_s", "inferred_m"):
        assert sum(getattr(one, name) for one in parts) == pytest.approx(getattr(whole, name))
    for part in parts:
        lengths = net.length_m[list(part.edges)].copy()
        lengths[-1] *= part.span[1]
        first = net.length_m[part.edges[0]] * part.span[0]
        assert part.length_m == pytest.approx(lengths.sum() - first)
        # All drive 80 km/h.
        assert part.drive_s == pytest.approx(part.length_m / net.speed_mps[0])
    for one, after in itertools.pairwise(parts):
        ends = one.edges[-1], one.span[1]
        begins = after.edges[0], after.span[0]
        assert ends == begins or (
            (ends[1], begins[1]) == (1.0, 0.0) and net.head[ends[0]] == net.tail[begins[0]]
        )
    assert cut.joint_cost == pytest.approx(plan.joint_cost)
    drawn, below = laid_out(cut, net)
    for way, before in zip(drawn.ways, plan.ways, strict=True):
        edges = [edge for one in way for edge in drawn.stretches[one].edges]
        metres = sum(plan.stretches[one].length_m for one in before)
        assert below.length_m[edges].sum() == pytest.approx(metres)
        assert (below.head[edges[:-1]] == below.tail[edges[1:]]).all()


def test_times_to_places_add_up(net):
    plan, _ = planned(net)
    whole = plan.stretches[together(plan)]
    assert whole.edges == (1, 2)
    speed = net.speed_mps[0]
    assert time_to(net, whole, (0, 0.25)) == pytest.approx(5e3 / speed)
    assert time_to(net, whole, (1, 0.5)) == pytest.approx(35e3 / speed)


def timetable(net, days, **times):
    plan, trips = planned(net, **times)
    k = together(plan)
    plan = cut_plan(net, plan, {k: [(1, 0.5)]})
    return schedule(plan, trips, 7200.0, days)


def test_a_common_break_is_a_gap_with_its_reason(net):
    stand = Stand(2, 2700.0, ("break",), CAFE)
    table = timetable(net, [Day((stand,)), Day((stand,))])
    for times in table.vehicles:
        (pause,) = times.pauses
        assert pause.purposes == ("break",)
        assert pause.place == CAFE
        assert pause.duration_s == pytest.approx(2700.0, abs=1e-6)
        assert times.waits[2] == pytest.approx(2700.0, abs=1e-6)
    a, b = table.vehicles
    # 60 km at 80 km/h and 45 min; B leaves so as to be there.
    assert a.arrival_s - a.departure_s == pytest.approx(60e3 / net.speed_mps[0] + 2700, abs=0.01)
    assert b.departure_s == pytest.approx(5e3 / net.speed_mps[0], abs=0.01)


def test_a_break_before_merging_may_be_longer(net):
    late = {"latest_departure": SIX}
    table = timetable(net, [Day(), Day((Stand(1, 60.0, ("break",), CAFE),))], **late)
    (pause,) = table.vehicles[1].pauses
    # B drives 5 km and waits for A, who drives 10.
    assert pause.purposes == ("break", "company")
    assert pause.duration_s == pytest.approx(5e3 / net.speed_mps[0], abs=0.01)


def test_who_rests_first_leaves_later_and_bans_hold(net):
    table = timetable(net, [Day(leaves_after=2700.0), Day()])
    assert table.vehicles[0].held_s == pytest.approx(2700.0)
    until = Stand(2, 0.0, ("ban",), None, until=9000.0)
    table = timetable(net, [Day((until,)), Day((until,))])
    start = table.vehicles[0].departure_s
    # Nobody leaves earlier than needed: both come just when the ban ends.
    assert table.vehicles[0].legs[2][0] - start <= 9000.0
    assert table.vehicles[0].waiting_s < 1.0


def test_a_duty_period_is_kept_even_if_others_wait(net):
    speed = net.speed_mps[0]
    drive = 60e3 / speed
    stand = Stand(2, 2700.0, ("break",), CAFE)
    duty = Duty(0, 2, drive + 2700.0)
    early = {"latest_departure": SIX}
    table = timetable(net, [Day((stand,), duties=(duty,)), Day((stand,))], **early)
    a = table.vehicles[0]
    assert a.legs[-1][1] - a.legs[0][0] <= drive + 2700.0 + 1e-3


def test_the_timetable_of_pauses_is_the_least(net):
    """Against all departures on a grid, with a break before the merging point and one after."""
    speed = net.speed_mps[0]
    rng = np.random.default_rng(3)
    for _ in range(12):
        mine, common = rng.integers(0, 40, 2) * 60.0
        window = int(rng.integers(0, 30)) * 60.0
        days = [
            Day((Stand(2, common, ("break",), CAFE),)),
            Day((Stand(1, mine, ("break",), CAFE), Stand(2, common, ("break",), CAFE))),
        ]
        by = {"latest_departure": datetime.fromtimestamp(SIX.timestamp() + window)}
        table = timetable(net, days, **by)
        meets = lambda a: a + 10e3 / speed  # noqa: E731 (short beside its use)
        best = min(
            (max(meets(a), b + 5e3 / speed + mine) - a - 10e3 / speed)
            + (max(meets(a), b + 5e3 / speed + mine) - b - 5e3 / speed)
            for a in np.arange(0, 3600, 60.0)
            for b in np.arange(-3600, window + 1, 60.0)
        )
        waits = sum(times.waits[1] for times in table.vehicles)
        assert waits <= best + 60.0 + 1e-6
