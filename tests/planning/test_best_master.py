"""The best master, company anywhere, and what no plan can undercut, against trying everything."""

from collections import Counter
from dataclasses import replace
from datetime import datetime, timedelta
from itertools import pairwise, product

import networkx as nx
import numpy as np
import pytest
from bundled import italy as italy_map
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import all_pairs, best_choice, member_choices
from random_networks import network, problems

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.planning import masters
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip

SOME = settings(max_examples=60, deadline=None)
DAY = datetime(2026, 3, 2)


# -- oracles ---------------------------------------------------------------------------------------


def least_way(net, weight, origin, destination):
    """The edges of a cheapest way, by networkx."""
    if origin == destination:
        return []
    graph = nx.MultiDiGraph()
    for edge in range(net.m):
        graph.add_edge(int(net.tail[edge]), int(net.head[edge]), key=edge, w=float(weight[edge]))
    nodes = nx.shortest_path(graph, origin, destination, weight="w")
    return [
        min(graph[a][b], key=lambda key, a=a, b=b: graph[a][b][key]["w"])
        for a, b in pairwise(nodes)
    ]


def company_cost(weights, ways):
    """What ways cost if all that drive an edge drive it together."""
    users = Counter(edge for way in ways for edge in set(way))
    total = 0.0
    for way in ways:
        total += sum(float(weights.solo[e]) for e in way if users[e] == 1)
    for edge, count in users.items():
        if count > 1:
            total += float(weights.master[edge] + (count - 1) * weights.platoon[edge])
    return total


def can_meet(ways):
    """Whether all that drive an edge can drive it at one time: no circle of edges in order."""
    order = nx.DiGraph()
    users = Counter(edge for way in ways for edge in set(way))
    for index, way in enumerate(ways):
        if len(set(way)) < len(way):
            return False
        names = [edge if users[edge] > 1 else (index, edge) for edge in way]
        order.add_edges_from(pairwise(names))
    return nx.is_directed_acyclic_graph(order)


def every_master_side_by_side(net, weights, trips):
    """Least cost over all masters if members choose for themselves, and all who drive an edge do so
    together; and over everyone alone."""
    alone = all_pairs(net, weights.solo)
    ends = [(trip.origin, trip.destination) for trip in trips]
    own = [least_way(net, weights.solo, *pair) for pair in ends]
    best = sum(alone[o][g] for o, g in ends)
    for master, route in enumerate(own):
        nodes = net.path_nodes(route)
        ways, star = [], 0.0
        gain = np.zeros(len(route), bool)
        for index, (o, g) in enumerate(ends):
            if index == master:
                ways.append(route)
                continue
            cost, _, i, j = best_choice(
                member_choices(net, weights, np.array(route), o, g, "C", alone)
            )
            star += cost
            if i < 0:
                ways.append(own[index])
            else:
                gain[i:j] = True
                before = least_way(net, weights.solo, o, int(nodes[i]))
                after = least_way(net, weights.solo, int(nodes[j]), g)
                ways.append([*before, *route[i:j], *after])
        edges = np.array(route)
        star += float(np.where(gain, weights.master[edges], weights.solo[edges]).sum())
        best = min(best, star)
        if can_meet(ways):
            best = min(best, company_cost(weights, ways))
    return best


def simple_ways(net, origin, destination):
    """All ways that meet no node twice, parallel edges told apart."""
    graph = nx.MultiDiGraph()
    graph.add_nodes_from(range(net.n))
    graph.add_edges_from(
        (int(net.tail[e]), int(net.head[e]), e) for e in range(net.m)
    )  # the key is the edge
    return [
        [edge for _, _, edge in path]
        for path in nx.all_simple_edge_paths(graph, origin, destination)
    ]


def cheapest_of_all(net, weights, trips):
    """Least cost over all ways of all vehicles if who drives an edge drives it together."""
    ways = [simple_ways(net, trip.origin, trip.destination) for trip in trips]
    if np.prod([len(own) for own in ways]) > 3000:
        return None
    return min(company_cost(weights, some) for some in product(*ways))


# -- without a clock -------------------------------------------------------------------------------


@SOME
@given(problems())
def test_no_master_with_all_side_by_side_is_cheaper(problem):
    net, weights, trips = problem
    plan = plan_joint(net, weights, trips, "C")
    assert plan.joint_cost <= every_master_side_by_side(net, weights, trips) * (1 + 1e-9)
    assert plan_joint(net, weights, trips).joint_cost <= plan.joint_cost * (1 + 1e-9)
    for vehicle in plan.vehicles:
        assert vehicle.joint_cost <= vehicle.solo_cost * (1 + 1e-9)


