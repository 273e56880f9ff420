"""What may be asked, and how everything else is refused in one line."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network, problems

import platoon_osm as po
from platoon_osm.costs.paper import PaperCosts, paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.driving.rules import NO_RULES, Violation
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.network.location import Location
from platoon_osm.planning.joint import plan_joint, solve
from platoon_osm.planning.problem import Problem
from platoon_osm.plans.trip import Trip


@pytest.fixture
def net():
    """A road 0 - 1 - 2 - 3 of 10 km edges; 4 joins at 1, and 5 leaves at 2."""
    return network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)


TWO = [Trip("A", 0, 3), Trip("B", 4, 5)]


@settings(max_examples=30, deadline=None)
@given(problems(), st.sampled_from(["A", "B", "C", "best"]), st.booleans())
def test_a_problem_and_its_thin_face_are_one(problem, case, system):
    net, weights, trips = problem
    optimum = "system" if system else "member"
    asked = Problem(net, trips, weights, case=case, optimum=optimum)
    plan = plan_joint(net, weights, trips, case, objective=optimum)
    assert plan == plan_joint(asked) == solve(asked)
    assert plan.proof.cost == pytest.approx(plan.joint_cost)


def test_costs_may_be_given_as_an_objective(net):
    costs = PaperCosts(tau=0.5)
    assert plan_joint(net, costs, TWO) == plan_joint(net, paper_weights(net, tau=0.5), TWO)


def test_names_and_coordinates_are_looked_for_on_the_network():
    italy = po.load_network("italy-motorways")
    weights = paper_weights(italy)
    typed = [Trip("A", "Torino", "Trieste"), Trip("B", (9.03, 45.83), "Brennero")]
    located = [
        Trip(
            t.vehicle, italy.locate(t.origin, "origin"), italy.locate(t.destination, "destination")
        )
        for t in typed
    ]
    assert plan_joint(italy, weights, typed) == plan_joint(italy, weights, located)
    with pytest.raises(PlatoonError, match=r"^trip 'B', destination: place 'Brener'.*Brennero"):
        plan_joint(italy, weights, [typed[0], Trip("B", "Torino", "Brener")])


class DearWaiting(PaperCosts):
    """The paper's costs for people who mind waiting."""

    def waiting(self, seconds):
        return seconds / 100


def test_a_plan_claims_free_waiting_only_if_it_is_free(net):
    assert (
        "waiting at merging points is free" in plan_joint(net, PaperCosts(), TWO).proof.conditions
    )
    dear = plan_joint(net, DearWaiting(), TWO)
    assert dear.proof.conditions == ("master A on its own route", "2 of 2 masters tried")


class NoLongDrives:
    """Rules of somebody's own."""

    name = "own"

    def violations(self, day):
        alone = sum(drive.drive_s for drive in day if drive.leads)
        return [Violation(alone, f"leads for {alone / 60:.0f} min")] if alone > 1000 else []


def test_what_breaks_the_rules_is_remarked(net):
    plan = plan_joint(Problem(net, TWO, paper_weights(net), rules=NoLongDrives(), case="C"))
    # 10 km last 450 s; A leads all its 30 km, B leads where it is alone.
    assert plan.remarks == ("A: leads for 22 min",)
    assert plan_joint(Problem(net, TWO, paper_weights(net), case="C")).remarks == ()
    assert NO_RULES.violations([]) == []


def test_rules_are_given_beside_the_trips(net):
    asked = [net, paper_weights(net), TWO, "C"]
    assert plan_joint(*asked, rules=NoLongDrives()).remarks == ("A: leads for 22 min",)
    assert plan_joint(*asked, rules="none", task_relief=1) == plan_joint(*asked)
    with pytest.raises(ScenarioError, match="task_relief is -1; give a number from 0 to 1"):
        plan_joint(*asked, task_relief=-1)


def test_weights_of_another_network_are_refused(net):
    longer = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [20e3] * 5)
    with pytest.raises(ScenarioError, match="made for another network"):
        plan_joint(net, paper_weights(longer), TWO)
    shorter = network([0], [1], [1e3])
    with pytest.raises(ScenarioError, match=r"they are those of 1 edges, .* has 5; make"):
        plan_joint(net, paper_weights(shorter), TWO)
    # Weights by hand do not say whose they are; as many as there are edges will do.
    ones = np.ones(5)
    assert plan_joint(net, EdgeWeights(ones, ones / 2, ones / 2, "m", {}), TWO).saving > 0


def test_a_location_of_another_network_is_refused(net):
    far = Location(77, "far", 9.0, 45.0, 0.0, ((77, 0.0),))
    with pytest.raises(ScenarioError, match=r"'A', origin: far is at node 77, .* 0 to 5"):
        plan_joint(net, paper_weights(net), [Trip("A", far, 3)])


