"""The plan that is expected to save most: against all merging points, and where it must differ."""

import math
from dataclasses import dataclass
from datetime import datetime, timedelta

import numpy as np
import pytest
from random_networks import network
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.most_expected import ROBUST

DAY = datetime(2026, 3, 2, 6)


@dataclass(frozen=True)
class Priced:
    """The paper's costs with a price of waiting."""

    wait: float
    costs: po.PaperCosts = po.PaperCosts()  # noqa: RUF009 (it is frozen)
    name = "paper with waiting"
    unit = "m"
    params = {}  # noqa: RUF012 (nobody changes it)

    def terms(self):
        return self.costs.terms()

    def weights(self, net, vehicle=None):
        return self.costs.weights(net, vehicle)

    def waiting(self, seconds):
        return self.wait * seconds


def roads(seed):
    """A road of a master, and links onto it at each node for a member that starts beside it."""
    rng = np.random.default_rng(seed)
    nodes, start, end = 6, 6, 7
    links = [2e5]
    for _ in range(nodes - 2):  # each node earlier is a longer way in all, by up to 1.1 of the gain
        links.insert(0, links[0] - 4e4 + 1.6e4 * float(rng.uniform(0.3, 1.1)))
    edges = sorted(
        [((k, k + 1), 4e4) for k in range(nodes - 1)]
        + [((start, k), length) for k, length in enumerate(links)]
        + [((nodes - 1, end), 1e4)]
    )
    return network([a for (a, _), _ in edges], [b for (_, b), _ in edges], [m for _, m in edges])


def a_fifth_off(net):
    """Weights under which whoever drives in a platoon saves a fifth."""
    return po.EdgeWeights(net.length_m, 0.8 * net.length_m, 0.8 * net.length_m, "m", {})


def trips(spare=12.0):
    """A master with little time to spare, and a member that could wait for hours."""
    return [
        po.Trip("M", 0, 5, DAY, DAY, flexibility_min=spare),
        po.Trip("m", 6, 7, DAY - timedelta(hours=3), flexibility_min=600),
    ]


def expected_by_brute_force(net, weights, spare, spread_min):
    """Return the most that can be saved on average, over all merging points."""
    off = math.sqrt(2) * spread_min
    chance = 0.5 * math.erfc(-(spare / off) / math.sqrt(2))
    edge = {
        (a, b): k for k, (a, b) in enumerate(zip(net.tail.tolist(), net.head.tolist(), strict=True))
    }
    solo, joint = weights.solo, weights.platoon
    ways = []
    for at in range(5):
        along = [edge[k, k + 1] for k in range(at, 5)]
        ways.append((solo[edge[6, at]] + solo[along].sum() + solo[edge[5, 7]], along))
    alone = min(cost for cost, _ in ways)
    values = []
    for cost, along in ways:
        gain = 2 * (solo[along] - joint[along]).sum()
        values.append(chance * gain - (cost - alone))
    return max(0.0, *values), chance


@soaked
def test_a_detour_is_taken_if_it_pays_on_average(monkeypatch):
    monkeypatch.setattr("platoon_osm.planning.robust.MOST_BUFFERED", 0)
    better = 0
    for seed in range(chosen(6, 80)):
        net = roads(seed)
        spread = (8.0, 25.0)[seed % 2]
        best, chance = expected_by_brute_force(net, a_fifth_off(net), 12.0, spread)
        plain, robust = (
            po.solve(
                po.Problem(
                    net, trips(), a_fifth_off(net), case="C", master="M", optimum="system",
                    delays=po.Delays(spread), robust=one,
                )
            ).chances
            for one in (False, True)
        )  # fmt: skip
        assert robust.expected_saving == pytest.approx(
            best, abs=4 * robust.saving_error + 1e-3 * best + 1
        )
        for one in robust.meetings:
            assert one.chance == pytest.approx(chance, abs=1e-3)
        better += plain.expected_saving < robust.expected_saving - 1
    assert better > seed / 4  # else the cheapest plan would do


@pytest.mark.parametrize("sure", [0.999, -1.0])  # at -1 nobody is planned by chances
def test_who_will_hardly_be_met_is_left_out(sure, monkeypatch):
    monkeypatch.setattr("platoon_osm.planning.robust.SURE", sure)
    net = network([0, 1, 2, 3, 4, 4], [1, 2, 5, 0, 0, 5], [1e5, 1e5, 1e4, 1e4, 2e4, 2e5])
    three = [
        po.Trip("M", 0, 2, DAY, flexibility_min=40),
        po.Trip("m", 3, 2, DAY, flexibility_min=60),
        po.Trip("n", 4, 5, DAY, flexibility_min=90, delay_spread_min=300),
    ]
    plain, robust = (
        po.solve(
            po.Problem(
                net, three, a_fifth_off(net), case="C", master="M", optimum="system",
                delays=po.Delays(3), robust=one,
            )
        )
        for one in (False, True)
    )  # fmt: skip
    assert [vehicle.platoon_m > 0 for vehicle in plain.vehicles] == [True, True, True]
    assert [vehicle.platoon_m > 0 for vehicle in robust.vehicles] == [True, True, False]
    assert robust.chances.expected_saving > plain.chances.expected_saving


