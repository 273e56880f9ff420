"""Plans that versions 1, 2 and 3 wrote still open, and say what they said.

The files under older/ were written by those versions, on the network made below.
"""

import json
from dataclasses import replace

import pytest
from places import ROOT
from plans_by_legs import with_vehicles

from platoon_osm.costs.paper import paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.trip import Trip
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE

OLDER = ROOT / "tests" / "plans" / "older"
FILES = [(version, name) for version, names in (
    (1, ("three", "pair")), (2, ("three", "apart", "pair", "system", "astar", "other", "timed")),
) for name in names]  # fmt: skip


def old(version, name):
    return json.loads((OLDER / f"version-{version}.json").read_text(encoding="utf-8"))[name]


@pytest.fixture(scope="module")
def net():
    """A road 0 to 4; 5 joins it at 1, 7 at 2, and at 3 one may leave it for 6."""
    return RoadNetwork.from_edges(
        [0, 1, 2, 3, 5, 3, 7, 4, 6], [1, 2, 3, 4, 1, 6, 2, 7, 5], [10e3] * 9,
        lon=[9 + 0.1 * k for k in range(8)], lat=[45.0] * 8,
        inferred=[False, False, False, True] + [False] * 5,
    )  # fmt: skip


@pytest.mark.parametrize(("version", "name"), FILES)
def test_every_number_and_word_is_there(version, name):
    data, plan = old(version, name), Plan.from_dict(old(version, name))
    assert plan.plan_version == 8
    for key in ("case", "asked", "objective", "method", "unit", "params", "version"):
        assert getattr(plan, key) == data[key]
    assert list(plan.remarks) == data["remarks"]
    for vehicle, told in zip(plan.vehicles, data["vehicles"], strict=True):
        assert (vehicle.vehicle, vehicle.role, vehicle.reason) == (
            told["vehicle"], told["role"], told["reason"],
        )  # fmt: skip
        assert len(vehicle.legs) == len(told["legs"])
        for leg, was in zip((*vehicle.legs, vehicle.alone), (*told["legs"], told["alone"]),
                            strict=True):  # fmt: skip
            assert (leg.role, list(leg.edges)) == (was["role"], was["edges"])
            assert sorted(leg.partners) == sorted(was["partners"])
            for key in ("length_m", "time_s", "fuel_l", "cost", "inferred_m"):
                assert getattr(leg, key) == was[key]
        for key in ("merge", "separation"):
            point, was = getattr(vehicle, key), told[key]
            assert (point is None) == (was is None)
            if point is not None:
                assert (point.node, point.name) == (was["node"], was["name"])
                assert point.km == pytest.approx(was["km"])
    for key, value in data["proof"].items():
        assert plan.proof[key] == (pytest.approx(value) if isinstance(value, float) else value)


@pytest.mark.parametrize(("version", "name"), FILES)
def test_an_old_plan_read_and_written_is_a_new_one(version, name):
    plan = Plan.from_dict(old(version, name))
    assert Plan.from_dict(json.loads(json.dumps(plan.to_dict()))) == plan


@pytest.mark.parametrize("name", ["three", "pair", "timed"])
def test_version_3_says_all_but_places_between_junctions(name):
    data = old(3, name)
    plan = Plan.from_dict(data)
    now = json.loads(json.dumps(plan.to_dict()))
    assert now.pop("plan_version") == 8
    assert data.pop("plan_version") == 3
    assert now.pop("closed") == []
    for share in (share for stretch in now["stretches"] for share in stretch["shares"]):
        assert (share.pop("terms"), share.pop("alone_terms")) == ([], [])
    for trip in now["trips"]:
        assert (trip["alone"].pop("terms"), trip["alone"].pop("paused_s")) == ([], 0.0)
    for stretch in (*now["stretches"], *(trip["alone"] for trip in now["trips"])):
        assert stretch.pop("span") == [0.0, 1.0]
        assert stretch.pop("access") in (None, [None, None])
        assert stretch.pop("access_at", "") == ""
    for trip in now["trips"]:
        assert trip.pop("profile") is None
        for end in ("origin", "destination"):
            assert (trip[end].pop("edge"), trip[end].pop("share")) == (None, None)
    if now["timetable"]:
        assert (now["timetable"].pop("zone"), now["timetable"].pop("offsets")) == ("", [])
        assert now["timetable"].pop("patience_s") is None
        assert (now["timetable"].pop("rules"), now["timetable"].pop("task_relief")) == ("", 0.0)
        for times in now["timetable"]["vehicles"]:
            assert (times.pop("pauses"), times.pop("drivers")) == ([], [])
    for event in now["events"]:
        assert (event["point"].pop("edge"), event["point"].pop("share")) == (None, None)
    assert now.pop("masters") == []
    assert now["proof"].pop("any_plan") is None
    for name in ("bill", "gain", "chances"):
        assert now.pop(name) is None
    for key, value in data.items():
        assert now[key] == value


def test_version_4_says_all_but_what_vehicles_are_like(net):
    plan = plan_joint(net, paper_weights(net), [Trip("A", 0, 3), Trip("B", 5, 6)])
    data = plan.to_dict() | {"plan_version": 4}
    del data["closed"]
    for trip in data["trips"]:
        del trip["profile"]
    read = Plan.from_dict(data)
    assert [trip.profile for trip in read.trips] == [None, None]
    told = tuple(replace(trip, profile=DEFAULT_VEHICLE) for trip in read.trips)
    assert replace(read, trips=told) == plan


