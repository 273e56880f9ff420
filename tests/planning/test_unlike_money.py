"""Fleets of unlike mass and pace, paid in money: costs and bounds beside sums made edge by edge.

The sums know the formula of fuel, hours and prices alone: who drives an edge with whom, in which
place, as slowly as the slowest of them.
"""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import road_networks

from platoon_osm.costs.fuel import FUEL_SAVINGS
from platoon_osm.costs.money.objective import money_costs
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.vehicles.profile import vehicle_of

KINDS = (
    {"mass_t": 40.0, "limiter_kmh": 90.0},
    {"mass_t": 20.0, "limiter_kmh": 70.0},
    {"mass_t": 30.0, "limiter_kmh": 80.0, "height_m": 3.0},
)


class ByHand:
    """What driving an edge costs a vehicle by its place and the pace of its company."""

    def __init__(self, net, costs, kinds):
        self.net, self.costs = net, costs
        self.who = [vehicle_of(kind) for kind in kinds]
        self.pace = [
            net.length_m / np.minimum(net.speed_mps, one.limiter_kmh / 3.6) for one in self.who
        ]

    def edge(self, edge, company, place):
        """The cost of one vehicle of a company, its positions in the order in which they drive."""
        own = company[place]
        seconds = max(self.pace[one][edge] for one in company)
        speed = self.net.length_m[edge] / seconds
        physics, saving = self.costs.consumption, FUEL_SAVINGS[self.costs.positions]
        share = saving.by_position(len(company))[place]
        tested = vehicle_of({"mass_t": saving.tested_t})
        spared = share / float(physics.air_share(tested, saving.tested_kmh / 3.6))
        litres = physics.per_100km(self.who[own], speed * 3.6, spared)
        fuel = litres * self.net.length_m[edge] / 1e5 * self.costs.fuel_per_l
        return fuel + seconds * self.costs.driver_per_h / 3600

    def alone(self, own):
        """What each edge costs a vehicle alone."""
        return np.array([self.edge(edge, (own,), 0) for edge in range(self.net.m)])

    def plan(self, plan):
        """What the vehicles of a plan pay together."""
        return sum(
            self.edge(edge, stretch.vehicles, place)
            for stretch in plan.stretches
            for edge in stretch.edges
            for place in range(len(stretch.vehicles))
        )


def asked(data, net, count=3):
    ends = []
    for _ in range(count):
        origin, away = data.draw(st.integers(0, net.n - 1)), data.draw(st.integers(1, net.n - 1))
        ends.append((origin, (origin + away) % net.n))
    kinds = [KINDS[data.draw(st.integers(0, 2))] for _ in range(count)]
    costs = money_costs(
        "eu",
        positions=data.draw(st.sampled_from(["plafosim", "seed_18", "eddi", "nrel"])),
        driver_per_h=data.draw(st.sampled_from([0.0, 10.0, 33.0])),
        fuel_per_l=data.draw(st.sampled_from([1.3, 4.0])),
    )
    trips = [Trip("ABC"[k], *pair, profile=kinds[k]) for k, pair in enumerate(ends)]
    return trips, ends, kinds, costs


@settings(max_examples=25, deadline=None)
@given(road_networks(7), st.data())
def test_all_pay_what_one_adds_up_by_hand(net, data):
    trips, _, kinds, costs = asked(data, net)
    plan = plan_joint(net, costs, trips, optimum=data.draw(st.sampled_from(["member", "system"])))
    hand = ByHand(net, costs, kinds)
    assert plan.joint_cost == pytest.approx(hand.plan(plan))
    solo = [
        hand.alone(k)[list(trip.alone.edges)].sum() for k, trip in enumerate(plan.trips)
    ]  # fmt: skip
    assert [trip.alone.cost for trip in plan.trips] == pytest.approx(solo)
    assert plan.joint_cost <= plan.solo_cost * (1 + 1e-9)


@settings(max_examples=20, deadline=None)
@given(road_networks(6), st.data())
def test_no_company_of_one_master_costs_less_than_the_bound(net, data):
    trips, ends, kinds, costs = asked(data, net)
    plan = plan_joint(net, costs, trips, "C", optimum="system", master="A", company="master")
    hand = ByHand(net, costs, kinds)
    engines = [ReferenceEngine(net, hand.alone(k)) for k in range(3)]
    route = engines[0].tree(ends[0][0]).path(ends[0][1])
    nodes = [*net.tail[route].tolist(), int(net.head[route[-1]])]
    choices = list(itertools.combinations_with_replacement(range(len(route) + 1), 2))
    least = np.inf
    for points in itertools.product(choices, repeat=2):
        there = [[0] for _ in route]
        total = 0.0
        for k, (i, j) in enumerate(points, 1):
            (o, d), far = ends[k], engines[k].distances
            if i == j:
                total += far([o])[0, d]
                continue
            total += far([o])[0, nodes[i]] + far([nodes[j]])[0, d]
            for at in range(i, j):
                there[at].append(k)
        for edge, company in zip(route.tolist(), there, strict=True):
            total += sum(hand.edge(edge, company, place) for place in range(len(company)))
        least = min(least, total)
    # A plan may be cheaper than all of these, where its master's way has company of its own.
    bound = plan.proof.cost * (1 - (plan.proof.gap or 0))
    assert bound <= least * (1 + 1e-9)
    assert plan.proof.any_plan <= least * (1 + 1e-9)


@settings(max_examples=25, deadline=None)
@given(road_networks(7), st.data())
def test_two_free_routes_pay_no_less_than_their_bound(net, data):
    trips, ends, kinds, costs = asked(data, net, count=2)
    plan = plan_joint(net, costs, trips, "D")
    hand = ByHand(net, costs, kinds)
    assert plan.joint_cost == pytest.approx(hand.plan(plan))
    far = [ReferenceEngine(net, hand.alone(k)).distances(list(range(net.n))) for k in (0, 1)]
    pair = np.array([
        min(
            sum(hand.edge(edge, company, place) for place in (0, 1))
            for company in ((0, 1), (1, 0))
        )
        for edge in range(net.m)
    ])  # fmt: skip
    both = ReferenceEngine(net, pair).distances(list(range(net.n)))
    (o0, d0), (o1, d1) = ends
    shared = far[0][o0][:, None] + far[1][o1][:, None] + both + far[0][:, d0] + far[1][:, d1]
    least = min(float(shared.min()), far[0][o0, d0] + far[1][o1, d1])
    bound = plan.proof.cost * (1 - (plan.proof.gap or 0))
    assert bound <= least * (1 + 1e-9)
    assert plan.proof.any_plan is None or plan.proof.any_plan <= least * (1 + 1e-9)