@SOME
@given(problems(most_trips=3), st.sampled_from(["member", "system"]))
def test_the_bound_is_below_every_plan_and_the_plan_above(problem, objective):
    net, weights, trips = problem
    least = cheapest_of_all(net, weights, trips)
    plan = plan_joint(net, weights, trips, "C", objective=objective)
    if least is None:
        return
    assert plan.proof.any_plan <= least * (1 + 1e-9)
    assert plan.joint_cost >= least * (1 - 1e-9)


def test_with_many_vehicles_those_that_cannot_win_are_skipped(monkeypatch):
    rng = np.random.default_rng(5)
    n = 30
    ring = np.arange(n)
    tails = np.concatenate([ring, ring, rng.integers(0, n, 30)])
    heads = np.concatenate([np.roll(ring, -1), np.roll(ring, 1), rng.integers(0, n, 30)])
    net = network(
        tails, heads, rng.uniform(5e3, 9e4, len(tails)),
        rng.uniform(8, 12, n), rng.uniform(44, 46, n),
    )  # fmt: skip
    weights = po.paper_weights(net)
    trips = []
    for k in range(25):
        origin = int(rng.integers(n))
        trips.append(Trip(f"V{k}", origin, int((origin + rng.integers(1, n)) % n)))
    rule = {"company": "master"}
    skipped = plan_joint(net, weights, trips, "C", **rule)
    assert len(skipped.masters) < len(trips)
    assert any("25 of 25 masters compared" in one for one in skipped.proof.conditions)
    each = [plan_joint(net, weights, trips, "C", master=t.vehicle, **rule) for t in trips]
    assert skipped.joint_cost == pytest.approx(min(plan.joint_cost for plan in each), rel=1e-9)
    monkeypatch.setattr(masters, "FULLY_TRIED", 99)
    assert plan_joint(net, weights, trips, "C", **rule).joint_cost == pytest.approx(
        skipped.joint_cost, rel=1e-9
    )


@SOME
@given(
    problems(),
    st.integers(2, 3),
    st.sampled_from(["A", "B", "C", "best"]),
    st.sampled_from(["member", "system"]),
)
def test_no_platoon_is_larger_than_allowed(problem, most, case, objective):
    net, weights, trips = problem
    plan = plan_joint(net, weights, trips, case, max_platoon=most, objective=objective)
    assert max(len(stretch.vehicles) for stretch in plan.stretches) <= most
    assert plan.joint_cost <= plan.solo_cost * (1 + 1e-9)
    assert plan.proof.any_plan <= plan.joint_cost
    everyone = plan_joint(net, weights, trips, case, max_platoon=len(trips) + 1)
    assert everyone.joint_cost == plan_joint(net, weights, trips, case).joint_cost


def test_four_on_one_road_are_two_platoons_of_two():
    net = network([0, 1], [1, 2], [50e3, 50e3])
    trips = [Trip(name, 0, 2) for name in "ABCD"]
    plan = plan_joint(net, po.paper_weights(net), trips, "C", max_platoon=2)
    assert sorted(stretch.vehicles for stretch in plan.stretches) == [(0, 1), (2, 3)]
    assert [platoon.vehicles for platoon in plan.platoons] == [(0, 1), (2, 3)]
    assert [vehicle.role for vehicle in plan.vehicles] == ["master", "member"] * 2


def test_company_off_the_masters_route_is_a_platoon():
    # A drives 0-1-2-3. B and C share 10 km to 5 after they leave A at 2.
    net = network([0, 1, 2, 2, 4, 5], [1, 2, 3, 5, 1, 6], [90e3, 90e3, 90e3, 40e3, 5e3, 20e3])
    trips = [Trip("A", 0, 3), Trip("B", 0, 6), Trip("C", 4, 6)]
    plan = plan_joint(net, po.paper_weights(net), trips, "C", master="A")
    together = {stretch.vehicles for stretch in plan.stretches if stretch.together}
    assert (1, 2) in together
    alone = plan_joint(net, po.paper_weights(net), trips, "C", master="A", company="master")
    assert plan.joint_cost < alone.joint_cost
    assert {len(s.vehicles) for s in alone.stretches if set(s.vehicles) == {1, 2}} == set()


