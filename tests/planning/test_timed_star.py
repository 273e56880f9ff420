"""Time in the choice, against a count over departures, ways, points and waits in whole seconds."""

import itertools
from datetime import datetime, timedelta
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import platoon_osm as po
from platoon_osm.costs.time_prices import TimePrices
from platoon_osm.planning.answers import ANY_WAIT, NO_WAIT
from platoon_osm.planning.asked import Asked
from platoon_osm.planning.company.draft import Draft
from platoon_osm.planning.no_wait import best_without_waiting, bound_if_waiting
from platoon_osm.planning.timed_star import TimedStar

DAY = datetime(2026, 3, 2)


class Costs:
    """Whole costs of edges, and prices of waiting and delay."""

    name, unit, params = "whole", "m", {}

    def __init__(self, solo, platoon, master, price=0.0, late=0.0):
        self.solo, self.platoon, self.master, self.price = solo, platoon, master, price
        self.late = late

    def weights(self, net, _vehicle=None):
        return po.EdgeWeights(
            solo=self.solo, platoon=self.platoon, master=self.master, unit="m", params={},
            network=net.identity(),
        )  # fmt: skip

    def waiting(self, seconds):
        return self.price * seconds

    def delay(self, seconds):
        return self.late * seconds


@st.composite
def problems(draw, price=0.0, vehicles=(2, 3), late=0.0):
    """A road 0 .. k that the master drives, and members with ways onto it and off, cheap or quick.

    Costs and times of edges have nothing to do with each other.
    """
    k = 3
    pairs, solo, time_s, trips = [], [], [], []

    def edge(start, end, low, high):
        pairs.append((start, end))
        solo.append(draw(st.integers(low, high)))
        time_s.append(draw(st.integers(1, 8)))

    for at in range(k):
        edge(at, at + 1, 10, 14)
    n = k + 1
    for index in range(draw(st.integers(*vehicles))):
        start, end = 0, k
        first = draw(st.integers(0, 12))
        if index:
            start, end, n = n, n + 1, n + 2
            for node in draw(st.lists(st.integers(0, 1), min_size=1, max_size=2)):
                edge(start, node, 1, 9)
                edge(start, node, 1, 9)
            for node in draw(st.lists(st.integers(2, k), min_size=1, max_size=2)):
                edge(node, end, 1, 9)
                edge(node, end, 1, 9)
            edge(start, end, 25, 60)
        leave = draw(st.none() | st.integers(first, first + 12))
        arrive = first + draw(st.integers(12, 40))
        trips.append((f"V{index}", start, end, first, leave, arrive))
    order = np.argsort([a for a, _ in pairs], kind="stable")
    alone = np.array(solo, float)[order]
    platoon = np.floor(alone * draw(st.sampled_from([0.5, 0.8])))
    master = draw(st.sampled_from([platoon, platoon, alone]))
    net = po.RoadNetwork.from_edges(
        [a for a, _ in pairs], [b for _, b in pairs], np.array(time_s, float),
        lon=np.arange(n) / 1000, lat=(np.arange(n) % 2) / 1000, speed_mps=1.0,
    )  # fmt: skip
    return net, Costs(alone, platoon, master, price, late), trips


def paths_between(net, start, end):
    """All ways that meet no node twice, as edges."""
    found = []

    def walk(node, seen, path):
        if node == end:
            found.append(path)
        for edge in range(net.m):
            to = int(net.head[edge])
            if int(net.tail[edge]) == node and to not in seen:
                walk(to, seen | {to}, (*path, edge))

    walk(start, {start}, ())
    return found


def asked_of(problem, optimum="member", case="C"):
    net, costs, rows = problem
    trips = [
        po.Trip(name, start, end, *(
            None if at is None else DAY + timedelta(seconds=at) for at in (first, leave, arrive)
        ))
        for name, start, end, first, leave, arrive in rows
    ]  # fmt: skip
    try:
        return Asked.of(
            po.Problem(net, trips, costs, case=case, master="V0", company="master", optimum=optimum)
        )
    except po.PlatoonError:
        return None