def wrong(net, weights):
    """Arguments of `plan_joint` that are none."""
    return {
        "exchanged": (weights, net, TWO),
        "no network": (None, weights, TWO),
        "a name as network": ("italy-motorways", weights, TWO),
        "no weights": (net, None, TWO),
        "arrays as weights": (net, weights.solo, TWO),
        "a class as weights": (net, PaperCosts, TWO),
        "trips and weights exchanged": (net, TWO, weights),
        "no trips": (net, weights, None),
        "a single trip": (net, weights, TWO[0]),
        "a text as trips": (net, weights, "AB"),
        "dicts as trips": (net, weights, [{"vehicle": "A", "origin": 0, "destination": 3}]),
        "a dict of trips": (net, weights, {"A": TWO[0]}),
        "tuples as trips": (net, weights, [("A", 0, 3)]),
        "numbers as trips": (net, weights, [1, 2]),
        "a number as trips": (net, weights, 3),
        "trips in a list too many": (net, weights, [TWO]),
        "a list as case": (net, weights, TWO, ["C"]),
        "an array as case": (net, weights, TWO, np.array(["C", "D"])),
        "a problem and more": (Problem(net, TWO, weights), weights, TWO),
    }


SMALL = network([0], [1], [1e3])


@pytest.mark.parametrize("which", wrong(SMALL, paper_weights(SMALL)))
def test_wrong_arguments_are_named_in_one_line(net, which):
    with pytest.raises(PlatoonError) as error:
        plan_joint(*wrong(net, paper_weights(net))[which])
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 200


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"case": "E"}, "case 'E' is unknown; use A, B, C, D, best"),
        ({"optimum": "all"}, "optimum 'all' is unknown; use member, system"),
        ({"method": None}, "method None is unknown; use dijkstra, astar"),
        ({"engine": "fast"}, "engine 'fast' is unknown; use auto, reference, hierarchy"),
        ({"master": "C"}, "master 'C' has no trip; vehicles are A and B"),
        ({"master": ["A"]}, r"master \['A'\] has no trip"),
        ({"rules": None}, "rules is a NoneType; give driving rules"),
        ({"rules": "eu651"}, "driving rules 'eu651' is unknown; did you mean 'eu561'"),
        ({"rules": "eu561"}, "rules 'eu561' need a clock; give at least one trip an earliest_dep"),
        ({"rules": "us395", "method": "astar"}, "rules 'us395' are beyond the paper's A"),
        ({"task_relief": 1.1}, "task_relief is 1.1; give a number from 0 to 1"),
        ({"task_relief": True}, "task_relief is True; give a number from 0 to 1"),
        ({"trips": []}, "no trips; give at least one"),
    ],
)
def test_wrong_options_are_named_in_one_line(net, options, said):
    fields = {"trips": TWO, **options}
    with pytest.raises(ScenarioError, match=said) as error:
        Problem(net, objective=paper_weights(net), **fields)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "call",
    [
        lambda _: paper_weights(None),
        lambda net: paper_weights(net, {"tau": 1}),
        lambda net: paper_weights(net, tau="1"),
        lambda net: paper_weights(net, colour="red"),
        lambda _: EdgeWeights("a", "b", "c", "m", {}),
        lambda _: EdgeWeights(None, None, None, "m", {}),
        lambda _: EdgeWeights([1.0], [1.0, 2.0], [1.0], "m", {}),
        lambda _: EdgeWeights([np.nan], [1.0], [1.0], "m", {}),
        lambda net: po.plan_members(net, paper_weights(net), [9], [0], [1]),
        lambda net: po.plan_members(None, paper_weights(net), [0], [0], [1]),
        lambda net: po.plan_members(net, None, [0], [0], [1]),
        lambda net: po.plan_members(paper_weights(net), net, [0], [0], [1]),
        lambda net: po.plan_members(net, paper_weights(net), "ab", [0], [1]),
        lambda net: po.plan_members(net, paper_weights(net), None, [0], [1]),
        lambda net: po.plan_members(net, paper_weights(net), [0], ["x"], [1]),
        lambda net: po.plan_members(net, paper_weights(net), [0], [0.5], [1]),
        lambda net: po.plan_members(net, paper_weights(net), [0], [0], [1], "D"),
        lambda net: po.plan_members(net, paper_weights(net), [0], [0], [1], engine="x"),
        lambda net: po.plan_members(net, paper_weights(net), [[0]], [0], [1]),
    ],
)
def test_other_doors_refuse_in_one_line_too(net, call):
    with pytest.raises(PlatoonError) as error:
        call(net)
    assert "\n" not in str(error.value)
