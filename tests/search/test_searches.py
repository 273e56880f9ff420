"""The owner of a network's searches, the searches of a plan, and what they refuse."""

from dataclasses import replace

import numpy as np
import pytest
from graphs import networks, planar
from hypothesis import given, settings
from hypothesis import strategies as st

import platoon_osm as po
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import PlatoonError, SearchError
from platoon_osm.planning.pair import plan_pair
from platoon_osm.search import engine as engines
from platoon_osm.search import trees as trees_module
from platoon_osm.search.astar import astar
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.kept_topology import KeptTopology
from platoon_osm.search.searches import KEPT_WEIGHTS, Searches
from platoon_osm.search.trees import Trees

NAMES = ("reference", "hierarchy")


def test_one_owner_a_network_and_one_engine_a_weight():
    net, weight = planar(200, 1)
    searches = net.attached(Searches)
    assert net.attached(Searches) is searches
    for name in NAMES:
        first = searches.under(weight, engine=name)
        assert first.name == name
        assert searches.under(weight.copy(), engine=name) is first
        assert engines.engine_for(net, weight, name) is first
    for factor in range(2, KEPT_WEIGHTS + 2):
        searches.under(weight * factor, engine="reference")
    assert searches.under(weight, engine=name) is not first
    searches.forget()
    assert searches.under(weight, engine=name) is not first


def test_the_order_serves_every_weight_but_no_other_arrays():
    net, weight = planar(200, 2)
    first = net.attached(Searches).under(weight, engine="hierarchy")
    again = net.attached(Searches).under(weight * 2, engine="hierarchy")
    assert first.metric.topology is again.metric.topology
    assert net.attached(KeptTopology).of(net) is first.metric.topology
    other = replace(net, head=net.head.copy())
    assert net.attached(KeptTopology).of(other) is None
    engine = other.attached(Searches).under(weight, engine="hierarchy")
    assert engine.net is other
    assert engine.metric.topology is not first.metric.topology


@settings(max_examples=60, deadline=None)
@given(networks(), st.data())
def test_trees_give_what_the_engine_gives(case, data):
    net, weight = case
    engine = ReferenceEngine(net, weight)
    nodes = st.lists(st.integers(0, net.n - 1), max_size=6)
    for kind in (engine, HierarchyEngine(net, weight, threads=1)):
        trees = Trees(kind)
        asked = set()
        for _ in range(4):
            some, forward = data.draw(nodes), data.draw(st.booleans())
            np.testing.assert_allclose(
                trees.costs(some, forward), engine.distances(some, forward), rtol=1e-12
            )
            asked |= {(node, forward) for node in some}
            assert trees.searches == len(asked)
        sources, targets = data.draw(nodes), data.draw(nodes)
        np.testing.assert_allclose(
            trees.table(sources, targets), engine.many_to_many(sources, targets), rtol=1e-12
        )
        new = [node for node in set(sources) if (node, True) not in asked]
        missing = [node for node in set(targets) if (node, False) not in asked]
        assert trees.searches == len(asked) + min(len(new), len(missing))


def test_each_search_is_made_once():
    net, weight = planar(300, 3)
    trees = Trees(net.attached(Searches).under(weight, engine="reference"))
    tree = trees.tree(5)
    assert trees.tree(5) is tree
    assert trees.trees([5, 6, 5])[0] is tree
    assert trees.searches == 2
    trees.tree(5, forward=False)
    assert trees.searches == 3
    known = trees.table([5, 6], range(100))
    assert trees.searches == 3
    np.testing.assert_allclose(known, trees.engine.many_to_many([5, 6], range(100)))
    trees.table(range(50), [5])
    assert trees.searches == 3
    trees.table([7, 8, 9], [10, 5])
    assert trees.searches == 4


def test_the_oldest_rows_go_first(monkeypatch):
    net, weight = planar(300, 3)
    monkeypatch.setattr(trees_module, "KEPT_BYTES", 3 * 8 * net.n)
    trees = Trees(ReferenceEngine(net, weight))
    assert trees.costs(range(5)).shape == (5, net.n)
    assert trees.searches == 5
    trees.costs([2, 3, 4])
    assert trees.searches == 5
    trees.tree(0)
    trees.tree(2)
    assert trees.searches == 7


def test_a_pair_uses_the_searches_it_is_given():
    net, weight = planar(300, 6)
    weight = np.where(np.isfinite(weight), weight, 9.0)
    weights = EdgeWeights(weight, weight * 0.8, weight, "m", {})
    trees = Trees(ReferenceEngine(net, weight))
    main = np.flatnonzero(net.strong_component() == 0)
    ends = tuple(main[[0, 1]].tolist()), tuple(main[[-1, -2]].tolist())
    mine = plan_pair(net, weights, *ends, trees=trees)
    assert trees.searches == 4
    again = plan_pair(net, weights, *ends, trees=trees)
    assert trees.searches == 4
    assert mine.shared.tolist() == again.shared.tolist()
    assert mine.shared.tolist() == plan_pair(net, weights, *ends).shared.tolist()


WRONG_NODES = (
    None, "Torino", [0.5], [np.nan], [True, False], [[0, 1], [1, 2]], [0, None], {0}, [-1], [10**9],
    [2**70], [0, [1, 2]],
)  # fmt: skip
WRONG_WEIGHTS = (
    None, "fast", 1.0, lambda w: w[1:], lambda w: np.stack([w, w]), lambda w: w > 0.5,
    lambda w: w.astype(str), lambda w: -w, lambda w: w * np.nan, lambda w: w.astype(complex),
    lambda w: [*w.tolist()[:-1], None], lambda w: {"solo": w},
)  # fmt: skip


