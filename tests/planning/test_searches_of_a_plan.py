"""A plan makes each search once, and comes out the same whichever engine searches."""

import json

import numpy as np
import pytest
import scipy.sparse.csgraph
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import problems, tied_networks

import platoon_osm as po
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip

MOST_SEARCHES = 20
"""Single-source searches of three trips in all cases; once it was 33."""


@pytest.fixture
def searched(monkeypatch):
    """The sources of all searches of the reference engine."""
    sources = []
    real = scipy.sparse.csgraph.dijkstra

    def counted(graph, *arguments, **options):
        indices = options.get("indices", arguments[1] if len(arguments) > 1 else None)
        sources.extend((graph.data.tobytes(), int(one)) for one in np.atleast_1d(indices))
        return real(graph, *arguments, **options)

    monkeypatch.setattr(scipy.sparse.csgraph, "dijkstra", counted)
    return sources


def alone_only(searched):
    """The searches under the solo weight, which the first has; turns and bounds have their own."""
    return [one for one in searched if one[0] == searched[0][0]]


PLACES = [("Torino", "Trieste"), ("Genova", "Belluno"), ("Milano", "Brennero")]


def test_three_trips_in_all_cases_search_each_node_once(searched):
    net = po.load_network("italy-motorways")
    trips = [Trip("ABC"[k], *places) for k, places in enumerate(PLACES)]
    plan_joint(net, po.paper_weights(net), trips, "best", engine="reference")
    alone = alone_only(searched)
    assert 0 < len(alone) <= MOST_SEARCHES
    assert len(set(alone)) == len(alone)


def test_two_trips_in_all_cases_and_d_search_each_node_once(searched):
    net = po.load_network("italy-motorways")
    trips = [Trip("AB"[k], *places) for k, places in enumerate(PLACES[:2])]
    plan_joint(net, po.paper_weights(net), trips, "best", engine="reference")
    alone = alone_only(searched)
    assert 0 < len(alone) <= MOST_SEARCHES
    assert len(set(alone)) == len(alone)


def same_on_both(net, weights, trips, case, **options):
    plans = [
        plan_joint(net, weights, trips, case, engine=engine, **options)
        for engine in ("reference", "hierarchy")
    ]
    one, two = (json.dumps(plan.to_dict()) for plan in plans)
    assert one == two


@settings(max_examples=40, deadline=None)
@given(problems(), st.sampled_from(["A", "B", "C", "D", "best"]), st.booleans())
def test_plans_do_not_depend_on_the_engine(problem, case, system):
    net, weights, trips = problem
    trips = trips[:2] if case == "D" else trips
    same_on_both(net, weights, trips, case, objective="system" if system else "member")


@settings(max_examples=60, deadline=None)
@given(tied_networks(), st.data())
def test_nor_where_many_routes_cost_the_same(tied, data):
    net, weights = tied
    ends = st.tuples(st.integers(0, net.n - 1), st.integers(0, net.n - 1))
    pairs = data.draw(
        st.lists(ends.filter(lambda pair: pair[0] != pair[1]), min_size=1, max_size=3)
    )
    trips = [Trip("ABC"[k], *pair) for k, pair in enumerate(pairs)]
    case = data.draw(st.sampled_from(["A", "B", "C", "best"]))
    try:
        plan_joint(net, weights, trips, case, engine="reference")
    except po.NoRouteError:
        return
    same_on_both(net, weights, trips, case)