def test_a_hopeless_merge_is_not_planned():
    net = roads(1)
    objective = Priced(40.0)
    plans = [
        po.solve(
            po.Problem(
                net, trips(2.0), objective, case="C", master="M",
                delays=po.Delays(90, kind="normal"), robust=robust,
            )
        )
        for robust in (False, True)
    ]  # fmt: skip
    assert merges(plans[0])
    assert plans[1].chances.expected_saving >= plans[0].chances.expected_saving
    assert plans[1].chances.expected_saving >= 0
    assert "plans compared on" in plans[1].remarks[-1]


def test_a_member_comes_earlier_to_a_master_that_cannot_wait():
    net = roads(2)
    plain, robust = (
        po.solve(
            po.Problem(
                net, trips(0.0), po.paper_weights(net), case="C", master="M",
                delays=po.Delays(8), robust=one,
            )
        )
        for one in (False, True)
    )  # fmt: skip
    member = robust.timetable.vehicles[1]
    assert plain.timetable.vehicles[1].waiting_s < 1
    assert member.waiting_s > 600
    assert robust.chances.meetings[0].chance > plain.chances.meetings[0].chance + 0.2
    assert robust.chances.expected_saving > plain.chances.expected_saving
    assert ROBUST in robust.proof.conditions
    assert robust.timetable.feasible


@pytest.mark.parametrize("seed", range(chosen(3, 20)))
def test_without_delays_the_cheapest_plan_stays(seed):
    net = roads(seed)
    plain, robust = (
        po.solve(
            po.Problem(net, trips(60.0), po.paper_weights(net), delays=po.Delays(0), robust=one)
        )
        for one in (False, True)
    )
    assert robust.stretches == plain.stretches
    assert robust.timetable == plain.timetable
    assert robust.proof == plain.proof
    assert robust.chances.expected_saving == pytest.approx(plain.solo_cost - plain.joint_cost)


@soaked
@pytest.mark.parametrize("seed", range(chosen(6, 60)))
def test_it_is_never_expected_to_save_less_than_the_cheapest(seed):
    rng = np.random.default_rng(seed)
    net = roads(seed)
    three = [
        *trips(float(rng.integers(0, 40))),
        po.Trip("n", 6, 5, DAY - timedelta(hours=1), flexibility_min=float(rng.integers(10, 300))),
    ]
    delays = po.Delays(
        float(rng.integers(3, 40)), correlation=float(rng.choice([-0.2, 0.0, 0.6])),
        kind=str(rng.choice(["normal", "lognormal"])),
    )  # fmt: skip
    objective = Priced(float(rng.choice([0.0, 5.0, 30.0])))
    plain, robust = (
        po.solve(po.Problem(net, three, objective, delays=delays, robust=one))
        for one in (False, True)
    )
    level = 3 * (plain.chances.saving_error + robust.chances.saving_error)
    assert robust.chances.expected_saving >= plain.chances.expected_saving - level
    late = [max(times.late_s for times in plan.times) for plan in (plain, robust)]
    assert late[1] <= late[0] + 1


def merges(plan):
    return [event for event in plan.events if event.kind == "merge"]


def test_own_spreads_of_trips_count():
    net = roads(1)
    some = [trips()[0], po.Trip("m", 6, 7, DAY, flexibility_min=600, delay_spread_min=31)]
    problem = po.Problem(net, some, po.paper_weights(net), delays=po.Delays(8))
    assert problem.delays.spread_s("m") == 31 * 60
    assert problem.delays.spread_s("M") == 8 * 60


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"robust": True}, "robust weighs delays; give delays too"),
        ({"robust": 1, "delays": po.Delays(8)}, "robust is 1; give True or False"),
        ({"delays": 8}, "delays is a int; make it Delays"),
        ({"delays": po.Delays(8), "robust": True, "method": "astar"}, "method dijkstra"),
        ({"delays": po.Delays(8, pairs={("M", "m"): 0.9, ("m", "n"): 0.9, ("M", "n"): -0.9})},
         "not positive semidefinite"),
    ],
)  # fmt: skip
def test_what_cannot_be_weighed_is_told_in_one_line(given, told):
    net = roads(1)
    three = [*trips(), po.Trip("n", 6, 5)]
    with pytest.raises(ScenarioError, match=told):
        po.Problem(net, three, po.paper_weights(net), **given)


def test_robust_needs_a_clock():
    net = roads(1)
    with pytest.raises(ScenarioError, match="robust needs a clock"):
        po.Problem(
            net, [po.Trip("M", 0, 5), po.Trip("m", 6, 7)], po.paper_weights(net),
            delays=po.Delays(8), robust=True,
        )  # fmt: skip


@pytest.mark.parametrize("value", [-1, "8", True, math.nan, 1e6])
def test_a_spread_of_a_trip_is_minutes(value):
    with pytest.raises(ScenarioError, match="delay_spread_min"):
        po.Trip("M", 0, 5, delay_spread_min=value)
