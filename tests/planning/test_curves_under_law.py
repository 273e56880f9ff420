"""The curve and the frontier under driving rules: each value is that of a plan asked for alone."""

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from bundled import italy
from hypothesis import given, settings
from small_law import SMALL
from test_timed_star import DAY, Costs, asked_of, problems

import platoon_osm as po
from platoon_osm.driving.rules import Rules
from platoon_osm.errors import NoLegalTripError
from platoon_osm.inspection.rule_sets import RULE_SETS
from platoon_osm.planning.curves import _legal, _question
from platoon_osm.planning.legal import legal_curves

FEW = Rules("few", "a law of few seconds", SMALL)
SIX = datetime(2026, 3, 2, 6)
PLACES = ["Milano", "Torino", "Venezia", "Brescia", "Roma", "Bologna", "Genova", "Verona"]


@pytest.fixture(scope="module", autouse=True)
def unchecked():
    """The checker of plans knows no law of few seconds; what it forbids is tested elsewhere."""
    RULE_SETS["few"] = replace(RULE_SETS["none"], name="few")
    yield
    del RULE_SETS["few"]


def leaving(problem, master, at, arrival):
    """The problem with a master that leaves at a moment, and may arrive until another."""
    trips = [
        replace(
            trip,
            earliest_departure=at,
            latest_departure=at,
            latest_arrival=arrival,
            flexibility_min=None,
        )
        if trip.vehicle == master
        else trip
        for trip in problem.trips
    ]
    return replace(problem, trips=trips, master=master, case="C", company="master")


def compare(problem, curve, moments, arrival):
    """Compare a curve with plans; return at how many departures there is a plan."""
    met = 0
    for at in moments:
        moment = curve.clock.moment(at).replace(tzinfo=None)
        plan = po.plan_joint(leaving(problem, curve.master, moment, arrival))
        (told,) = curve.cost_at(at)
        times = plan.timetable.vehicles[[one.vehicle for one in plan.trips].index(curve.master)]
        if not np.isfinite(told):
            # It cannot leave then: alone it is late, or rests before it leaves.
            assert times.late_s > 0 or times.departure_s > at - float(curve.begin_s[0])
            continue
        assert plan.joint_cost <= told * (1 + 1e-9)
        if all(len(runs) < 2 for runs in shared(plan)):
            assert plan.joint_cost == pytest.approx(told)
            joined = {plan.trips[k].vehicle for k, runs in enumerate(shared(plan)) if runs}
            assert set(curve.company_at(at)) == joined - {curve.master}
        met += 1
    return met


def shared(plan):
    """For each vehicle the unbroken parts of its way that it drives in company."""
    found = []
    for way in plan.ways:
        runs, before = [], False
        for k in way:
            now = len(plan.stretches[k].vehicles) > 1
            if now and not before:
                runs.append(k)
            before = now
        found.append(runs)
    return found


