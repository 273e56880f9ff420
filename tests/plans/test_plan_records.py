"""Plans as records: immutable, with totals and a JSON form that is checked on reading."""

import dataclasses
import json
from datetime import datetime, timedelta

import pytest
from random_networks import network

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.plan import JointPlan
from platoon_osm.plans.trip import Trip


@pytest.fixture
def plan():
    """A drives 0 to 3 with B between 1 and 2, each edge 10 km."""
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    return plan_joint(net, paper_weights(net), [Trip("A", 0, 3), Trip("B", 4, 5)], "C", master="A")


def test_totals_by_hand(plan):
    solo, platoon = 37 / 12 * 10e3, 2.1476 * 10e3
    for vehicle in plan.vehicles:
        assert vehicle.solo_cost == pytest.approx(3 * solo)
        assert vehicle.joint_cost == pytest.approx(2 * solo + platoon)
        assert vehicle.length_m == pytest.approx(30e3)
        assert vehicle.platoon_m == pytest.approx(10e3)
        assert vehicle.time_s == pytest.approx(30e3 / (80 / 3.6))
        assert vehicle.fuel_l == pytest.approx(0.32 * (20 + 8.2))
        assert vehicle.saving == pytest.approx(1 - (2 * solo + platoon) / (3 * solo))
    assert plan.joint_cost == pytest.approx(2 * (2 * solo + platoon))
    assert plan.solo_cost == pytest.approx(6 * solo)
    assert plan.platoon_m == pytest.approx(20e3)
    assert plan.saving == pytest.approx(plan.vehicles[0].saving)
    assert [vehicle.vehicle for vehicle in plan.members] == ["B"]


def test_a_plan_cannot_be_changed(plan):
    with pytest.raises(dataclasses.FrozenInstanceError):
        plan.case = "D"
    with pytest.raises(dataclasses.FrozenInstanceError):
        plan.vehicles[0].role = "alone"


def test_more_can_be_told_of_a_plan_but_no_times_of_others(plan):
    day = datetime(2026, 3, 2, 6)
    trips = [Trip("A", 0, 3, day), Trip("B", 4, 5, day)]
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    timed = plan_joint(net, paper_weights(net), trips, "C", master="A")
    proof = dataclasses.replace(plan.proof, conditions=("told later",))
    told = timed.told(proof=proof)
    assert told == dataclasses.replace(timed, proof=proof)
    assert timed.proof != proof
    vehicles = timed.timetable.vehicles
    others = dataclasses.replace(timed.timetable, vehicles=vehicles[::-1])
    assert timed.told(timetable=timed.timetable) == timed
    with pytest.raises(ScenarioError, match="timetable is that of other vehicles"):
        timed.told(timetable=others)


def test_written_file_is_the_plan(plan, tmp_path):
    file = tmp_path / "plan.json"
    plan.write_json(file)
    assert JointPlan.from_dict(json.loads(file.read_text(encoding="utf-8"))) == plan
    assert [path.name for path in tmp_path.iterdir()] == ["plan.json"]


def test_names_with_accents_survive(tmp_path):
    net = network([0, 1], [1, 2], [1e3, 1e3])
    plan = plan_joint(net, paper_weights(net), [Trip("Žiga ü", 0, 2)], "C")
    plan.write_json(tmp_path / "plan.json")
    assert "Žiga ü" in (tmp_path / "plan.json").read_bytes().decode("utf-8")


@pytest.mark.parametrize("version", [0, 9, None, "1", True, [1]])
def test_another_version_is_refused(plan, version):
    with pytest.raises(ScenarioError, match=r"this version reads up to 8; plan again$"):
        JointPlan.from_dict({**plan.to_dict(), "plan_version": version})


@pytest.mark.parametrize("data", [[], None, "plan", {}])
def test_something_else_is_refused(data):
    with pytest.raises(ScenarioError, match="format version None"):
        JointPlan.from_dict(data)