class Count:
    """The same problem, by counting."""

    def __init__(self, problem, question):
        self.net, self.costs, self.rows = problem
        self.time = self.net.length_m / self.net.speed_mps
        self.route = question.alone[0].tolist()
        self.nodes = self.net.path_nodes(question.alone[0]).tolist()
        self.alone = [
            (sum(self.costs.solo[own.tolist()]), sum(self.time[own.tolist()]))
            for own in question.alone
        ]
        self.tau = [0, *itertools.accumulate(int(self.time[e]) for e in self.route)]
        self.ways = {}
        # Seconds of the planner count from the first moment that a trip names.
        self.shift = min(first for _, _, _, first, _, _ in self.rows)

    def points(self, start, end):
        """Cost and time of every way."""
        if (start, end) not in self.ways:
            every = {
                (sum(self.costs.solo[list(p)]), int(sum(self.time[list(p)])))
                for p in paths_between(self.net, start, end)
            }
            if self.costs.price:
                # Nobody takes a dearer and slower way to wait less.
                every = {
                    (c, t) for c, t in every
                    if not any(a <= c and b <= t and (a, b) != (c, t) for a, b in every)
                }  # fmt: skip
            self.ways[start, end] = every
        return self.ways[start, end]

    def until(self, k):
        _, _, _, first, _, arrive = self.rows[k]
        return max(arrive, first + self.alone[k][1])

    def choices(self, k, here):
        """What a member can do if the master is at its nodes at these moments: cost and points."""
        _, start, end, first, leave, _ = self.rows[k]
        found = [(self.alone[k][0], -1, -1)]
        for i in range(len(self.nodes)):
            for cost_in, time_in in self.points(start, self.nodes[i]):
                if first + time_in > here[i]:
                    continue
                latest = here[i] if leave is None else min(leave + time_in, here[i])
                waits = here[i] - latest
                for j in range(i + 1, len(self.nodes)):
                    between = sum(self.costs.platoon[self.route[i:j]])
                    for cost_out, time_out in self.points(self.nodes[j], end):
                        if here[j] + time_out <= self.until(k):
                            total = cost_in + between + cost_out + self.costs.price * waits
                            arrives = here[j] + time_out
                            total += self.costs.late * (arrives - first - self.alone[k][1])
                            found.append((total, i, j))
        return found

    def gain(self, pairs):
        met = {self.route[at] for i, j in pairs for at in range(i, j)}
        return sum(self.costs.solo[e] - self.costs.master[e] for e in met)

    def members_pay(self, here):
        """What all pay if each member pays least itself; the longest platoon of equals."""
        total, pairs = self.master_pays(here), []
        length = self.net.length_m
        for k in range(1, len(self.rows)):
            every = self.choices(k, here)
            least = min(cost for cost, _, _ in every)
            _, i, j = min(
                (one for one in every if one[0] == least),
                key=lambda one: (-sum(length[self.route[max(one[1], 0) : max(one[2], 0)]]), one[1]),
            )
            total += least
            if i >= 0:
                pairs.append((i, j))
        return total - self.gain(pairs)

    def system_pays(self, here):
        """What all pay if members choose for all."""
        best = np.inf
        every = []
        for k in range(1, len(self.rows)):
            least = {}
            for cost, i, j in self.choices(k, here):
                least[i, j] = min(cost, least.get((i, j), np.inf))
            every.append([(cost, pair) for pair, cost in least.items()])
        for some in itertools.product(*every):
            cost = sum(cost for cost, _ in some)
            best = min(best, cost - self.gain([pair for _, pair in some if pair[0] >= 0]))
        return best + self.master_pays(here)

    def master_pays(self, here):
        return self.alone[0][0] + self.costs.late * (here[0] - self.rows[0][3])

    def departures(self):
        _, _, _, first, leave, _ = self.rows[0]
        last = self.until(0) - self.tau[-1]
        return range(first, int(last if leave is None else min(last, leave)) + 1)

    def timetables(self, most):
        """Moments at the nodes of a master that waits at any of them up to some seconds."""
        _, _, _, first, leave, _ = self.rows[0]
        for start in range(first, first + most + 1):
            if leave is not None and start > leave:
                continue
            for waits in itertools.product(range(most + 1), repeat=len(self.nodes) - 1):
                late = [0, *itertools.accumulate(waits)]
                # It waits at a node before it drives on from there.
                here = [start + late[min(at + 1, len(waits))] + self.tau[at]
                        for at in range(len(self.nodes))]  # fmt: skip
                if here[-1] <= self.until(0):
                    yield here


