"""The departure curve against a count over departures, points and waits, in whole numbers."""

import itertools
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.planning.timing.curve_kernel import met_on_route, steps_of_members
from platoon_osm.planning.timing.departure_curve import Gains
from platoon_osm.planning.timing.limits import Window
from platoon_osm.planning.timing.member_ways import Ways
from platoon_osm.planning.timing.open_points import Delays, OpenPoints

HOURS = range(-30, 90)
ALONE_S = 9
"""How long every member drives alone [s]."""


@dataclass
class Member:
    """Ways as lists of (position, cost, time), and limits; None where nothing is asked."""

    entries: list
    exits: list
    first: int | None
    last_departure: int | None
    arrival: int | None
    alone: int


@dataclass
class Problem:
    drive: list
    weights: list
    members: list
    master: tuple
    price: float
    delay: float = 0.0


def ways_drawn(draw, positions):
    small = st.integers(0, 20)
    return [
        (at, draw(small), draw(small))
        for at in range(positions)
        for _ in range(draw(st.sampled_from([0, 1, 1, 1, 2, 3])))
    ]


@st.composite
def problems(draw, priced=False, delayed=False):
    edges = draw(st.integers(1, 5))
    members = []
    for _ in range(draw(st.integers(1, 3))):
        first = draw(st.none() | st.integers(-10, 30))
        leave = None if first is None else draw(st.none() | st.integers(first, first + 20))
        members.append(
            Member(
                ways_drawn(draw, edges + 1), ways_drawn(draw, edges + 1), first, leave,
                draw(st.none() | st.integers(0, 70)), draw(st.integers(0, 50)),
            )
        )  # fmt: skip
    low = draw(st.integers(-20, 40))
    return Problem(
        draw(st.lists(st.integers(0, 6), min_size=edges, max_size=edges)),
        draw(st.lists(st.integers(1, 9), min_size=edges, max_size=edges)),
        members,
        (low, low + draw(st.integers(0, 40))),
        draw(st.sampled_from([0.5, 1.0, 3.0])) if priced else 0.0,
        draw(st.sampled_from([0.25, 1.0])) if delayed else 0.0,
    )


def pays(problem, one, leaves):
    """The least cost of a member, counting every way in, way out and departure of its own."""
    best = one.alone
    for (i, cost_in, time_in), (j, cost_out, time_out) in itertools.product(one.entries, one.exits):
        if i >= j:
            continue
        meets = leaves + sum(problem.drive[:i])
        if one.arrival is not None and (leaves + sum(problem.drive[:j]) + time_out > one.arrival):
            continue
        own = range(-120, 160) if one.first is None else range(one.first, 160)
        waits = [
            meets - start - time_in
            for start in own
            if meets - start - time_in >= 0
            and (one.last_departure is None or start <= one.last_departure)
        ]
        late = 0
        if one.first is not None:
            late = leaves + sum(problem.drive[:j]) + time_out - one.first - ALONE_S
        if waits:
            paid = cost_in + sum(problem.weights[i:j]) + cost_out + problem.price * min(waits)
            best = min(best, paid + problem.delay * late)
    return best


def points_of(problem):
    def rows(every):
        return Ways.joined([
            tuple(np.array(column, kind) for column, kind in
                  zip(zip(*own, strict=True), (np.int64, float, float), strict=True))
            if own else (np.zeros(0, np.int64), np.zeros(0), np.zeros(0))
            for own in every
        ])  # fmt: skip

    first, last = problem.master
    tau = np.concatenate([[0], np.cumsum(problem.drive)]).astype(float)
    return OpenPoints.of(
        Window(first, last, None),
        [Window(one.first, one.last_departure, one.arrival) for one in problem.members],
        tau,
        rows([one.entries for one in problem.members]),
        rows([one.exits for one in problem.members]),
    )


def steps_for(problem, points, gains=None, latest=None):
    count = len(problem.members)
    platoon = np.tile(np.concatenate([[0.0], np.cumsum(problem.weights)]), (count, 1))
    alone = np.array([one.alone for one in problem.members], float)
    delays = Delays(
        np.array([0.0 if one.first is None else problem.delay for one in problem.members]),
        np.array([float((one.first or 0) + ALONE_S) for one in problem.members]),
    )
    return points.steps(
        platoon, alone, 1e-11 * alone, gains, problem.price, latest,
        delays if problem.delay else None,
    )  # fmt: skip


@given(problem=problems())
@settings(max_examples=80)
def test_the_curve_is_the_least_cost_at_every_departure(problem):
    curve = steps_for(problem, points_of(problem)).curve(7.0)
    first, last = problem.master
    for leaves in range(first, last + 1):
        expected = 7 + sum(pays(problem, one, leaves) for one in problem.members)
        assert curve.values(np.array([leaves]))[0] == pytest.approx(expected, abs=1e-9)


@given(problem=problems(delayed=True) | problems(priced=True, delayed=True))
@settings(max_examples=80)
def test_delay_has_its_price(problem):
    curve = steps_for(problem, points_of(problem)).curve(3.0, slope=0.5)
    first, last = problem.master
    for leaves in range(first, last + 1):
        expected = 3 + 0.5 * leaves + sum(pays(problem, one, leaves) for one in problem.members)
        assert curve.values(np.array([leaves]))[0] == pytest.approx(expected, abs=1e-9)


@given(problem=problems(priced=True))
@settings(max_examples=80)
def test_waiting_after_a_latest_departure_has_its_price(problem):
    curve = steps_for(problem, points_of(problem)).curve()
    first, last = problem.master
    for leaves in range(first, last + 1):
        expected = sum(pays(problem, one, leaves) for one in problem.members)
        assert curve.values(np.array([leaves]))[0] == pytest.approx(expected, abs=1e-9)