@pytest.mark.parametrize(
    "damage",
    [{"trips": None}, {"trips": [{}]}, {"trips": [1]}, {"network": {}}, {"colour": "red"},
     {"remarks": None}, {"trips": "AB"}, {"timetable": []}, {"timetable": {}}, {"ways": []},
     {"ways": [[0], [9]]}, {"ways": [[], []]}, {"ways": [["0"], [1]]}, {"stretches": []},
     {"stretches": None}, {"stretches": [{}]}, {"platoons": [{}]}, {"platoons": None},
     {"platoons": [{"vehicles": [0, 7], "master": 0, "case": "C"}]},
     {"platoons": [{"vehicles": [0, 1], "master": 5, "case": "C"}]},
     {"events": [{}]}, {"events": None}, {"proof": {}}, {"proof": None},
     {"timetable": {"start": "2026-03-02T06:00:00", "feasible": True, "vehicles": [{}]}}],
)  # fmt: skip
def test_a_damaged_plan_is_refused(plan, damage):
    with pytest.raises(ScenarioError, match="damaged, plan again") as error:
        JointPlan.from_dict({**plan.to_dict(), **damage})
    assert "\n" not in str(error.value)


def test_a_plan_with_a_part_missing_is_refused(plan):
    data = plan.to_dict()
    del data["stretches"]
    with pytest.raises(ScenarioError, match="'stretches' does not fit"):
        JointPlan.from_dict(data)


# -- times -----------------------------------------------------------------------------------------


@pytest.fixture
def timed():
    """As `plan`, but A leaves at six, and B has to leave at once and waits for it."""
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    six = datetime(2026, 3, 2, 6)
    trips = [Trip("A", 0, 3, six), Trip("B", 4, 5, None, six - timedelta(minutes=5))]
    return plan_joint(net, paper_weights(net), trips, "C", master="A")


def test_times_survive_a_file(timed, tmp_path):
    timed.write_json(tmp_path / "plan.json")
    data = json.loads((tmp_path / "plan.json").read_text(encoding="utf-8"))
    assert JointPlan.from_dict(data) == timed
    assert data["timetable"]["start"] == "2026-03-02T05:55:00"
    assert data["timetable"]["feasible"] is True
    assert timed.times == timed.timetable.vehicles


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        ({"start": "yesterday"}, "start 'yesterday' is no ISO 8601 moment"),
        ({"start": None}, "start None is no ISO 8601 moment"),
        ({"start": "9999-12-31T23:50:00"}, "beyond the calendar"),
        ({"feasible": False}, "feasible does not fit"),
        ({"feasible": 1}, "feasible does not fit"),
        ({"vehicles": []}, "that of other vehicles"),
        ({"departure_s": float("nan")}, "times of 'B' must be finite numbers"),
        ({"departure_s": "0"}, "times of 'B' must be finite numbers"),
        ({"departure_s": True}, "times of 'B' must be finite numbers"),
        ({"departure_s": 1e12}, "times of 'B' must be finite numbers"),
        ({"departure_s": 5000}, "times of 'B' run backwards"),
        ({"latest_arrival_s": float("inf")}, "times of 'B' must be finite numbers"),
        ({"legs": []}, "times of 'B' name no legs"),
        ({"legs": [[5000, 6000]]}, "that of other vehicles"),
        ({"legs": [[1, 2, 3]]}, "damaged, plan again"),
        ({"legs": 7}, "damaged, plan again"),
        ({"vehicle": "Z"}, "that of other vehicles"),
        ({"colour": "red"}, "damaged, plan again"),
    ],
)
def test_damaged_times_are_refused(timed, damage, said):
    data = timed.to_dict()
    table = data["timetable"]
    ((key, value),) = damage.items()
    (table if key in table else table["vehicles"][1])[key] = value
    with pytest.raises(ScenarioError, match=said) as error:
        JointPlan.from_dict(data)
    assert str(error.value).endswith("plan again")
    assert "\n" not in str(error.value)


def test_fuel_by_position_is_the_leaders_for_the_master_and_the_followers_for_members():
    net = network([0, 1, 2], [1, 2, 3], [100e3, 100e3, 100e3])
    weights = paper_weights(net, positions="nacfe", fuel_l_per_100km=30)
    plan = plan_joint(net, weights, [Trip("A", 0, 3), Trip("B", 1, 2)], case="C")
    master, member = plan.vehicles
    # 30 l a 100 km; on the shared 100 km the master saves 4 %, the member 10 %.
    assert master.fuel_l == pytest.approx(30 + 30 * 0.96 + 30)
    assert member.fuel_l == pytest.approx(30 * 0.90)
