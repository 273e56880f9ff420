"""Nobody is late alone who has a way to be in time: compared with all ways on small networks."""

import random
from datetime import datetime, timedelta

import networkx as nx
import numpy as np
import pytest
from legal_trips import fastest

import platoon_osm as po
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.driving.eu561 import EU561
from platoon_osm.driving.state import RESTED
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.report.language.plan_sentences import in_language
from platoon_osm.report.language.speech import speaking

DAY = datetime(2026, 3, 3, 6)
NODES = 6


def drawn(rng, longest_min):
    """Return a network with costs that do not follow times, whole minutes an edge."""
    pairs = {(0, 1), (1, NODES - 1)} | {
        (a, b) for a in range(NODES) for b in range(NODES) if a != b and rng.random() < 0.45
    }
    tail, head = zip(*sorted(pairs), strict=True)
    minutes = np.array([rng.randint(longest_min // 8, longest_min) for _ in pairs], float)
    cost = np.array([float(rng.randint(1, 9)) for _ in pairs])
    net = RoadNetwork.from_edges(
        tail, head, minutes * 60 * 20.0, lon=9 + np.arange(NODES) / 10,
        lat=45 + (np.arange(NODES) % 3) / 10, speed_mps=20.0,
    )  # fmt: skip
    return net, EdgeWeights(cost, cost * 0.9, cost * 0.95, "m", {})


def every_way(net, weights):
    """Return cost and minutes of edges of all simple ways from the first to the last node."""
    graph = nx.DiGraph()
    for edge in range(net.m):
        seconds = float(net.length_m[edge] / net.speed_mps[edge])
        graph.add_edge(
            int(net.tail[edge]), int(net.head[edge]),
            cost=float(weights.solo[edge]), minutes=round(seconds / 60),
        )  # fmt: skip
    found = []
    for path in nx.all_simple_edge_paths(graph, 0, NODES - 1):
        own = [graph.edges[pair] for pair in path]
        found.append((sum(one["cost"] for one in own), [one["minutes"] for one in own]))
    return found


def least_late(ways, lasts_min, most_min):
    """Return cost and duration of the cheapest way that is in time, else of the least late."""
    timed = [(cost, lasts_min(minutes)) for cost, minutes in ways]
    in_time = [one for one in timed if one[1] <= most_min]
    if in_time:
        return min(in_time)
    return min(timed, key=lambda one: (one[1], one[0]))


def with_breaks(minutes):
    """Return how long a way takes within the law, pausing at any node [min]."""
    road = road_of([60 * one for one in minutes], [NO_LIMIT] * (len(minutes) + 1))
    return fastest(road, EU561, RESTED, 0, 0).arrival_s / 60


@pytest.mark.parametrize(("rules", "longest_min"), [("none", 60), ("eu561", 260)])
def test_the_cheapest_way_that_is_in_time_is_taken(rules, longest_min):
    rng = random.Random(4)
    lasts = sum if rules == "none" else with_breaks
    quicker = late = 0
    for _ in range(60 if rules == "none" else 40):
        net, weights = drawn(rng, longest_min)
        ways = every_way(net, weights)
        most = rng.randint(longest_min // 2, 3 * longest_min)
        cost, minutes = least_late(ways, lasts, most)
        others = [po.Trip("B", 0, NODES - 1, DAY)] * rng.randint(0, 1)
        trip = po.Trip("A", 0, NODES - 1, DAY, None, DAY + timedelta(minutes=most))
        plan = po.plan_joint(net, weights, [trip, *others], rules=rules)
        alone = plan.trips[0].alone
        times = plan.timetable.vehicles[0]
        assert (times.late_s > 0) == (minutes > most)
        assert times.late_s <= max(0, minutes - most) * 60 + 1
        if not others:
            assert alone.cost == cost
            assert times.arrival_s - times.departure_s <= minutes * 60 + 1
        told = any("takes a quicker route" in one for one in plan.remarks)
        assert told == (alone.cost > min(one for one, _ in ways))
        assert plan.joint_cost <= plan.solo_cost + 1e-9
        bound = plan.proof.bound
        assert bound is None or bound <= plan.joint_cost + 1e-9
        quicker, late = quicker + told, late + (minutes > most)
    assert quicker >= 5
    assert late >= 2


def test_it_is_told_in_each_language():
    text = (
        "A takes a quicker route than its cheapest, by which it would be late even alone by 5 min"
    )
    for language in ("de", "it"):
        with speaking(language):
            assert in_language(text) != text