def test_under_member_nobody_loses_and_the_plan_says_what_d_would_save():
    # A comes 12 km round by South to pick B up: cheaper for both together, and dearer for A.
    from platoon_osm.costs.weights import EdgeWeights

    km = np.array([10.0, 12.0, 10.0, 9.0])
    net = network([0, 0, 1, 2], [1, 2, 3, 3], km * 1000)
    weights = EdgeWeights(km * 3, km * 1.8, km * 2.9, "EUR", {})
    trips = [Trip("A", 0, 3), Trip("B", 2, 3)]
    best = plan_joint(net, weights, trips)
    assert all(one.joint_cost <= one.solo_cost for one in best.vehicles)
    system = plan_joint(net, weights, trips, objective="system")
    assert system.joint_cost <= best.joint_cost
    asked = plan_joint(net, weights, trips, "D")
    if asked.joint_cost < best.joint_cost:
        assert any("would save" in remark for remark in best.remarks)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"max_platoon": 1}, "max_platoon is 1; give a whole number, 2 or more"),
        ({"max_platoon": 2.5}, "max_platoon is 2.5"),
        ({"max_platoon": True}, "max_platoon is True"),
        ({"patience_min": -1}, "patience_min is -1; give minutes"),
        ({"patience_min": float("nan")}, "patience_min is nan"),
        ({"patience_min": "2 h"}, "patience_min is '2 h'"),
        ({"company": "nowhere"}, "company 'nowhere' is unknown; use anywhere, master"),
        ({"master": "shortest"}, "master 'shortest' has no trip"),
    ],
)
def test_what_is_refused(options, message):
    net = network([0, 1], [1, 2], [50e3, 50e3])
    with pytest.raises(ScenarioError, match=message.replace(".", r"\.")):
        plan_joint(net, po.paper_weights(net), [Trip("A", 0, 2), Trip("B", 0, 1)], **options)


# -- the Italian example ---------------------------------------------------------------------------

SOUTH = [("Milano", "Napoli"), ("Torino", "Napoli"), ("Venezia", "Salerno"), ("Brescia", "Roma")]


def test_milano_leads_to_napoli():
    net = italy_map()
    costs = po.paper_weights(net)
    trips = [Trip(places[0], *places) for places in SOUTH]
    best = plan_joint(net, costs, trips, "C")
    longest = plan_joint(net, costs, trips, "C", master="longest", company="master")
    assert (f"{best.saving:.1%}", f"{longest.saving:.1%}") == ("24.6%", "17.0%")
    masters = [vehicle.vehicle for vehicle in best.vehicles if vehicle.role == "master"]
    assert masters == ["Milano"]
    assert len(best.masters) == 4
    assert "master Milano on its own route" in best.proof.conditions
    # Side by side from Bologna to Firenze, though not with the master.
    beside = plan_joint(net, costs, trips, "C", master="longest")
    assert beside.saving > longest.saving


# -- with a clock ----------------------------------------------------------------------------------


@st.composite
def timed(draw):
    net, weights, trips = draw(problems())
    found = []
    for trip in trips:
        first = draw(st.none() | st.integers(0, 600))
        last = draw(st.none() | st.integers(first or 0, 700))
        arrival = draw(st.none() | st.integers((first or 0) + 1, 1500))
        times = [
            None if at is None else DAY + timedelta(minutes=at) for at in (first, last, arrival)
        ]
        found.append(Trip(trip.vehicle, trip.origin, trip.destination, *times))
    return net, weights, found


@settings(max_examples=100, deadline=None)
@given(timed(), st.sampled_from(["A", "C", "best"]), st.sampled_from([0, 30, 120]))
def test_nobody_is_moved_beyond_its_patience_or_late_for_company(problem, case, patience):
    net, weights, trips = problem
    plan = plan_joint(net, weights, trips, case, patience_min=patience)
    if plan.timetable is None:
        return
    zero = datetime.fromisoformat(plan.timetable.start)
    near = timedelta(seconds=0.05)
    for trip, vehicle, times in zip(trips, plan.vehicles, plan.timetable.vehicles, strict=True):
        leaves = zero + timedelta(seconds=times.departure_s)
        arrives = zero + timedelta(seconds=times.arrival_s)
        alone = timedelta(seconds=vehicle.alone.time_s)
        first, last, end = trip.earliest_departure, trip.latest_departure, trip.latest_arrival
        grace = timedelta(minutes=patience)
        if end is not None:
            in_time = max(end, first + alone) if first else end
            if not (last and first is None):
                assert arrives <= in_time + near
        elif last or first:
            assert arrives <= (last or first) + alone + grace + near
        if first:
            assert leaves >= first - near
        elif last or end:
            assert leaves >= min(x for x in (last, end and end - alone) if x) - grace - near
        late = end is not None and arrives > end + near
        if late and first:
            assert first + alone > end - near  # late even alone


