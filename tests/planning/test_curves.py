"""The departure curve and the delay frontier, as users ask for them."""

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from hypothesis import given, settings
from test_timed_star import Count, asked_of, corridor, problems

import platoon_osm as po

DAY = datetime(2026, 3, 2)


@given(problem=problems())
@settings(max_examples=30)
def test_a_curve_is_what_is_counted_at_every_departure(problem):
    asked = asked_of(problem)
    count = Count(problem, asked.question)
    curve = po.departure_curve(asked.question.problem)
    assert curve.is_exact
    zero = round((datetime.fromisoformat(curve.start) - DAY).total_seconds())
    every = {at: count.members_pay([at + tau for tau in count.tau]) for at in count.departures()}
    moments = np.array([at - zero for at in every], float)
    assert curve.cost_at(moments) == pytest.approx(list(every.values()))
    assert curve.best_cost == pytest.approx(min(every.values()))
    assert curve.cost_at(curve.best_s)[0] == pytest.approx(curve.best_cost)
    assert curve.cost_at([moments.min() - 1, moments.max() + 1]).tolist() == [np.inf, np.inf]
    assert (curve.begin_s[1:] == curve.end_s[:-1]).all()
    # Who joins is told twice: for each member, and as a number for each step.
    for step in np.flatnonzero(curve.end_s - curve.begin_s > 0.1).tolist():
        middle = (curve.begin_s[step] + curve.end_s[step]) / 2
        assert len(curve.company_at(middle)) == curve.company[step]


@given(problem=problems())
@settings(max_examples=20)
def test_more_delay_never_saves_less_and_each_is_the_best_of_its_windows(problem):
    asked = asked_of(problem)
    delays_s = (0, 5, 20)
    frontier = po.delay_frontier(asked.question.problem, [late / 60 for late in delays_s])
    assert (np.diff(frontier.saving) >= 0).all()
    assert (frontier.bound <= frontier.cost).all()
    net, costs, rows = problem
    alone = asked.question.alone_s
    for late, cost in zip(delays_s, frontier.cost, strict=True):
        same = [
            (name, start, end, first, None, first + int(alone[k]) + late)
            for k, (name, start, end, first, _, _) in enumerate(rows)
        ]
        count = Count((net, costs, same), asked.question)
        least = min(
            count.members_pay([at + tau for tau in count.tau]) for at in count.departures()
        )  # fmt: skip
        # A narrower window's plan can be kept in a wider one.
        assert cost <= least + 1e-6
        if late == 0:
            assert cost == pytest.approx(min(least, frontier.solo_cost))


def two_on_a_road(price=0.0):
    times = {(0, 1): 600, (1, 2): 6000, (3, 1): 600}
    net, costs = corridor(times, times, 4)
    costs.price = price
    return net, costs, [("V0", 0, 2, 0, None, 10_000), ("V1", 3, 2, 1200, 1500, 9000)]


def test_a_curve_by_hand(tmp_path):
    """V1 can join from 1200 on, and be in time until 2400; from 1500 on it waits."""
    asked = asked_of(two_on_a_road())
    curve = po.departure_curve(asked.question.problem)
    assert curve.begin_s.tolist() == [0, 1200, 2400]
    assert curve.end_s.tolist() == [1200, 2400, 3400]
    assert curve.cost.tolist() == [13200, 10200, 13200]
    assert curve.company.tolist() == [0, 1, 0]
    assert (curve.best_s, curve.best_cost, curve.best_company) == (1200, 10200, ("V1",))
    assert curve.cost_at(2400).tolist() == [10200]
    curve.write_csv(tmp_path / "curve.csv")
    lines = (tmp_path / "curve.csv").read_text().splitlines()
    assert lines[0].startswith("begin,end,begin_s,end_s,cost_m_eq")
    assert lines[2].startswith("2026-03-02T00:20:00,2026-03-02T00:40:00,1200,2400,10200")
    assert len(curve.to_frame()) == 3


def test_a_curve_with_priced_waiting_rises():
    curve = po.departure_curve(asked_of(two_on_a_road(price=4.0)).question.problem)
    assert curve.begin_s.tolist() == [0, 1200, 1500, 2250]
    assert curve.cost.tolist() == [13200, 10200, 10200, 13200]
    assert curve.end_cost.tolist() == [13200, 10200, 13200, 13200]
    assert curve.cost_at(1600).tolist() == [10600]


def test_a_frontier_by_hand(tmp_path):
    """V1 leaves at 1200 at the earliest: V0 has to be 20 min later than alone."""
    frontier = po.delay_frontier(asked_of(two_on_a_road()).question.problem, (30, 0, 20, 19))
    assert frontier.delay_min.tolist() == [0, 19, 20, 30]
    assert frontier.saving.tolist() == [0, 0, 3000, 3000]
    assert frontier.master == ("", "", "V0", "V0")
    assert frontier.gap.tolist() == [0, 0, 0, 0]
    frontier.write_csv(tmp_path / "frontier.csv")
    assert (tmp_path / "frontier.csv").read_text().count("\n") == 5
    assert frontier.to_frame()["company"].tolist() == [0, 0, 1, 1]


@pytest.mark.parametrize("kind", ["png", "svg", "pdf"])
def test_figures_are_the_same_to_the_last_byte(tmp_path, kind):
    problem = asked_of(two_on_a_road()).question.problem
    curve, frontier = po.departure_curve(problem), po.delay_frontier(problem)
    ruled = replace(
        curve, rules="eu561", end_s=curve.end_s - 2, bound=curve.cost - 100, is_exact=False
    )
    for one in (curve, frontier, ruled):
        for name in ("a", "b"):
            po.write_curve(one, tmp_path / f"{name}.{kind}", language="de")
        assert (tmp_path / f"a.{kind}").read_bytes() == (tmp_path / f"b.{kind}").read_bytes()


def test_what_has_no_curve():
    net, costs, _ = two_on_a_road()
    trips = [po.Trip("V0", 0, 2), po.Trip("V1", 3, 2)]
    with pytest.raises(po.ScenarioError, match="no trip names a time"):
        po.departure_curve(po.Problem(net, trips, costs))
    timed = [po.Trip("V0", 0, 2, DAY), po.Trip("V1", 3, 2)]
    with pytest.raises(po.ScenarioError, match="one vehicle alone"):
        po.delay_frontier(po.Problem(net, timed[:1], costs))
    with pytest.raises(po.ScenarioError, match="minutes, 0 or more"):
        po.delay_frontier(po.Problem(net, timed, costs), [-1])
    with pytest.raises(po.ScenarioError, match=r"use \.png, \.svg or \.pdf"):
        po.write_curve(po.departure_curve(po.Problem(net, timed, costs)), "curve.gif")


def test_times_in_a_zone_are_shown_in_it():
    from zoneinfo import ZoneInfo

    net, costs, _ = two_on_a_road()
    six = datetime(2026, 3, 29, 1, 30, tzinfo=ZoneInfo("Europe/Rome"))
    trips = [
        po.Trip("V0", 0, 2, six, None, six + timedelta(hours=5)),
        po.Trip("V1", 3, 2, six + timedelta(minutes=20)),
    ]
    curve = po.departure_curve(po.Problem(net, trips, costs, master="V0"))
    shown = [curve.clock.moment(at).isoformat() for at in curve.begin_s]
    assert shown[0] == "2026-03-29T01:30:00+01:00"
    assert curve.clock.moment(3600).isoformat() == "2026-03-29T03:30:00+02:00"
    assert curve.zone == "Europe/Rome"