def refused(ask):
    """Assert that a call ends in one line that is a PlatoonError."""
    with pytest.raises(PlatoonError) as caught:
        ask()
    text = str(caught.value)
    assert text
    assert "\n" not in text
    assert len(text) < 200


@pytest.mark.parametrize("name", NAMES)
def test_wrong_nodes_are_refused(name):
    net, weight = planar(60, 1)
    engine = engines.engine_for(net, weight, name)
    trees = Trees(engine)
    for wrong in WRONG_NODES:
        for ask in (
            lambda w=wrong: engines.distances(net, weight, w, engine=name),
            lambda w=wrong: engines.tree(net, weight, w, engine=name),
            lambda w=wrong: engines.path(net, weight, w, 0, engine=name),
            lambda w=wrong: engines.path(net, weight, 0, w, engine=name),
            lambda w=wrong: po.many_to_many(net, weight, w, [0], engine=name),
            lambda w=wrong: po.many_to_many(net, weight, [0], w, engine=name),
            lambda w=wrong: engines.one_to_many(net, weight, w, [0], engine=name),
            lambda w=wrong: engines.one_to_many(net, weight, 0, w, engine=name),
            lambda w=wrong: engine.trees(w),
            lambda w=wrong: engine.tree(0).path(w),
            lambda w=wrong: trees.tree(w),
            lambda w=wrong: trees.costs(w),
            lambda w=wrong: trees.table(w, [0]),
            lambda w=wrong: trees.table([0], w),
            lambda w=wrong: astar(net, weight, w, 0, np.zeros(net.n)),
            lambda w=wrong: engine.best_on_route([0, 1], w, [0], [0.0, 1.0], [0.0, 1.0]),
            lambda w=wrong: engine.best_on_route(w, [0], [0], [0.0, 1.0], [0.0, 1.0]),
        ):
            refused(ask)


@pytest.mark.parametrize("name", NAMES)
def test_wrong_weights_and_labels_are_refused(name):
    net, weight = planar(60, 1)
    weight = np.where(np.isfinite(weight), weight, 2.0)
    labels = np.zeros(net.n)
    engine = engines.engine_for(net, weight, name)
    there = onward = [labels, labels]
    for item in WRONG_WEIGHTS:
        wrong = item(weight) if callable(item) else item
        refused(lambda w=wrong: engines.tree(net, w, 0, engine=name))
        refused(lambda w=wrong: net.attached(Searches).under(w, 1, name))
        refused(lambda w=wrong: engine.shared_stretch(w, there, onward, 1.0))
        refused(lambda w=wrong: astar(net, w, 0, 1, labels))
        short = item(labels + 1.0) if callable(item) else item
        refused(lambda w=short: engine.seeded(w))
        refused(lambda w=short: engine.shared_stretch(weight, [w, labels], onward, 1.0))
        refused(lambda w=short: engine.shared_stretch(weight, there, [labels, w], 1.0))
        refused(lambda w=short: astar(net, weight, 0, 1, w))


def test_swapped_and_other_arguments_are_refused():
    net, weight = planar(60, 1)
    searches = net.attached(Searches)
    two = [np.zeros(net.n)] * 2
    engine = ReferenceEngine(net, weight)
    for ask in (
        lambda: engine.shared_stretch(weight, two[0], two, 1.0),
        lambda: engine.shared_stretch(weight, two, None, 1.0),
        lambda: engine.shared_stretch(weight, two, two[:1], 1.0),
        lambda: po.many_to_many(weight, net, [0], [1]),
        lambda: engines.tree(weight, net, 0),
        lambda: engines.path(None, weight, 0, 1),
        lambda: engines.prepare(weight),
        lambda: Searches(weight),
        lambda: ReferenceEngine(weight, net),
        lambda: HierarchyEngine(weight, net),
        lambda: HierarchyEngine(net, weight, threads=0),
        lambda: HierarchyEngine(net, weight, threads="all"),
        lambda: searches.under(weight, engine="fast"),
        lambda: searches.under(weight, engine=weight),
        lambda: searches.under(weight, engine=None),
        lambda: searches.under(weight, "hierarchy"),
        lambda: searches.under(weight, -1),
        lambda: searches.under(weight, float("nan")),
        lambda: searches.under(weight, None),
        lambda: Trees(net),
    ):
        refused(ask)


@pytest.mark.parametrize("name", NAMES)
def test_routes_and_positions_that_do_not_fit_are_refused(name):
    net, weight = planar(60, 1)
    engine = engines.engine_for(net, weight, name)
    along, ends = np.arange(3.0), [0, 1]
    for change in (
        {"origins": [0]}, {"platoon": along[:2]}, {"length_m": None}, {"platoon": along * np.nan},
        {"entries": [0, 1, 2]}, {"entries": ([0, 1], [0])}, {"exits": ([0, 1, 2], [0, 9])},
        {"exits": ([0, 2, 1], [0])}, {"entries": ([0, 1, 1], [0.5])}, {"entries": 3},
    ):  # fmt: skip
        arguments = {
            "route": [0, 1, 2], "origins": ends, "destinations": ends, "platoon": along,
            "length_m": along,
        } | change  # fmt: skip
        refused(lambda a=arguments: engine.best_on_route(**a))


def test_refusals_are_value_errors_too():
    assert issubclass(SearchError, ValueError)
    assert issubclass(SearchError, PlatoonError)
