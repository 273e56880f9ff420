"""Chain contraction against a plain walk over random graphs."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.network.preparing.chains import contract_chains


def walk(tail, head, n, keep):
    """Group segments the slow, obvious way: by sets of neighbours and by following pointers."""
    out = [[s for s in range(len(tail)) if tail[s] == v] for v in range(n)]
    into = [[s for s in range(len(tail)) if head[s] == v] for v in range(n)]

    def passed(v):
        if keep[v] or any(head[s] == v for s in out[v]):
            return False
        heads, tails = sorted(head[s] for s in out[v]), sorted(tail[s] for s in into[v])
        if len(heads) == len(tails) == 1:
            return heads != tails
        return len(heads) == len(tails) == 2 and heads == tails and heads[0] != heads[1]

    def onward(s):
        v = head[s]
        if not passed(v):
            return None
        options = [t for t in out[v] if len(out[v]) == 1 or head[t] != tail[s]]
        return options[0]

    led = {onward(s) for s in range(len(tail))}
    chains, seen = [], set()
    rings = sorted(range(len(tail)), key=lambda s: (tail[s], s))
    for s in [s for s in range(len(tail)) if s not in led] + rings:
        if s in seen:
            continue
        chain = []
        while s is not None and s not in seen:
            chain.append(s)
            seen.add(s)
            s = onward(s)
        chains.append(tuple(chain))
    return set(chains)


@st.composite
def graphs(draw):
    n = draw(st.integers(1, 9))
    pairs = draw(st.lists(st.tuples(st.integers(0, n - 1), st.integers(0, n - 1)), max_size=16))
    both = draw(st.booleans())
    if both:
        pairs = [p for a, b in pairs for p in ((a, b), (b, a))]
    keep = draw(st.lists(st.booleans(), min_size=n, max_size=n))
    return n, pairs, keep if draw(st.booleans()) else [False] * n


@settings(max_examples=400, deadline=None)
@given(graphs())
def test_matches_a_plain_walk(graph):
    n, pairs, keep = graph
    tail = np.array([a for a, _ in pairs], np.int64)
    head = np.array([b for _, b in pairs], np.int64)
    chains = contract_chains(tail, head, n, np.array(keep))
    got = {
        tuple(chains.segments[a:b].tolist())
        for a, b in zip(chains.first[:-1], chains.first[1:], strict=True)
    }
    assert got == walk(tail.tolist(), head.tolist(), n, keep)


def test_a_one_way_ring_keeps_its_lowest_node():
    tail, head = np.array([2, 0, 1]), np.array([0, 1, 2])
    chains = contract_chains(tail, head, 3, np.zeros(3, bool))
    assert chains.segments.tolist() == [1, 2, 0]
    assert chains.first.tolist() == [0, 3]