def named_as_today(data, net):
    """Give nodes today's names: those without a name are now known by the nearest town."""
    if isinstance(data, list):
        return [named_as_today(item, net) for item in data]
    if not isinstance(data, dict):
        return data
    new = {key: named_as_today(value, net) for key, value in data.items()}
    return new | {"name": net.place_name(data["node"])} if {"node", "name"} <= set(data) else new


def test_the_same_problem_gives_the_same_plan_today(net):
    weights = paper_weights(net)
    trips = [Trip("A", 0, 4), Trip("B", 5, 6), Trip("C", 7, 4)]
    now = plan_joint(net, weights, trips, "C", master="A", company="master")
    was = Plan.from_dict(named_as_today(old(2, "three"), net))
    assert now.vehicles == was.vehicles
    assert (now.stretches, now.ways, now.events) == (was.stretches, was.ways, was.events)
    assert (now.platoons, now.network) == (was.platoons, was.network)
    assert (now.proof.kind, now.proof.bound) == (was.proof.kind, was.proof.bound)


def test_what_legs_cost_alone_is_told_where_the_paper_tells_it():
    plan = Plan.from_dict(old(2, "three"))
    for stretch in plan.stretches:
        for share in stretch.shares:
            assert share.alone_cost == pytest.approx(stretch.length_m * 37 / 12)
            assert share.alone_fuel_l == pytest.approx(stretch.length_m * 0.00032)


def test_what_legs_cost_alone_is_unknown_under_other_costs(net):
    plan = Plan.from_dict(old(2, "other"))
    alone = [share.alone_cost for stretch in plan.stretches for share in stretch.shares
             if stretch.together]  # fmt: skip
    assert set(alone) == {None}
    length = net.length_m
    weights = EdgeWeights(length * 2, length * 1.5, length * 1.2, "EUR", {"preset": "ours"},
                          (3e-4, 2.5e-4, 2e-4))  # fmt: skip
    now = plan_joint(net, weights, [Trip("A", 0, 4), Trip("B", 5, 6)], "C", master="A")
    for stretch in now.stretches:
        for share in stretch.shares:
            assert share.alone_cost == pytest.approx(2 * stretch.length_m)


def test_parameters_that_do_not_give_the_costs_are_not_believed():
    data = old(2, "three")
    data["params"]["rest_s"] = 0.0
    plan = Plan.from_dict(data)
    assert {share.alone_cost for one in plan.stretches if one.together for share in one.shares} == {
        None
    }


def broken(name, change):
    data = old(2, name)
    change(data["vehicles"])
    return data


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda v: v[1]["legs"][1]["partners"].append("Z"), "drives with 'Z', which is not in"),
        (lambda v: v.pop(), "which is not in the plan"),
        (lambda v: v[1]["legs"][1].update(edges=[2]), "which drives no such leg"),
        (lambda v: v[1]["legs"][1].update(time_s=9e9), "need from .* for one stretch"),
        (lambda v: v[0]["legs"][0].update(edges=[]), "has a leg without edges"),
        (lambda v: v[0]["legs"][0].update(cost="x"), "damaged"),
        (lambda v: v[0].update(colour="red"), "damaged"),
        (lambda v: v[0].pop("legs"), "'legs' does not fit"),
    ],
)
def test_an_old_plan_that_does_not_fit_together_is_refused(change, said):
    with pytest.raises(ScenarioError, match=said) as error:
        Plan.from_dict(broken("three", change))
    assert str(error.value).endswith("plan again")
    assert "\n" not in str(error.value)


def test_legs_that_name_partners_who_share_only_some_of_their_edges_are_refused():
    plan = Plan.from_dict(old(2, "three"))
    first, *others = plan.vehicles
    legs = [leg for leg in first.legs if leg.role == "platoon"]
    coarse = legs[0].__class__(
        "platoon", legs[0].edges + legs[1].edges, ("B", "C"), 20e3, 900.0, 1.0, 1.0
    )
    rest = [leg for leg in first.legs if leg not in legs[:2]]
    at = first.legs.index(legs[0])
    from dataclasses import replace

    whole = replace(first, legs=(*rest[:at], coarse, *rest[at:]))
    with pytest.raises(ScenarioError, match="which drives no such leg"):
        with_vehicles(plan, (whole, *others))


def test_a_file_of_any_version_is_read(tmp_path):
    for version in (1, 2):
        file = tmp_path / f"{version}.json"
        file.write_text(json.dumps(old(version, "three")), encoding="utf-8")
        assert Plan.read_json(file).vehicles[0].vehicle == "A"
    for text, said in (("{", "is no JSON"), ("[]", "format version None"), ("\xff", "is no JSON")):
        file.write_bytes(text.encode("latin-1"))
        with pytest.raises(ScenarioError, match=said) as error:
            Plan.read_json(file)
        assert str(error.value).startswith(f"{file}: ")
    with pytest.raises(ScenarioError, match="cannot be read"):
        Plan.read_json(tmp_path)
