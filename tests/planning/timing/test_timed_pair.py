"""Case D within windows against trying all ways, all departures and all moments of meeting."""

from dataclasses import replace

import numpy as np
import pytest
from oracles import INF, all_pairs
from random_networks import network
from soak import SOAK, chosen, soaked

from platoon_osm.planning.timing.limits import Window
from platoon_osm.planning.timing.timed_pair import PairVehicle, plan_timed_pair
from platoon_osm.search.pareto_labels import Roads, _search, compiled_search

LAST = 24
"""All that happens in these tests happens in so many seconds."""


def simple_ways(net, weight, start):
    """All ways without a circle from a node, by where they end: edges in driving order."""
    found = {start: [()]}
    stack = [(start, (), {start})]
    while stack:
        node, edges, seen = stack.pop()
        for edge in range(net.m):
            head = int(net.head[edge])
            if net.tail[edge] == node and head not in seen and weight[edge] < INF:
                found.setdefault(head, []).append((*edges, edge))
                stack.append((head, (*edges, edge), seen | {head}))
    return found


def price_by_moment(vehicle, ways, wait_price):
    """What a vehicle has paid if it goes on from a node at each second, whenever it left."""
    window, paid = vehicle.window, np.full(LAST + 1, INF)
    first = -LAST if window.earliest is None else int(window.earliest)
    last = LAST if window.latest is None else int(window.latest)
    for edges in ways:
        cost, seconds = (float(w[list(edges)].sum()) for w in (vehicle.weight, vehicle.drive_s))
        for leaves in range(first, last + 1):
            for moment in range(max(leaves + int(seconds), 0), LAST + 1):
                wait = moment - leaves - int(seconds)
                paid[moment] = min(paid[moment], cost + wait_price * wait)
    return paid


def best_by_trying(net, vehicles, together, together_s, wait_price):
    """Least cost of both in company, and where they only meet, over all they can do in seconds."""
    best, apart = INF, INF
    came = [simple_ways(net, one.weight, one.origin) for one in vehicles]
    for x in range(net.n):
        if x not in came[0] or x not in came[1]:
            continue
        paid = sum(
            price_by_moment(one, ways[x], wait_price)
            for one, ways in zip(vehicles, came, strict=True)
        )
        for y, shared in simple_ways(net, together, x).items():
            on = [
                [
                    (float(one.weight[list(way)].sum()), float(one.drive_s[list(way)].sum()))
                    for way in simple_ways(net, one.weight, y).get(one.destination, ())
                ]
                for one in vehicles
            ]
            for edges in shared:
                cost, seconds = (float(w[list(edges)].sum()) for w in (together, together_s))
                for moment in np.flatnonzero(paid < INF):
                    rest = 0.0
                    for one, ways in zip(vehicles, on, strict=True):
                        by = INF if one.window.arrival is None else one.window.arrival
                        in_time = [
                            c + delay_cost(one, moment + seconds + t)
                            for c, t in ways
                            if moment + seconds + t <= by
                        ]
                        rest += min(in_time, default=INF)
                    total = float(paid[moment]) + cost + rest
                    best, apart = (min(best, total), apart) if edges else (best, min(apart, total))
    return best, apart


def delay_cost(vehicle, arrives_s):
    """What it costs to arrive later than alone, leaving as early as it may."""
    if vehicle.window.earliest is None:
        return 0.0
    return vehicle.delay_price * (arrives_s - vehicle.window.earliest - vehicle.alone_s)


def drawn_window(rng, alone_s):
    """A window as `limits` makes them: who names anything has an earliest departure."""
    if rng.random() < 0.1:
        return Window(None, None, None)
    first = int(rng.integers(0, 6))
    latest = int(first + rng.integers(0, 3)) if rng.random() < 0.6 else None
    last = first + alone_s + int(rng.integers(0, 6)) if rng.random() < 0.9 else None
    return Window(first, latest, last)


def drawn_pair(rng, price, delay=0.0):
    """Two vehicles on a small network of few ways, dear and quick or cheap and slow; exact sums."""
    n = int(rng.integers(4, 7))
    line, more = np.arange(n - 1), rng.integers(1, 5)
    tails = np.concatenate([line, line + 1, line, rng.integers(0, n, more)])
    heads = np.concatenate([line + 1, line, line + 1, rng.integers(0, n, more)])
    order = np.lexsort((heads, tails))
    net = network(tails[order], heads[order], np.ones(len(tails)))
    times = rng.integers(0, 5, net.m).astype(float)
    alike = rng.random() < 0.5
    vehicles = []
    # What is slow is cheap, more often than not.
    cost = 2 * (4 - times) + rng.integers(0, 5, net.m)
    for k in range(2):
        weight, drive_s = cost, times
        if not alike:
            drive_s = times + k * rng.integers(0, 2, net.m)
            weight = np.where(rng.random(net.m) < 0.1, INF, cost + k * rng.integers(0, 4, net.m))
        weight = weight + price * drive_s
        far, far_s = all_pairs(net, weight), all_pairs(net, drive_s)
        origin, destination = int(rng.integers(0, n - 2)), int(rng.integers(n - 2, n))
        rest = np.array([far[v][destination] for v in range(n)])
        window = drawn_window(rng, far_s[origin][destination])
        vehicles.append(
            PairVehicle(
                origin,
                destination,
                weight,
                drive_s,
                np.array(far[origin]),
                rest,
                window,
                far_s[origin][destination] + int(rng.integers(0, 3)) if delay else 0.0,
                delay,
            )
        )
    gain = rng.choice([0.5, 0.625, 0.75], net.m)
    together = gain * (vehicles[0].weight + vehicles[1].weight)
    together_s = np.maximum(vehicles[0].drive_s, vehicles[1].drive_s)
    return net, tuple(vehicles), together, together_s, price


