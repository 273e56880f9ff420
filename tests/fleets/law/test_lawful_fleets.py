"""Fleets under driving rules: checkers of law and certificate, common breaks, who is left out."""

import json
from dataclasses import replace
from datetime import timedelta

import numpy as np
import pytest
from grid_fleets import DAY, base, trips_on_grid
from random_networks import network
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.driving.state import DriverState
from platoon_osm.errors import ScenarioError
from platoon_osm.inspection.certificate.belief import certify
from platoon_osm.inspection.certificate.faults import FaultError
from platoon_osm.inspection.verdict import inspect_plan

SHORT = po.Limits(time_s=None, rounds=6, threads=1)


def grid(seed=3, side=4):
    """A grid of two-way roads of 90 to 150 km."""
    rng = np.random.default_rng(seed)
    node = np.arange(side * side).reshape(side, side)
    pairs = [*zip(node[:, :-1].ravel(), node[:, 1:].ravel(), strict=True)]
    pairs += [*zip(node[:-1].ravel(), node[1:].ravel(), strict=True)]
    length = {(int(a), int(b)): float(rng.integers(90_000, 150_000)) for a, b in pairs}
    length |= {(b, a): metres for (a, b), metres in length.items()}
    both = sorted(length)
    lon, lat = 9 + node % side, 45 + node // side
    return network(
        [a for a, _ in both], [b for _, b in both], [length[pair] for pair in both],
        lon.ravel(), lat.ravel(),
    )  # fmt: skip


def trips(count, seed, window=45, side=4):
    return trips_on_grid(count, seed, window, side, within_min=60)


@pytest.fixture(scope="module")
def net():
    return grid()


def far(name, **more):
    return po.Trip(name, 0, 15, DAY, **{"flexibility_min": 30, **more})


def planned(net, some, rules="eu561", limits=SHORT, **more):
    return po.plan_fleet(po.Problem(net, some, base(net), rules=rules), limits, **more)


def pauses(plan):
    return [pause for times in plan.timetable.vehicles for pause in times.pauses]


@soaked
@pytest.mark.parametrize("seed", range(chosen(3, 200)))
def test_every_plan_passes_the_checkers(tmp_path, seed):
    net = grid(seed)
    rules = ("eu561", "us395")[seed % 2]
    routes = ("free", "given")[seed % 3 % 2]
    file = tmp_path / "fleet.json"
    problem = po.Problem(
        net, trips(8, seed), base(net), rules=rules, max_platoon=(None, 3)[seed % 2]
    )
    plan = po.plan_fleet(problem, replace(SHORT, routes=routes), write_to=file)
    assert inspect_plan(plan) == []
    assert plan.timetable.rules == rules
    belief, read = certify(file)
    assert read.fleet == plan.fleet
    assert belief.cost <= belief.alone
    fleet = plan.fleet
    assert -1e-6 <= fleet.saving <= fleet.bound + 1e-6
    assert any("no breaks and rests" in one for one in fleet.conditions)
    # In other draws nobody may drive for more than a spell.
    assert pauses(plan) or seed


@soaked
@pytest.mark.parametrize("seed", range(chosen(2, 100)))
def test_what_is_stood_longer_than_alone_is_paid(tmp_path, seed):
    file = tmp_path / "fleet.json"
    costs = po.MoneyCosts(("eu", "us")[seed % 2])
    rules = ("eu561", "us395")[seed % 2]
    problem = po.Problem(
        grid(seed), trips(7, seed, window=90), costs, rules=rules, max_platoon=(None, 3)[seed % 2]
    )
    plan, other = (
        po.plan_fleet(problem, replace(SHORT, threads=threads), write_to=file) for threads in (1, 2)
    )
    assert plan.stretches == other.stretches
    assert plan.timetable == other.timetable
    assert inspect_plan(plan) == []
    _, read = certify(file)
    assert read.fleet.saving == plan.fleet.saving
    alone = sum(trip.alone.cost for trip in plan.trips)
    joint = sum(share.cost for one in plan.stretches for share in one.shares)
    for trip, own in zip(plan.trips, plan.timetable.vehicles, strict=True):
        driven = sum(end - begin for begin, end in own.legs)
        stood = own.arrival_s - own.departure_s - driven
        joint += costs.waiting(max(0.0, stood - trip.alone.paused_s))
    assert plan.fleet.saving == pytest.approx(alone - joint, abs=1e-3)
    assert -1e-6 <= plan.fleet.saving <= plan.fleet.bound + 1e-6
    # In other draws nobody may find company that pays.
    assert plan.fleet.saving > 0 or seed > 1
    cents = sum(sum(one.alone_cents) - sum(one.joint_cents) for one in plan.bill.vehicles)
    # Each vehicle's terms are rounded to cents.
    assert abs(cents / 100 - plan.fleet.saving) < 0.05 * len(plan.trips)
    assert any("longer than alone" in one for one in plan.fleet.conditions)