@settings(max_examples=60, deadline=None)
@given(timed())
def test_a_master_that_does_not_wait_is_never_cheaper(problem):
    """Against all departures of the master in whole minutes, and all points of the members."""
    net, weights, trips = problem
    rule = {"master": "A", "company": "master"}
    plan = plan_joint(net, weights, trips, "C", **rule)
    blind = plan_joint(
        net, weights, [replace(t, **dict.fromkeys(t.times)) for t in trips], "C", **rule
    )
    if plan.timetable is None or trips[0].earliest_departure is None:
        return
    seconds = net.length_m / net.speed_mps
    alone = all_pairs(net, weights.solo)
    route = np.array(blind.vehicles[0].alone.edges)
    nodes = net.path_nodes(route)
    tau = np.concatenate([[0.0], np.cumsum(seconds[route])])
    limits = [limits_of(t, v.alone.time_s) for t, v in zip(trips, plan.vehicles, strict=True)]
    first, latest, end = limits[0]
    last = min(x for x in (latest, None if end is None else end - tau[-1]) if x is not None)
    ways = {}

    def drive(a, b):
        if (a, b) not in ways:
            ways[a, b] = float(seconds[least_way(net, weights.solo, a, b)].sum())
        return ways[a, b]

    least = np.inf
    for start in np.arange(first, last + 1, 600.0):
        total, met = 0.0, np.zeros(len(route), bool)
        for k, trip in enumerate(trips[1:], 1):
            choices = []
            for choice in member_choices(
                net, weights, route, trip.origin, trip.destination, "C", alone
            ):
                _, _, i, j = choice
                early, _, until = limits[k]
                if i >= 0 and (
                    (early is not None
                     and early + drive(trip.origin, int(nodes[i])) > start + tau[i] + 1e-6)
                    or (until is not None
                        and start + tau[j] + drive(int(nodes[j]), trip.destination) > until + 1e-6)
                ):  # fmt: skip
                    continue
                choices.append(choice)
            cost, _, i, j = best_choice(choices)
            total += cost
            if i >= 0:
                met[i:j] = True
        total += float(np.where(met, weights.master[route], weights.solo[route]).sum())
        least = min(least, total)
    # Members choose for themselves; the master's own gain may differ with their points.
    slack = float((weights.solo - weights.master)[route].sum())
    assert plan.joint_cost <= least + slack + 1e-6


def limits_of(trip, alone_s, patience_s=7200.0):
    """The rule of timing.limits in seconds from DAY, written down once more."""
    first, last, end = (
        None if at is None else (at - DAY).total_seconds()
        for at in (trip.earliest_departure, trip.latest_departure, trip.latest_arrival)
    )
    early = first
    if first is None:
        before = [x for x in (last, None if end is None else end - alone_s) if x is not None]
        early = min(before) - patience_s if before else None
    if end is None:
        leaves = last if last is not None else first
        until = None if leaves is None else leaves + alone_s + patience_s
    else:
        until = end if first is None else max(end, first + alone_s)
    return early, last, until


def test_two_days_apart_both_drive_alone():
    net = italy_map()
    first = DAY + timedelta(hours=6)
    trips = [
        Trip("Expr", "Milano", "Napoli", first, None, first + timedelta(hours=12)),
        Trip("Next day", "Torino", "Roma", first + timedelta(days=2)),
    ]
    for some in (trips, [replace(trips[0], latest_arrival=None), trips[1]]):
        plan = plan_joint(net, po.paper_weights(net), some)
        assert not any(stretch.together for stretch in plan.stretches)
        assert plan.timetable.feasible
        assert plan.timetable.vehicles[0].held_s == pytest.approx(0, abs=0.01)
        assert "the clock forbids" in plan.vehicles[1].reason
        assert plan.proof["kind"] == "exact"
        assert plan.proof.conditions[0].endswith("on its own route, whether it waits or not")
    # One without any time goes along with whoever there is.
    flexible = [trips[0], Trip("Next day", "Torino", "Roma")]
    assert plan_joint(net, po.paper_weights(net), flexible).saving > 0.1


def test_who_cannot_come_in_time_is_left_and_the_others_drive_together():
    net = italy_map()
    first = DAY + timedelta(hours=6)
    trips = [
        Trip("A", "Milano", "Napoli", first),
        Trip("B", "Torino", "Roma", first - timedelta(hours=1)),
        Trip("C", "Brescia", "Salerno", first + timedelta(hours=30)),
    ]
    plan = plan_joint(net, po.paper_weights(net), trips)
    roles = {vehicle.vehicle: vehicle.role for vehicle in plan.vehicles}
    assert roles["C"] == "alone"
    assert sorted([roles["A"], roles["B"]]) == ["master", "member"]
