"""The rule of ties is one rule: its forms prefer the same platoon, as all pairs in a row do."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.search.hierarchy.fused import members
from platoon_osm.search.joining import best_pairs
from platoon_osm.search.tie_rule import (
    TIE,
    in_order_of_preference,
    is_platoon,
    preferred,
    slack_of,
)

FEW = st.integers(0, 3).map(float)


def oracle(entry, leave, platoon, length, alone):
    """All pairs, cheapest first, then by the words of the rule."""
    pairs = [
        (i, j, entry[i] + platoon[j] - platoon[i] + leave[j], length[j] - length[i])
        for i in range(len(length))
        for j in range(i + 1, len(length))
    ]
    least = min(cost for *_, cost, _ in pairs)
    if least > alone:
        return -1, -1
    good = [(-metres, i, j) for i, j, cost, metres in pairs if cost == least]
    metres, i, j = min(good)
    return (i, j) if metres < 0 or least < alone else (-1, -1)


@settings(max_examples=200, deadline=None)
@given(st.integers(2, 6), st.data())
def test_every_form_prefers_the_same(stops, data):
    def draw(size):
        return np.array(data.draw(st.lists(FEW, min_size=size, max_size=size)))

    entry, leave, alone = draw(stops), draw(stops), data.draw(st.integers(0, 9).map(float))
    platoon = np.concatenate([[0.0], np.cumsum(draw(stops - 1))])
    length = np.concatenate([[0.0], np.cumsum(draw(stops - 1))])
    expected = oracle(entry, leave, platoon, length, alone)
    i, j, _ = best_pairs(entry[None], leave[None], platoon, length, np.array([alone]))
    assert (i[0], j[0]) == expected
    # Sorted at once, as a grid of many costs needs it.
    first, last = np.triu_indices(stops, 1)
    order = in_order_of_preference(first, last, length[last] - length[first])
    first, last = first[order], last[order]
    cost = entry[first] + platoon[last] - platoon[first] + leave[last]
    slack = slack_of(alone, cost.min())
    best = int(np.argmax(cost <= cost.min() + slack))
    metres = length[last[best]] - length[first[best]]
    joins = cost.min() <= alone + slack and is_platoon(metres, cost.min(), alone, slack)
    assert ((first[best], last[best]) if joins else (-1, -1)) == expected
    # Compiled, as the hierarchy's kernels run it.
    lead = np.minimum.accumulate(entry - platoon)
    total = np.concatenate([[np.inf], lead[:-1] + platoon[1:] + leave[1:]])
    limit = total.min() + slack
    ends = np.flatnonzero(total <= limit)
    arguments = (ends, limit, lead, leave, platoon, length)
    assert members._preferred(*arguments) == preferred(*arguments)


def test_slack_goes_by_the_cost_alone_and_else_by_the_least():
    for slack in (slack_of, members._slack_of):
        assert slack(100.0, 50.0) == pytest.approx(TIE * 100)
        assert slack(np.inf, 50.0) == pytest.approx(TIE * 50)
        assert slack(np.inf, np.inf) == 0
