"""Forbidden turns on split nodes, against searches over the last segments driven."""

import heapq

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.network.preparing.turns import ForbiddenTurn, split_turns

SOME = settings(max_examples=300)


def cheapest(tail, head, cost, forbidden, source):
    """Least costs to all nodes by ways that never drive a forbidden sequence.

    A state is the last segments driven, as many as the longest sequence is long.
    """
    longest = max((len(one) for one in forbidden), default=2)
    best = {source: 0.0}
    queue, seen = [(0.0, source, ())], set()
    while queue:
        paid, node, last = heapq.heappop(queue)
        if (node, last) in seen:
            continue
        seen.add((node, last))
        best.setdefault(node, paid)
        for segment in np.flatnonzero(tail == node).tolist():
            driven = (*last, segment)
            if any(driven[-len(one) :] == one for one in forbidden):
                continue
            heapq.heappush(queue, (paid + cost[segment], int(head[segment]), driven[1 - longest :]))
    return best


@st.composite
def graphs(draw):
    n = draw(st.integers(2, 6))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    m = draw(st.integers(2, 14))
    tail, head = rng.integers(0, n, m), rng.integers(0, n, m)
    turns = []
    for _ in range(draw(st.integers(0, 6))):
        path = [int(rng.integers(m))]
        for _ in range(int(rng.integers(1, 4))):
            onward = np.flatnonzero(tail == head[path[-1]])
            if not len(onward):
                break
            path.append(int(rng.choice(onward)))
        if len(path) > 1:
            layer = {"hgv": "no"} if rng.random() < 0.4 else None
            turns.append(ForbiddenTurn(tuple(path), layer))
    return n, tail, head, rng.integers(1, 9, m).astype(float), turns


def on_copies(split, n, cost, source, truck):
    open_to = [truck is False or not split.layers.get(k) for k in range(len(split.tail))]
    use = np.flatnonzero(open_to)
    best = cheapest(split.tail[use], split.head[use], cost[split.origin[use]], [], source)
    found = {}
    for node, paid in best.items():
        own = int(split.node_origin[node])
        found[own] = min(paid, found.get(own, np.inf))
    return found


@SOME
@given(graphs())
def test_a_search_that_knows_nothing_of_turns_obeys_them(problem):
    n, tail, head, cost, turns = problem
    split = split_turns(tail, head, n, turns)
    for truck in (False, True):
        binding = [turn.segments for turn in turns if turn.layer is None or truck]
        for source in range(n):
            assert on_copies(split, n, cost, source, truck) == cheapest(
                tail, head, cost, binding, source
            )


@SOME
@given(graphs())
def test_copies_are_copies(problem):
    n, tail, head, _, turns = problem
    split = split_turns(tail, head, n, turns)
    assert split.node_origin[:n].tolist() == list(range(n))
    assert (split.node_origin[split.tail] == tail[split.origin]).all()
    assert (split.node_origin[split.head] == head[split.origin]).all()
    # At no node does the same segment begin twice.
    assert len(set(zip(split.tail.tolist(), split.origin.tolist(), strict=True))) == len(split.tail)
    if not turns:
        assert len(split.tail) == len(tail)


def test_one_forbidden_turn_takes_one_copy():
    # from 0 to 1, then on to 2 or 3; 0 -> 1 -> 2 is forbidden, 4 -> 1 -> 2 is not
    tail, head = np.array([0, 1, 1, 4]), np.array([1, 2, 3, 1])
    split = split_turns(tail, head, 5, [ForbiddenTurn((0, 1))])
    assert len(split.node_origin) == 6
    assert sorted(zip(split.tail.tolist(), split.head.tolist(), strict=True)) == [
        (0, 5), (1, 2), (1, 3), (4, 1), (5, 3),
    ]  # fmt: skip
