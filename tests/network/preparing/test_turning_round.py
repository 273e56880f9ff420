"""Turning round behind a forbidden turn, against walks listed one by one."""

from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.network.preparing.turning_round import no_turning_round
from platoon_osm.network.preparing.turns import ForbiddenTurn, split_turns
from tests.network.preparing.test_turns import cheapest, on_copies


def two_way(*roads, one_way=()):
    """Segments of roads given by their nodes: tail, head, and a segment by its nodes."""
    pairs = [pair for road in roads for pair in pairwise(road)]
    pairs += [(b, a) for a, b in pairs] + list(pairwise(one_way))
    tail, head = (np.array(side, np.int64) for side in zip(*pairs, strict=True))
    return tail, head, {pair: k for k, pair in enumerate(pairs)}


def test_who_may_not_turn_left_does_not_turn_round_down_the_road_but_drives_on():
    # From 0 over the crossing 1 to 9 is forbidden; 2 is a point of the line, 3 the next junction;
    # the one-way loop 3-4-6-3 is where the truck comes back.
    tail, head, segment = two_way((0, 1, 2, 3), (1, 9), one_way=(3, 4, 6, 3))
    cost = np.ones(len(tail))
    turn = ForbiddenTurn((segment[0, 1], segment[1, 9]))
    more = no_turning_round(tail, head, 10, [turn])
    named = {tuple((int(tail[k]), int(head[k])) for k in one.segments) for one in more}
    assert named == {
        ((0, 1), (1, 2), (2, 1)),
        ((0, 1), (1, 2), (2, 3), (3, 2)),
    }
    blind = on_copies(split_turns(tail, head, 10, [turn]), 10, cost, 0, True)
    kept = on_copies(split_turns(tail, head, 10, [turn, *more]), 10, cost, 0, True)
    assert blind[9] == 1 + 1 + 1 + 1
    assert kept[9] == 1 + 2 + 3 + 2 + 1
    # Who comes the other way may turn onto it.
    from_three = on_copies(split_turns(tail, head, 10, [turn, *more]), 10, cost, 3, True)
    assert from_three[9] == 3


def test_at_a_dead_end_a_truck_may_turn():
    tail, head, segment = two_way((0, 1, 2, 3), (1, 9))
    turn = ForbiddenTurn((segment[0, 1], segment[1, 9]))
    more = no_turning_round(tail, head, 10, [turn])
    split = split_turns(tail, head, 10, [turn, *more])
    assert on_copies(split, 10, np.ones(len(tail)), 0, True)[9] == 1 + 2 + 2 + 1


def test_a_turn_forbidden_to_trucks_lets_others_turn_round():
    tail, head, segment = two_way((0, 1, 2, 3, 4), (1, 9), (3, 5))
    turn = ForbiddenTurn((segment[0, 1], segment[1, 9]), {"hgv": "no"})
    assert {one.layer["hgv"] for one in no_turning_round(tail, head, 10, [turn])} == {"no"}


@st.composite
def maps(draw):
    """A few two-way and one-way roads with points on their lines, and forbidden turns."""
    n = draw(st.integers(3, 9))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    pairs = set()
    for _ in range(draw(st.integers(2, 9))):
        a, b = rng.choice(n, 2, replace=False).tolist()
        pairs |= {(a, b), (b, a)} if rng.random() < 0.8 else {(a, b)}
    tail, head = (np.array(side, np.int64) for side in zip(*sorted(pairs), strict=True))
    turns = []
    for _ in range(draw(st.integers(1, 3))):
        first = int(rng.integers(len(tail)))
        onward = np.flatnonzero(tail == head[first])
        if len(onward):
            layer = {"hgv": "no"} if rng.random() < 0.4 else None
            turns.append(ForbiddenTurn((first, int(rng.choice(onward))), layer))
    return n, tail, head, turns


def listed(n, tail, head, turns):
    """All walks from a restriction on along points of a line, and back by where they came."""
    beside = [{*head[tail == k].tolist(), *tail[head == k].tolist()} - {k} for k in range(n)]
    found = set()

    def walk(driven, layer):
        here = int(head[driven[-1]])
        if len(beside[here]) < 2 or len(driven) > n + 2:
            return
        for onward in np.flatnonzero(tail == here).tolist():
            if int(head[onward]) == int(tail[driven[-1]]):
                found.add(((*driven, onward), layer))
            elif len(beside[here]) == 2 and onward not in driven:
                walk((*driven, onward), layer)

    for turn in turns:
        at = int(head[turn.segments[0]])
        same = {
            one.segments[1]
            for one in turns
            if (one.segments[0], one.layer) == (turn.segments[0], turn.layer)
        }
        for first in np.flatnonzero(tail == at).tolist():
            if first not in same and int(head[first]) != int(tail[turn.segments[0]]):
                walk((turn.segments[0], first), str(turn.layer))
    return found


@settings(max_examples=200)
@given(maps())
def test_every_way_of_turning_round_is_found_and_no_other(problem):
    n, tail, head, turns = problem
    found = no_turning_round(tail, head, n, turns)
    assert {(one.segments, str(one.layer)) for one in found} == listed(n, tail, head, turns)


@settings(max_examples=100)
@given(maps())
def test_costs_are_those_of_ways_that_never_evade(problem):
    n, tail, head, turns = problem
    cost = np.arange(1.0, len(tail) + 1)
    forbidden = [*turns, *no_turning_round(tail, head, n, turns)]
    split = split_turns(tail, head, n, forbidden)
    for truck in (False, True):
        binding = [one.segments for one in forbidden if one.layer is None or truck]
        assert on_copies(split, n, cost, 0, truck) == cheapest(tail, head, cost, binding, 0)