@given(problem=problems() | problems(priced=True))
@settings(max_examples=80)
def test_the_least_is_at_the_earliest_departure_or_where_an_entry_opens(problem):
    points = points_of(problem)
    first, last = problem.master
    every = {
        at: sum(pays(problem, one, at) for one in problem.members)
        for at in range(first, last + 1)
    }  # fmt: skip
    some = {first, *(int(at) for at in points.opens if first <= at <= last)}
    assert min(every.values()) == min(every[at] for at in some)
    curve = steps_for(problem, points).curve()
    step, value = curve.best()
    assert value == pytest.approx(min(every.values()), abs=1e-9)
    # The earliest of equally good departures.
    assert curve.moment(step) == min(at for at in every if every[at] == pytest.approx(value))


@given(problem=problems() | problems(priced=True) | problems(priced=True, delayed=True))
@settings(max_examples=60)
def test_nobody_pays_less_than_at_its_own_best_departure(problem):
    least = steps_for(problem, points_of(problem)).least()
    first, last = problem.master
    for one, found in zip(problem.members, least, strict=True):
        expected = min(pays(problem, one, at) for at in range(first, last + 1))
        assert found == pytest.approx(expected, abs=1e-9)


def best_pairs_by_count(problem, one, leaves):
    """All pairs of positions of the least cost at a departure."""
    best = pays(problem, one, leaves)
    tau = list(itertools.accumulate(problem.drive, initial=0))
    found = set()
    for (i, cost_in, time_in), (j, cost_out, time_out) in itertools.product(one.entries, one.exits):
        meets = leaves + tau[i]
        open_in = one.first is None or one.first + time_in <= meets
        open_out = one.arrival is None or leaves + tau[j] + time_out <= one.arrival
        cost = cost_in + sum(problem.weights[i:j]) + cost_out
        if i < j and open_in and open_out and cost == best:
            found.add((i, j))
    return found


@given(problem=problems(), data=st.data())
@settings(max_examples=80)
def test_what_the_master_gains_counts_once_an_edge(problem, data):
    edges = len(problem.drive)
    gain = np.array(data.draw(st.lists(st.integers(0, 9), min_size=edges, max_size=edges)), float)
    length = data.draw(st.lists(st.integers(0, 2), min_size=edges, max_size=edges))
    gains = Gains(gain, np.concatenate([[0.0], np.cumsum(length)]))
    curve = steps_for(problem, points_of(problem), gains).curve(0.0, gains)
    first, last = problem.master
    for leaves in range(first, last + 1):
        total, met = 0, set()
        for one in problem.members:
            total += pays(problem, one, leaves)
            pairs = best_pairs_by_count(problem, one, leaves)
            if pairs:
                i, j = min(pairs, key=lambda at: (-sum(length[at[0] : at[1]]), at))
                # A platoon of no length is one only if it is cheaper.
                if sum(length[i:j]) or pays(problem, one, leaves) < one.alone:
                    met |= set(range(i, j))
        expected = total - sum(gain[edge] for edge in met)
        assert curve.values(np.array([leaves]))[0] == pytest.approx(expected, abs=1e-9)


@given(problem=problems() | problems(priced=True))
@settings(max_examples=15)
def test_the_compiled_kernel_gives_the_same_to_the_last_digit(problem):
    from platoon_osm.search.hierarchy.runtime.jit import compiled

    points = points_of(problem)
    ways, rest = points.entries, points.exits
    tau = np.concatenate([[0.0], np.cumsum(problem.drive)])
    alone = np.array([one.alone for one in problem.members], float)
    arguments = (
        ways.first, ways.at, ways.cost / 3, points.opens,
        points.fades if problem.price else np.zeros(0), rest.first, rest.at, rest.cost / 7,
        points.closes, alone, alone * 1e-11, tau, points.earliest, points.latest, problem.price,
        not problem.price,
    )  # fmt: skip
    plain, quick = steps_of_members(*arguments), compiled(steps_of_members)(*arguments)
    for one, other in zip(plain, quick, strict=True):
        assert np.array_equal(one, other)
    member, _, _, _, _, merge, leave = plain
    if not problem.price:
        gain = np.arange(1.0, len(problem.drive) + 1)
        last = member, merge, leave, gain, len(alone)
        assert np.array_equal(met_on_route(*last), compiled(met_on_route)(*last))


def test_an_instant_that_opens_one_way_and_closes_another_is_seen():
    """Company is in time at one moment alone, and sums miss it by a last digit."""
    entries = Ways.dense(np.array([[1.0, np.inf]]), np.array([[0.1 + 0.2, np.inf]]))
    exits = Ways.dense(np.array([[np.inf, 1.0]]), np.array([[np.inf, 0.7]]))
    points = OpenPoints.of(
        Window(0.0, 10.0, None), [Window(1.0, None, 3.0)], np.array([0.0, 1.0]), entries, exits
    )
    assert points.opens[0] > points.closes[0]
    curve = points.steps(np.array([[0.0, 1.0]]), np.array([9.0]), np.array([1e-10])).curve()
    assert curve.values(np.array([float(points.opens[0])]))[0] == 3.0
    assert curve.values(np.array([1.0]))[0] == curve.values(np.array([2.0]))[0] == 9.0


def test_without_limits_there_is_one_step():
    entries = Ways.dense(np.array([[1.0, 5.0]]), np.array([[1.0, 1.0]]))
    points = OpenPoints.of(
        Window(None, None, None), [Window(None, None, None)], np.array([0.0, 1.0]), entries, entries
    )
    curve = points.steps(np.array([[0.0, 1.0]]), np.array([9.0]), np.array([1e-10])).curve()
    assert (len(curve.since), curve.best()) == (1, (0, 7.0))
    assert curve.moment(0) == 0.0