@pytest.mark.parametrize("seed", range(3))
def test_each_departure_costs_what_a_plan_of_it_costs(seed):
    rng = np.random.default_rng(seed)
    net = italy()
    trips = []
    for k in range(3):
        start, end = rng.choice(PLACES, 2, replace=False)
        first = SIX + timedelta(minutes=int(rng.integers(0, 90)))
        trips.append(po.Trip(f"v{k}", str(start), str(end), first,
                             flexibility_min=float(rng.integers(60, 240))))  # fmt: skip
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561", master="v0")
    curve = po.departure_curve(problem)
    assert curve.is_exact
    assert curve.rules == "eu561"
    assert (curve.begin_s[1:] > curve.end_s[:-1]).all()
    legal = _legal(_question(problem, "curve", None))
    arrival = legal.first + timedelta(seconds=legal.spans[0].arrival_s)
    edges = {float(at) for at in (*curve.begin_s, *curve.end_s, curve.best_s)}
    moments = sorted(edges)[:: max(1, len(edges) // 8)]
    assert compare(problem, curve, moments, arrival) == len(moments)
    assert curve.best_cost == pytest.approx(curve.cost.min())
    assert curve.cost_at(curve.best_s)[0] == pytest.approx(curve.best_cost)


@given(problem=problems())
@settings(max_examples=15)
def test_small_roads_under_a_law_of_few_seconds(problem):
    net, costs, rows = problem
    costs = Costs(costs.solo, costs.platoon, costs.solo)  # equal costs may gain a master unlike
    asked = asked_of((net, costs, rows))
    problem = replace(asked.question.problem, rules=FEW)
    try:
        curve = po.departure_curve(problem)
    except NoLegalTripError:
        return
    legal = _legal(_question(problem, "curve", None))
    arrival = legal.first + timedelta(seconds=legal.spans[0].arrival_s)
    moments = np.arange(curve.begin_s[0], curve.end_s[-1] + 1)
    compare(problem, curve, moments.tolist(), arrival)


@pytest.mark.parametrize("seed", range(2))
def test_each_delay_saves_what_a_plan_with_such_windows_saves(seed):
    rng = np.random.default_rng(100 + seed)
    net = italy()
    trips = []
    for k in range(3):
        start, end = rng.choice(PLACES, 2, replace=False)
        first = SIX + timedelta(minutes=int(rng.integers(0, 90)))
        trips.append(po.Trip(f"v{k}", str(start), str(end), first))
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561", company="master")
    delays = (0.0, 20.0, 75.0, 180.0)
    frontier = po.delay_frontier(problem, delays)
    assert (np.diff(frontier.saving) >= 0).all()
    assert (frontier.bound <= frontier.cost).all()
    least = np.inf
    for delay, cost, bound in zip(delays, frontier.cost, frontier.bound, strict=True):
        alone = [po.plan_joint(replace(problem, trips=[trip])) for trip in trips]
        late = [
            replace(
                trip,
                latest_arrival=datetime.fromisoformat(one.timetable.start)
                + timedelta(seconds=one.timetable.vehicles[0].arrival_s, minutes=delay),
            )
            for trip, one in zip(trips, alone, strict=True)
        ]
        plan = po.plan_joint(replace(problem, trips=late, case="C"))
        least = min(least, plan.joint_cost)
        assert cost == pytest.approx(least)
        assert bound <= plan.joint_cost * (1 + 1e-9)


def test_rules_may_be_named_beside_a_problem():
    net = italy()
    trips = [po.Trip(name, name, "Bologna", SIX) for name in ("Milano", "Brescia")]
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561")
    free = po.departure_curve(problem, "Milano", rules="none")
    assert free.rules == ""
    assert free.cost_at(0.5).size == 1
    assert po.departure_curve(replace(problem, rules="none"), "Milano", rules="eu561").rules
    assert po.delay_frontier(problem, [30], rules="none").rules == ""
    assert "driving rules eu561" in po.delay_frontier(problem, [30]).conditions
    with pytest.raises(po.ScenarioError, match="rules"):
        po.departure_curve(problem, rules="bogus")


def test_where_the_search_ends_by_its_count_there_is_a_bound(monkeypatch, tmp_path):
    monkeypatch.setattr(legal_curves, "CURVE_SPANS", 1)
    net = italy()
    trips = [
        po.Trip(name, name, "Roma", SIX, flexibility_min=120)
        for name in ("Milano", "Torino", "Brescia")
    ]
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561")
    curve = po.departure_curve(problem, "Milano")
    assert not curve.is_exact
    assert "the search ended before all was compared" in curve.conditions
    assert (curve.bound <= curve.cost).all()
    assert (curve.bound < curve.cost).any()
    curve.write_csv(tmp_path / "curve.csv")
    assert "bound_m_eq" in (tmp_path / "curve.csv").read_text()
    monkeypatch.undo()
    whole = po.departure_curve(problem, "Milano")
    for at, cost, bound in zip(curve.begin_s, curve.cost, curve.bound, strict=True):
        assert bound * (1 - 1e-9) <= whole.cost_at(at)[0] <= cost * (1 + 1e-9)


def test_where_delays_have_used_up_their_count_shorter_ones_speak_for_longer(monkeypatch):
    net = italy()
    trips = [po.Trip(name, name, "Roma", SIX) for name in ("Milano", "Torino", "Brescia")]
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561")
    whole = po.delay_frontier(problem, (15, 60, 90))
    monkeypatch.setattr(legal_curves, "FRONTIER_SPANS", 50)
    cut = po.delay_frontier(problem, (15, 60, 90))
    assert cut.gap[-1] > 0
    assert cut.cost[-1] == cut.cost[-2]
    assert (cut.bound <= whole.cost * (1 + 1e-9)).all()
    assert "the search ended before all was compared" in cut.conditions


def test_a_master_that_a_ban_holds_cannot_leave_meanwhile():
    """On Sunday heavy vehicles stand still from 9 to 22 h: there is no step in which one starts."""
    sunday = datetime(2026, 3, 1, 5)
    net = italy()
    trips = [
        po.Trip(name, name, "Bologna", sunday, flexibility_min=24 * 60)
        for name in ("Milano", "Brescia")
    ]
    problem = po.Problem(net, trips, po.paper_weights(net), rules="eu561")
    curve = po.departure_curve(problem, "Milano")
    assert curve.is_exact
    closed = [(DAY.replace(day=1, hour=hour) - sunday).total_seconds() for hour in (10, 20)]
    assert np.isinf(curve.cost_at(closed)).all()
    assert np.isfinite(curve.cost_at([curve.begin_s[0], curve.end_s[-1]])).all()
    assert (curve.begin_s[1:] > curve.end_s[:-1] + 1).any()
