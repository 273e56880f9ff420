"""Roads for residents are the first and the last mile: who returns to them on the way is told."""

import heapq

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from random_networks import network

import platoon_osm as po
from platoon_osm.errors import PlatoonError
from platoon_osm.network.usable_nodes import UsableNodes
from platoon_osm.plans.trip import Trip

PRIVATE = "access=private"
TOLD = "returns on its way to roads for residents"


def roads(edges):
    """Return a network of edges (tail, head, km, restriction)."""
    tails, heads, km, texts = zip(*sorted(edges), strict=True)
    plain = network(np.array(tails), np.array(heads), np.array(km) * 1000.0)
    columns = {name: getattr(plain, name) for name in ("tail", "head", "length_m", "lon", "lat")}
    return po.RoadNetwork.from_edges(**columns, restriction=list(texts))


YARD, GATE, SIDE, BACK, TOWN = range(5)


def estate(through_km):
    """Return an estate with a yard, three gates, and a public road round it and to a town."""
    both = [
        (YARD, GATE, 1, PRIVATE), (GATE, SIDE, 4, ""), (YARD, SIDE, 9, PRIVATE),
        (SIDE, BACK, through_km, PRIVATE), (GATE, BACK, 20, ""), (BACK, TOWN, 5, ""),
    ]  # fmt: skip
    return roads(both + [(b, a, km, text) for a, b, km, text in both])


def told(plan):
    return [remark for remark in plan.remarks if TOLD in remark]


def test_who_cuts_through_its_own_zone_is_told():
    net = estate(2)
    plan = po.plan_joint(net, po.paper_weights(net), [Trip("A", YARD, TOWN)])
    (remark,) = told(plan)
    assert remark.startswith("A returns")
    home = po.plan_joint(net, po.paper_weights(net), [Trip("A", TOWN, YARD)])
    assert len(told(home)) == 1


def test_who_goes_around_is_not():
    net = estate(30)
    assert not told(po.plan_joint(net, po.paper_weights(net), [Trip("A", YARD, TOWN)]))
    # Out of the zone and home again is a first and a last mile; so is all of it within.
    for end in (SIDE, BACK, GATE):
        assert not told(po.plan_joint(net, po.paper_weights(net), [Trip("A", YARD, end)]))


@st.composite
def mixed_networks(draw):
    n = draw(st.integers(4, 7))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    pairs = {(int(a), int(b)) for a, b in rng.integers(0, n, (3 * n, 2)) if a != b}
    edges = [
        (a, b, float(rng.uniform(1, 20)), PRIVATE if rng.random() < 0.5 else "")
        for a, b in sorted(pairs | {(k, (k + 1) % n) for k in range(n)})
    ]
    return edges, draw(st.integers(0, n - 1)), draw(st.integers(0, n - 1))


def best_lawful(net, origin, goal):
    """Return the least km of all walks whose private roads are a first and a last mile.

    First by walks that know what they have driven: within the own zone, outside, within the other.
    """
    private = np.array([net.texts[code] != "" for code in net.restriction])
    public = UsableNodes(net, private)
    leaves, arrives = public.of("origin"), public.of("destination")
    behind = ~private & ~(leaves[net.head] | arrives[net.tail])
    best = {(origin, "first"): 0.0}
    queue = [(0.0, origin, "first")]
    while queue:
        km, node, phase = heapq.heappop(queue)
        if km > best[node, phase]:
            continue
        for edge in np.flatnonzero(net.tail == node):
            if behind[edge]:
                on = (phase,)
            elif not private[edge]:
                on = ("between",) if phase != "last" else ()
            else:
                first = ("first",) if phase == "first" and not leaves[origin] else ()
                on = first + (("last",) if not arrives[goal] else ())
            far = km + net.length_m[edge] / 1000
            for after in on:
                reached = int(net.head[edge]), after
                if far < best.get(reached, np.inf):
                    best[reached] = far
                    heapq.heappush(queue, (far, *reached))
    return min(best.get((goal, phase), np.inf) for phase in ("first", "between", "last"))


@settings(max_examples=50, deadline=None)
@given(mixed_networks())
def test_a_route_without_the_remark_is_the_best_lawful_one(problem):
    edges, origin, goal = problem
    assume(origin != goal)
    net = roads(edges)
    lawful = best_lawful(net, origin, goal)
    try:
        plan = po.plan_joint(net, po.paper_weights(net), [Trip("A", origin, goal)])
    except PlatoonError:
        assert lawful == np.inf
        return
    km = net.length_m[[edge for k in plan.ways[0] for edge in plan.stretches[k].edges]].sum() / 1000
    assert km <= lawful + 1e-9
    assert (km == pytest.approx(lawful)) == (not told(plan))