def test_who_has_no_company_waits_for_nothing(net):
    plan = po.plan_fleet(po.Problem(net, [far("A")], po.MoneyCosts(), rules="eu561"), SHORT)
    (stood,) = (sum(own.waits) for own in plan.timetable.vehicles)
    assert stood > 2700
    assert plan.trips[0].alone.paused_s == pytest.approx(stood, abs=1e-6)
    assert plan.fleet.saving == pytest.approx(0, abs=1e-6)


def test_who_drives_together_stands_together(net):
    plan = planned(net, [far("A"), far("B"), far("C")])
    assert inspect_plan(plan) == []
    whole = [trip.alone.cost for trip in plan.trips]
    assert plan.fleet.saving == pytest.approx(0.1 * sum(whole[1:]))
    assert plan.fleet.ended == "proved"
    stood = [
        [(one.start_s, one.end_s) for one in times.pauses] for times in plan.timetable.vehicles
    ]
    assert stood[0]
    assert stood[0] == stood[1] == stood[2]


def test_the_clock_behind_a_driver_counts(net):
    behind = DriverState(driven_since_break_s=14_400.0, driven_today_s=14_400.0)
    plan = planned(
        net, [far("A", flexibility_min=90), far("B", driver=behind, flexibility_min=90)]
    )  # fmt: skip
    assert inspect_plan(plan) == []
    tired = plan.timetable.vehicles[1]
    # Who has driven four hours takes its break before it leaves, or within half an hour.
    assert tired.departure_s - tired.earliest_departure_s >= 2700 or (
        tired.pauses[0].start_s - tired.departure_s <= 1800
    )
    assert plan.fleet.saving > 0


def test_who_must_keep_apart_does_and_two_drivers_are_planned_alone(net):
    team = far("C", driver=DriverState(drivers=2))
    plan = planned(
        net, [far("A"), far("B"), team], limits=replace(SHORT, apart=(("A", "B"),))
    )  # fmt: skip
    assert inspect_plan(plan) == []
    assert all(set(one.vehicles) != {0, 1} for one in plan.stretches)
    kept = [one for one in pauses(plan) if "change" in one.purposes]
    assert kept


def test_who_cannot_be_lawful_in_time_is_listed(net):
    drive_s = po.plan_fleet(po.Problem(net, [far("A")], base(net)), SHORT).trips[0].alone.time_s
    assert drive_s > 4.5 * 3600
    late = far("late", flexibility_min=None, latest_arrival=DAY + timedelta(seconds=drive_s + 600))
    never = far("never", driver=DriverState(duty_s=20 * 3600.0))
    plan = planned(net, [far("A"), late, never])
    assert [trip.vehicle for trip in plan.trips] == ["A"]
    told = {one.vehicle: one.reason for one in plan.fleet.unserved}
    assert told.keys() == {"late", "never"}
    assert "with its breaks and rests" in told["late"]
    with pytest.raises(ScenarioError, match="no trip can be driven within the law"):
        planned(net, [late])


def test_the_same_on_any_number_of_cores(net):
    def told(threads):
        plan = planned(net, trips(6, 5), limits=replace(SHORT, threads=threads))
        return [(one.edges, one.vehicles) for one in plan.stretches], plan.timetable

    assert told(1) == told(2)


@pytest.mark.parametrize(
    ("more", "limits", "what"),
    [
        ({"task_relief": 0.5}, SHORT, "task_relief"),
        ({}, replace(SHORT, min_gain=5.0), "min_gain"),
        ({}, replace(SHORT, per_trip="one"), "one platoon a trip"),
    ],
)
def test_what_is_refused(net, more, limits, what):
    problem = po.Problem(net, [far("A"), far("B")], base(net), rules="eu561", **more)
    with pytest.raises(ScenarioError, match=what):
        po.plan_fleet(problem, limits)


@soaked
@pytest.mark.parametrize("seed", range(chosen(1, 20)))
def test_breaks_at_parkings_between_junctions(tmp_path, seed):
    net = po.load_network("italy-motorways")
    drawn = po.draw_trips(net, chosen(6, 40), seed=seed, flexibility_min=60, min_km=450)
    file = tmp_path / "fleet.json"
    problem = po.Problem(net, drawn, po.PaperCosts(), rules="eu561")
    plan = po.plan_fleet(problem, replace(SHORT, routes="given"), write_to=file)
    assert inspect_plan(plan) == []
    certify(file)
    places = [pause.place for pause in pauses(plan) if pause.place is not None]
    assert any(place.kind != "junction" for place in places)
    # A wait within a lane is refused where no law makes anybody stand.
    told = json.loads(file.read_text(encoding="utf-8"))
    told["plan"]["timetable"]["rules"] = ""
    for vehicle in told["plan"]["timetable"]["vehicles"]:
        vehicle["pauses"] = []
    file.write_text(json.dumps(told), encoding="utf-8")
    with pytest.raises(FaultError):
        certify(file)
