"""Slow and plain: the answers the planner must give, found by trying everything."""

from itertools import product

import numpy as np

INF = float("inf")


def all_pairs(net, weight):
    """Floyd-Warshall."""
    far = [[INF] * net.n for _ in range(net.n)]
    for node in range(net.n):
        far[node][node] = 0.0
    for edge in range(net.m):
        tail, head = net.tail[edge], net.head[edge]
        far[tail][head] = min(far[tail][head], float(weight[edge]))
    for via, tail, head in product(range(net.n), repeat=3):
        far[tail][head] = min(far[tail][head], far[tail][via] + far[via][head])
    return far


def all_pairs_longest(net, weight):
    """Floyd-Warshall under (cost, -metres): of the least-cost ways the longest."""
    far = [[(INF, 0.0)] * net.n for _ in range(net.n)]
    for edge in range(net.m):
        tail, head = net.tail[edge], net.head[edge]
        way = (float(weight[edge]), -float(net.length_m[edge]))
        far[tail][head] = min(far[tail][head], way)
    for node in range(net.n):
        far[node][node] = min(far[node][node], (0.0, 0.0))
    for via, tail, head in product(range(net.n), repeat=3):
        first, second = far[tail][via], far[via][head]
        far[tail][head] = min(far[tail][head], (first[0] + second[0], first[1] + second[1]))
    return far


def member_choices(net, weights, route, origin, destination, case, alone):
    """All that a member can do: (cost, metres together, merging position, separation position).

    Staying alone is the choice with positions -1; `alone` are the costs from `all_pairs`.
    """
    nodes = net.path_nodes(route)
    choices = [(alone[origin][destination], 0.0, -1, -1)]
    for i in range(len(nodes)):
        for j in range(i + 1, len(nodes)):
            if case == "A" and nodes[j] != destination:
                continue
            if case == "B" and nodes[i] != origin:
                continue
            shared = route[i:j]
            cost = (
                alone[origin][nodes[i]]
                + float(weights.platoon[shared].sum())
                + alone[nodes[j]][destination]
            )
            if cost < INF:
                choices.append((cost, float(net.length_m[shared].sum()), i, j))
    return choices


def best_choice(choices):
    """Least cost, then the longest platoon, then the smallest merging position."""
    return min(choices, key=lambda choice: (choice[0], -choice[1], choice[2]))


def system_optimum(net, weights, route, trips, case):
    """Least cost of master and members together over all combinations of choices."""
    gain = (weights.solo - weights.master)[route]
    best = INF
    alone = all_pairs(net, weights.solo)
    choices = [member_choices(net, weights, route, *trip, case, alone) for trip in trips]
    for combination in product(*choices):
        company = np.zeros(len(route), bool)
        for _, _, i, j in combination:
            if i >= 0:
                company[i:j] = True
        best = min(best, sum(choice[0] for choice in combination) - float(gain[company].sum()))
    return best + float(weights.solo[route].sum())


def pair_optimum(net, weights, origins, destinations):
    """Least (cost, -metres together) of two vehicles over all pairs of nodes (x, y)."""
    alone = all_pairs(net, weights.solo)
    both = all_pairs_longest(net, weights.master + weights.platoon)
    (o1, o2), (g1, g2) = origins, destinations
    best = (alone[o1][g1] + alone[o2][g2], 0.0)
    for x, y in product(range(net.n), repeat=2):
        cost, metres = both[x][y]
        before = alone[o1][x] + alone[o2][x]
        after = alone[y][g1] + alone[y][g2]
        best = min(best, (before + cost + after, metres))
    return best
