"""The city tour: trucks go around the low bridge by the shortest way there is, the van does not."""

import importlib.util
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
from places import ROOT, SHARED

import platoon_osm as po
from platoon_osm.vehicles.profile import VEHICLES

EXTRACT = SHARED / "data" / "osm" / "harrisburg.osm.pbf"
spec = importlib.util.spec_from_file_location("tour", ROOT / "examples" / "harrisburg_tour.py")
tour = importlib.util.module_from_spec(spec)
spec.loader.exec_module(tour)

pytestmark = pytest.mark.skipif(not EXTRACT.exists(), reason="the extract is not installed")


@pytest.fixture(scope="module")
def net(tmp_path_factory):
    signed = tmp_path_factory.mktemp("tour") / "signed.osm.pbf"
    tour.with_tags(EXTRACT, signed, tour.MILROY_ROAD, tour.SIGN)
    return po.load_network(signed, tour.CLASSES)


@pytest.fixture(scope="module")
def plans(net):
    """The tour before and after trucks heed the sign."""
    return [
        po.plan_joint(net, po.PaperCosts(), tour.tour(truck))
        for truck in (tour.ANY_HEIGHT, tour.TRUCK)
    ]


def routes(plan):
    """All edges that a vehicle drives, in company and alone, by vehicle."""
    return {v.vehicle: (*v.edges, *v.alone.edges) for v in plan.vehicles}


def test_the_sign_stands_on_the_underpass_alone(net):
    signed = {int(way) for way, code in zip(net.way_id, net.restriction, strict=True) if code}
    assert signed == {tour.MILROY_ROAD}


def test_the_truck_goes_around_and_the_van_does_not(net, plans):
    below = [
        {name: tour.MILROY_ROAD in net.way_id[list(edges)] for name, edges in routes(plan).items()}
        for plan in plans
    ]
    assert below[0] == {"T1": True, "T2": False, "Van": True}
    assert below[1] == {"T1": False, "T2": False, "Van": True}


def test_without_the_sign_the_plan_is_that_of_heights_not_asked(plans):
    """What the page calls "heights not asked" is what the map as it was gives for real trucks."""
    before = po.plan_joint(
        po.load_network(EXTRACT, tour.CLASSES), po.PaperCosts(), tour.tour(tour.TRUCK)
    )
    for was, asked in zip(before.vehicles, plans[0].vehicles, strict=True):
        assert was.length_m == pytest.approx(asked.length_m)
        assert was.joint_cost == pytest.approx(asked.joint_cost)


def shortest(net, weights, edges, closed):
    """Cheapest way between the first and last edge of a route, by networkx, without a way."""
    graph = nx.MultiDiGraph()
    for edge in np.flatnonzero(net.way_id != tour.MILROY_ROAD) if closed else range(net.m):
        graph.add_edge(int(net.tail[edge]), int(net.head[edge]), weight=weights[edge])
    return nx.dijkstra_path_length(graph, int(net.head[edges[0]]), int(net.tail[edges[-1]]))


def test_the_detour_is_the_shortest_there_is(net, plans):
    weights = po.PaperCosts().weights(net, VEHICLES[tour.TRUCK]).solo
    before, after = (plan.vehicles[0].alone for plan in plans)
    assert (before.edges[0], before.edges[-1]) == (after.edges[0], after.edges[-1])
    for alone, closed in ((before, False), (after, True)):
        assert all(net.head[a] == net.tail[b] for a, b in pairwise(alone.edges))
        inner = sum(weights[list(alone.edges[1:-1])])
        assert inner == pytest.approx(shortest(net, weights, alone.edges, closed))
    detour = shortest(net, weights, after.edges, True) - shortest(net, weights, before.edges, False)
    assert after.cost - before.cost == pytest.approx(detour)
    assert after.length_m - before.length_m > 3_000


def test_without_the_extract_it_says_so(tmp_path, capsys):
    tour.main(tmp_path / "none.osm.pbf")
    assert capsys.readouterr().out.startswith("Skipped: there is no extract at ")