@given(problem=problems() | problems(price=0.5) | problems(late=0.25))
@settings(max_examples=40)
def test_each_member_pays_least_at_the_best_departure(problem):
    asked = asked_of(problem)
    if asked is None:
        return
    question, count = asked.question, Count(problem, asked.question)
    star = question.star(0)
    clocked = TimedStar(question, star)
    best = best_without_waiting(clocked, "C")
    every = {
        at: count.members_pay([at + tau for tau in count.tau]) for at in count.departures()
    }  # fmt: skip
    assert best is not None
    assert best.is_proved
    at = best.departure
    if (second := at + count.shift) == round(second):
        assert best.choice.cost == pytest.approx(every[round(second)])
    assert best.choice.bound <= min(every.values()) + 1e-9
    if clocked.is_free or not clocked.gains.gain.any():
        assert best.choice.cost == pytest.approx(min(every.values()))
        assert best.choice.bound == pytest.approx(min(every.values()))
    # A way that is taken costs and takes what was counted.
    points = clocked.points("C")
    found = best.choice.points
    for row, vehicle in enumerate(star.members):
        i, j = int(found.merge_index[row]), int(found.separation_index[row])
        if i >= 0:
            into = clocked.way(points, at, vehicle, i, True)
            onward = clocked.way(points, at, vehicle, j, False)
            cost_in, time_in = points.entry_way(row, i, at)
            cost_out, time_out = points.exit_way(row, j, at, clocked.delays)
            assert sum(problem[1].solo[into]) == cost_in
            assert sum(problem[1].solo[onward]) == cost_out
            assert sum(count.time[into]) <= time_in
            assert sum(count.time[onward]) <= time_out


@given(problem=problems(vehicles=(2, 4)) | problems(price=0.5) | problems(price=0.5, late=0.25))
@settings(max_examples=40)
def test_for_all_together_the_bound_is_below_the_best_and_the_plan_is_one(problem):
    asked = asked_of(problem, "system")
    if asked is None:
        return
    count = Count(problem, asked.question)
    best = best_without_waiting(TimedStar(asked.question, asked.question.star(0)), "C")
    least = min(count.system_pays([at + tau for tau in count.tau]) for at in count.departures())
    assert best.choice.bound <= least + 1e-6
    assert best.choice.cost >= least - 1e-6
    if len(problem[2]) == 2:
        assert best.choice.cost == pytest.approx(least)
        assert best.choice.bound == pytest.approx(least)


@given(problem=problems(price=0.5, late=0.25) | problems(late=1.0) | problems(price=2.0))
@settings(max_examples=30)
def test_what_time_costs_at_least_is_what_counting_finds(problem):
    """For a draft: the least of all departures and waits of its master, at all its nodes."""
    asked = asked_of(problem)
    if asked is None:
        return
    question, count = asked.question, Count(problem, asked.question)
    clocked = TimedStar(question, question.star(0))
    points = clocked.points("C")
    best = best_without_waiting(clocked, "C")
    chosen, at = best.choice.points, best.departure
    routes = question.star(0).routes(chosen, partial(clocked.way, points, at))
    found = question.time_cost(Draft.of(routes))
    driven = sum(Draft.of(routes).costs(question.fleet))
    # No dearer than the departure at which the choice was made.
    assert driven + found <= best.choice.cost + 1e-4
    ways = []
    for row, vehicle in enumerate(clocked.star.members):
        i, j = int(chosen.merge_index[row]), int(chosen.separation_index[row])
        if i >= 0:
            into, onward = (
                clocked.way(points, at, vehicle, *one) for one in ((i, True), (j, False))
            )
            ways.append((vehicle, i, j, int(count.time[into].sum()), int(count.time[onward].sum())))
    assert found == pytest.approx(least_of_time(count, ways), abs=1e-4)


def least_of_time(count, ways):
    """The least that waiting and delay cost for members that merge and separate as given."""
    price, late = count.costs.price, count.costs.late
    _, _, _, first, leave, _ = count.rows[0]
    best, last = np.inf, len(count.tau) - 1
    for start in range(first, first + 45 if leave is None else leave + 1):
        for waits in itertools.product(range(16), repeat=last - 1):
            stood = [0, 0, *itertools.accumulate(waits)]
            arrive = [start + tau + some for tau, some in zip(count.tau, stood, strict=True)]
            if arrive[-1] > count.until(0):
                continue
            own = [0, *waits, 0]
            total = price * sum(waits) + late * (arrive[-1] - first - count.alone[0][1])
            for k, i, j, time_in, time_out in ways:
                _, _, _, begin, latest, _ = count.rows[k]
                leaves, ends = arrive[i] + own[i], arrive[j] + time_out
                if begin + time_in > leaves or ends > count.until(k):
                    break
                idle = 0 if latest is None else max(0, leaves - latest - time_in)
                total += price * (idle + sum(own[i + 1 : j]))
                total += late * (ends - begin - count.alone[k][1])
            else:
                best = min(best, total)
    return best


@given(problem=problems(vehicles=(3, 3)), optimum=st.sampled_from(["member", "system"]))
@settings(max_examples=25)
def test_no_master_that_waits_is_cheaper_than_the_bound(problem, optimum):
    asked = asked_of(problem, optimum)
    if asked is None:
        return
    count = Count(problem, asked.question)
    bound = bound_if_waiting(TimedStar(asked.question, asked.question.star(0)), "C")
    pays = count.system_pays if optimum == "system" else count.members_pay
    for here in count.timetables(3):
        assert bound <= pays(here) + 1e-6