def check_plan(net, vehicles, together, together_s, price, plan):
    """The plan's edges follow each other, are in time, and cost what the plan says."""
    cost = float(together[plan.shared].sum())
    assert len(plan.shared)
    away = plan.meets_s + float(together_s[plan.shared].sum())
    for k, one in enumerate(vehicles):
        way = np.concatenate([plan.before[k], plan.shared, plan.after[k]])
        nodes = net.path_nodes(way)
        assert (nodes[0], nodes[-1]) == (one.origin, one.destination)
        assert np.array_equal(net.head[way[:-1]], net.tail[way[1:]])
        cost += float(one.weight[plan.before[k]].sum() + one.weight[plan.after[k]].sum())
        cost += price * plan.waits_s[k]
        window = one.window
        leaves = plan.meets_s - plan.waits_s[k] - float(one.drive_s[plan.before[k]].sum())
        assert window.earliest is None or leaves >= window.earliest
        assert window.latest is None or leaves <= window.latest
        arrives = away + float(one.drive_s[plan.after[k]].sum())
        assert window.arrival is None or arrives <= window.arrival
        cost += delay_cost(one, arrives)
    assert cost == plan.cost


def compare(net, vehicles, together, together_s, price):
    solo_cost = sum(float(one.there[one.destination]) for one in vehicles)
    if solo_cost == INF:
        return None
    plan = plan_timed_pair(net, vehicles, together, together_s, solo_cost, price)
    least, apart = best_by_trying(net, vehicles, together, together_s, price)
    if plan is None:
        assert least >= min(solo_cost, apart)
        return None
    assert least <= apart
    assert plan.cost == least < solo_cost
    check_plan(net, vehicles, together, together_s, price, plan)
    free = [replace(one, window=Window(None, None, None)) for one in vehicles]
    blind = plan_timed_pair(net, tuple(free), together, together_s, solo_cost)
    return plan.cost, blind.cost


@soaked
@pytest.mark.parametrize(
    ("price", "delay"), [(0.0, 0.0), (0.5, 0.0), (2.0, 0.0), (0.0, 0.25), (0.5, 1.0)]
)
def test_all_that_can_be_done_is_tried(price, delay):
    rng = np.random.default_rng(None if SOAK else int(4 * price) + 2)
    found = [compare(*drawn_pair(rng, price, delay)) for _ in range(chosen(40, 1000))]
    # The clock decides often enough for this to say something about it.
    assert sum(costs is not None and costs[0] > costs[1] for costs in found) > 2


def two_ways(window, other):
    """Both drive 0 -> 1 -> 2 -> 3; from 1 to 2 lead a slow and cheap edge, and a quick and dear."""
    net = network([0, 1, 1, 2], [1, 2, 2, 3], [1, 1, 1, 1])
    weight, drive_s = np.array([10.0, 8, 10, 10]), np.array([10.0, 9, 5, 10])
    far = all_pairs(net, weight)
    rest = np.array([far[v][3] for v in range(4)])
    vehicles = tuple(
        PairVehicle(0, 3, weight, drive_s, np.array(far[0]), rest, one) for one in (window, other)
    )
    return net, vehicles, weight * 1.5, drive_s, 56.0


@pytest.mark.parametrize(("late", "cost"), [(0, 42.0), (1, 42.0), (2, 45.0), (5, 45.0)])
def test_the_clock_takes_the_quick_way(late, cost):
    # The first must be there after 30 s; they take 29 together, or 25 on the quick way.
    plan = plan_timed_pair(*two_ways(Window(0, None, 30), Window(late, None, 40)))
    assert (plan.cost, plan.meets_s) == (cost, late)


def test_who_comes_too_late_is_not_waited_for():
    assert plan_timed_pair(*two_ways(Window(0, None, 30), Window(6, None, 40))) is None


def test_who_must_leave_waits_and_pays_for_it():
    given = two_ways(Window(0, 1, 60), Window(3, None, 60))
    assert plan_timed_pair(*given).waits_s == (2.0, 0.0)
    plan = plan_timed_pair(*given, wait_price=0.25)
    assert (plan.cost, plan.waits_s) == (42.5, (2.0, 0.0))


def test_the_compiled_search_takes_the_same_labels():
    rng = np.random.default_rng(3)
    for _ in range(20):
        net, (one, _), together, together_s, _ = drawn_pair(rng, 0.5)
        roads = Roads.onward(net)
        for weights in ((one.weight, one.drive_s), (together, together_s)):
            ends = roads.first, roads.edges, roads.ends, *weights
            start = np.array([one.origin]), np.zeros(1), np.zeros(1)
            limits = one.rest, np.full(net.n, 20.0), float(one.rest[one.origin] + 9), 0.5, 1e-9
            slow, quick = (
                search(*ends, *start, *limits) for search in (_search, compiled_search())
            )
            for own, other in zip(slow, quick, strict=True):
                assert own.tolist() == other.tolist()