@given(problem=problems(), optimum=st.sampled_from(["member", "system"]))
@settings(max_examples=40)
def test_what_a_plan_says_is_proved(problem, optimum):
    """The plan is in time, and what it calls optimal is no dearer than what is counted."""
    asked = asked_of(problem, optimum)
    if asked is None:
        return
    plan = po.plan_joint(asked.question.problem)
    count = Count(problem, asked.question)
    for row, times in zip(problem[2], plan.timetable.vehicles, strict=True):
        first = datetime.fromisoformat(plan.timetable.start) - DAY
        k = int(row[0][1:])
        assert times.departure_s + first.total_seconds() >= row[3] - 1e-3
        assert times.arrival_s + first.total_seconds() <= count.until(k) + 1e-3
    pays = count.system_pays if optimum == "system" else count.members_pay
    stiff = min(pays([at + tau for tau in count.tau]) for at in count.departures())
    manner = plan.proof.conditions[0].partition(" ")[2].partition(" ")[2]
    cost = plan.joint_cost
    bound = cost if plan.proof.kind == "exact" else plan.proof.bound
    if manner == NO_WAIT:
        assert bound <= stiff + 1e-6
        if optimum == "member":
            assert cost == pytest.approx(stiff)
    elif manner == ANY_WAIT:
        assert cost <= stiff + 1e-6
        least = min((pays(here) for here in count.timetables(2)), default=np.inf)
        assert bound <= least + 1e-6


def corridor(times, costs, nodes):
    """A network of edges (tail, head): cost alone and time; in company half of the cost."""
    pairs = sorted(times)
    net = po.RoadNetwork.from_edges(
        [a for a, _ in pairs], [b for _, b in pairs], [times[p] for p in pairs],
        lon=np.arange(nodes) / 1000, lat=np.zeros(nodes), speed_mps=1.0,
    )  # fmt: skip
    solo = np.array([costs[p] for p in pairs], float)
    return net, Costs(solo, solo / 2, solo.copy())


def test_a_dearer_way_that_is_quick_catches_the_master():
    """The member's cheap way to the merging point is too slow; the quick one costs 2 more."""
    times = {(0, 1): 10, (1, 2): 10, (2, 3): 100, (4, 1): 40, (4, 5): 5, (5, 1): 5}
    costs = {(0, 1): 10, (1, 2): 10, (2, 3): 100, (4, 1): 10, (4, 5): 6, (5, 1): 6}
    net, weights = corridor(times, costs, 6)
    trips = [("V0", 0, 3, 0, 0, 120), ("V1", 4, 3, 0, None, 200)]
    asked = asked_of((net, weights, trips))
    plan = po.plan_joint(asked.question.problem)
    assert plan.joint_cost == 120 + 12 + 55
    assert [len(leg.edges) for leg in plan.vehicles[1].legs] == [2, 2]
    assert plan.timetable.feasible
    assert plan.proof["kind"] == "exact"
    assert plan.proof.conditions[0] == f"master V0 {ANY_WAIT}"
    # If the master may leave 30 s later, the cheap way will do.
    trips[0] = ("V0", 0, 3, 0, 30, 150)
    later = po.plan_joint(asked_of((net, weights, trips)).question.problem)
    assert later.joint_cost == 120 + 10 + 55


def test_of_two_members_that_cannot_both_be_met_the_better_is():
    times = {(0, 1): 10, (1, 2): 100, (2, 3): 10, (4, 1): 10, (2, 5): 10}
    costs = {(0, 1): 10, (1, 2): 100, (2, 3): 10, (4, 1): 10, (2, 5): 10}
    net, weights = corridor(times, costs, 6)
    trips = [("V0", 0, 3, 0, 1000, 1200), ("V1", 4, 5, 0, None, 130), ("V2", 4, 2, 50, None, 160)]
    plan = po.plan_joint(asked_of((net, weights, trips)).question.problem)
    # V1 gains 50 in company, and so does V2: the earlier departure of equals is taken.
    assert plan.joint_cost == 120 + 70 + 110
    assert [vehicle.role for vehicle in plan.vehicles] == ["master", "member", "alone"]
    assert (plan.proof.kind, plan.proof.conditions[0]) == ("exact", f"master V0 {NO_WAIT}")


def test_a_price_of_waiting_is_read_off_an_objective():
    one = np.ones(1)
    assert TimePrices.of(Costs(one, one, one, 0.5)) == TimePrices(0.5, 0.0, True)

    class Steps(Costs):
        def waiting(self, seconds):
            return float(seconds > 3600)

    assert not TimePrices.of(Steps(one, one, one)).are_even
