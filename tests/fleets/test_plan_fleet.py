"""`plan_fleet` from trips to plan: proofs, checkers, limits, and what is refused."""

import itertools
import json
import subprocess
import sys
from dataclasses import replace
from datetime import timedelta

import numpy as np
import pytest
from grid_fleets import DAY, base, trips_on_grid
from places import ROOT
from random_networks import network

import platoon_osm as po
from platoon_osm.costs.money.objective import money_costs
from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.model import modelled
from platoon_osm.fleets.run import FleetRun
from platoon_osm.fleets.stopping import Course
from platoon_osm.fleets.writing import A_TRUCK_WRITTEN_S
from platoon_osm.inspection.certificate.belief import certify
from platoon_osm.plans.convoys import convoys_of
from platoon_osm.plans.plan import Plan


def grid(side=5, seed=3):
    """A grid of two-way roads of 20 to 40 km."""
    rng = np.random.default_rng(seed)
    node = np.arange(side * side).reshape(side, side)
    pairs = [(a, b) for a, b in zip(node[:, :-1].ravel(), node[:, 1:].ravel(), strict=True)]
    pairs += [(a, b) for a, b in zip(node[:-1].ravel(), node[1:].ravel(), strict=True)]
    both = sorted({(int(a), int(b)) for a, b in pairs} | {(int(b), int(a)) for a, b in pairs})
    length = {}
    for a, b in both:
        length[a, b] = length.get((b, a)) or float(rng.integers(20_000, 40_000))
    lon, lat = 9 + node % side / 4, 45 + node // side / 4
    return network(
        [a for a, _ in both], [b for _, b in both], [length[pair] for pair in both],
        lon.ravel(), lat.ravel(),
    )  # fmt: skip


def trips(count, seed=1, flexibility=30, side=5):
    return trips_on_grid(count, seed, flexibility, side, within_min=90)


@pytest.fixture(scope="module")
def net():
    return grid()


def asked(net, count=40, costs=None, **more):
    return po.Problem(net, trips(count), base(net) if costs is None else costs, **more)


ROUNDS = po.Limits(time_s=None, rounds=24)


@pytest.mark.parametrize("routes", ["free", "given"])
@pytest.mark.parametrize("largest", [None, 2, 3])
def test_what_is_planned_is_proved_and_believed(net, tmp_path, routes, largest):
    file = tmp_path / "fleet.json"
    limits = po.Limits(time_s=None, rounds=24, routes=routes)
    plan = po.plan_fleet(asked(net, max_platoon=largest), limits, write_to=file)
    fleet = plan.fleet
    assert 0 < fleet.saving <= fleet.most <= fleet.bound
    assert fleet.gap < 0.06
    alone = sum(trip.alone.cost for trip in plan.trips)
    paid = sum(share.cost for stretch in plan.stretches for share in stretch.shares)
    assert fleet.saving == pytest.approx(alone - paid)
    assert max(len(stretch.vehicles) for stretch in plan.stretches) <= (largest or 40)
    if routes == "given":
        for trip, way in zip(plan.trips, plan.ways, strict=True):
            edges = [edge for k in way for edge in plan.stretches[k].edges]
            assert edges == list(trip.alone.edges)
    assert plan.timetable.feasible
    assert po.inspect_plan(plan) == []
    belief, beside = certify(file)
    assert beside == plan
    assert float(belief.saving) == pytest.approx(fleet.saving, rel=1e-6)
    assert Plan.from_dict(plan.to_dict()) == plan


def test_the_plan_does_not_depend_on_the_number_of_threads(net):
    problem = asked(net)
    plans = [
        po.plan_fleet(problem, po.Limits(time_s=None, rounds=14, threads=threads, seed=5))
        for threads in (1, 2, 3)
    ]
    first = plans[0]
    for plan in plans[1:]:
        assert plan.stretches == first.stretches
        assert plan.timetable == first.timetable
        assert (plan.fleet.saving, plan.fleet.bound) == (first.fleet.saving, first.fleet.bound)


def test_the_order_of_trips_changes_nothing_that_is_saved(net):
    given = trips(14)
    best = po.plan_fleet(po.Problem(net, given, base(net)), ROUNDS).fleet
    turned = po.plan_fleet(po.Problem(net, given[::-1], base(net)), ROUNDS).fleet
    assert best.ended == turned.ended == "proved"
    assert turned.saving == pytest.approx(best.saving, rel=1e-5)


def test_one_more_truck_never_makes_the_best_total_worse(net):
    given = trips(12)
    before = 0.0
    for count in (6, 8, 10, 12):
        fleet = po.plan_fleet(po.Problem(net, given[:count], base(net)), ROUNDS).fleet
        assert fleet.ended == "proved"
        assert fleet.saving >= before * (1 - 1e-4)
        before = fleet.saving


@pytest.mark.parametrize("name", ["paper", "fuel"])
def test_objectives_by_name(net, name):
    from platoon_osm.costs.presets import PRESETS

    plan = po.plan_fleet(asked(net, 20, PRESETS[name].make()), ROUNDS)
    assert 0 < plan.fleet.saving <= plan.fleet.bound
    assert plan.fleet.gap < 0.1


@pytest.mark.parametrize("routes", ["free", "given"])
@pytest.mark.parametrize("name", ["eu", "us", "eu, waiting at 1 EUR/h"])
def test_money_counts_waiting_in_plan_bound_and_certificate(net, tmp_path, name, routes):
    """Half of the trips have to leave within four minutes, so that some wait on the road."""
    own = [
        replace(trip, latest_departure=trip.earliest_departure + timedelta(minutes=4))
        if k % 2
        else trip
        for k, trip in enumerate(trips(30))
    ]
    cheap = {"waiting_per_h": 1.0} if "," in name else {}
    costs = money_costs(name[:2], **cheap)
    file = tmp_path / "fleet.json"
    limits = po.Limits(time_s=None, rounds=14, routes=routes)
    plan = po.plan_fleet(po.Problem(net, own, costs), limits, write_to=file)
    fleet = plan.fleet
    assert 0 < fleet.saving <= fleet.bound
    assert fleet.gap < 0.02
    assert plan.timetable.feasible
    assert po.inspect_plan(plan) == []
    # What drivers wait, by the timetable alone.
    waited_s = sum(
        begin - end
        for times in plan.timetable.vehicles
        for (_, end), (begin, _) in itertools.pairwise(times.legs)
    )
    assert (waited_s > 60) == bool(cheap)
    driving = sum(share.cost for stretch in plan.stretches for share in stretch.shares)
    paid = fleet.alone_cost - fleet.saving
    assert paid == pytest.approx(driving + costs.waiting(waited_s), abs=1e-4)
    cents = [dict(zip(plan.bill.terms, one.joint_cents, strict=True)) for one in plan.bill.vehicles]
    billed = sum(one["waiting"] for one in cents) / 100
    assert billed == pytest.approx(costs.waiting(waited_s), abs=0.005 * len(own))
    belief, beside = certify(file)
    assert beside == plan
    assert float(belief.saving) == pytest.approx(fleet.saving, rel=1e-3)
    assert float(belief.saving) >= fleet.saving - 1e-6
    assert any("waiting on the road has its price" in one for one in fleet.conditions)


def test_prices_that_fleets_are_not_planned_with_are_refused_in_one_line(net):
    dear = money_costs("eu", delay_per_h=5.0)
    with pytest.raises(ScenarioError, match="prices of delay"):
        po.plan_fleet(asked(net, 4, dear), ROUNDS)
    with pytest.raises(ScenarioError, match="price of waiting and one platoon a trip"):
        po.plan_fleet(
            asked(net, 4, money_costs("eu"), max_platoon=2), po.Limits(rounds=4, per_trip="one")
        )


def test_carriers_and_vehicles_apart(net):
    problem = asked(net, 30)
    carriers = {f"T{k}": "north" if k % 2 else "south" for k in range(30)}
    plan = po.plan_fleet(problem, po.Limits(time_s=None, rounds=14, carriers=carriers))
    companies = [stretch.vehicles for stretch in plan.stretches if stretch.together]
    assert companies
    assert all(len({k % 2 for k in company}) == 1 for company in companies)
    free = po.plan_fleet(problem, po.Limits(time_s=None, rounds=14))
    pair = next(stretch.vehicles[:2] for stretch in free.stretches if stretch.together)
    names = tuple(f"T{k}" for k in pair)
    kept = po.plan_fleet(problem, po.Limits(time_s=None, rounds=14, apart=[names]))
    assert not any(set(pair) <= set(stretch.vehicles) for stretch in kept.stretches)
    assert any("must not" in one for one in kept.fleet.conditions)


def test_one_platoon_a_trip(net):
    problem = asked(net, 30, max_platoon=2)
    plan = po.plan_fleet(problem, po.Limits(per_trip="one"))
    many = po.plan_fleet(problem, ROUNDS)
    assert 0 < plan.fleet.saving <= many.fleet.most * (1 + 1e-9)
    assert plan.fleet.gap < 1e-4
    for index, way in enumerate(plan.ways):
        company = [plan.stretches[k].company for k in way if plan.stretches[k].together]
        assert len(set(company)) <= 1, index


def test_one_platoon_of_any_size_a_trip(net):
    saved = []
    for largest in (2, 3, None):
        problem = asked(net, 30, max_platoon=largest)
        limits = po.Limits(time_s=None, rounds=2, per_trip="one", apart=[("T1", "T2")])
        plan = po.plan_fleet(problem, limits)
        found = [vehicle for one in convoys_of(plan) for vehicle in one.vehicles]
        assert len(found) == len(set(found))
        assert max(len(one.vehicles) for one in convoys_of(plan)) <= (largest or 30)
        assert not any({1, 2} <= {*one.vehicles} for one in convoys_of(plan))
        assert plan.fleet.saving <= plan.fleet.most
        assert any("joins one platoon" in one for one in plan.fleet.conditions)
        saved.append(plan.fleet.saving)
    again = po.plan_fleet(problem, replace(limits, threads=1, rounds=1))
    assert again.stretches == plan.stretches
    assert saved == sorted(saved)


@pytest.mark.parametrize("per_trip", ["many", "one"])
def test_a_platoon_saves_at_least_what_is_asked(net, per_trip):
    problem = asked(net, 24, max_platoon=2)
    limits = {"time_s": None, "rounds": 14, "per_trip": per_trip}
    free = po.plan_fleet(problem, po.Limits(**limits))
    savings = sorted(one.saving for one in convoys_of(free))
    least = savings[len(savings) // 2]
    plan = po.plan_fleet(problem, po.Limits(**limits, min_gain=least))
    found = [one.saving for one in convoys_of(plan)]
    assert found
    assert min(found) >= least * (1 - 1e-9)
    assert plan.fleet.saving <= free.fleet.most * (1 + 1e-9)


def test_trips_that_cannot_be_planned_are_listed_and_the_rest_planned(net):
    late = po.Trip("late", 0, 24, DAY, latest_arrival=DAY + timedelta(minutes=5))
    timeless = po.Trip("timeless", 0, 24)
    nowhere = po.Trip("nowhere", 0, "Atlantis", DAY, flexibility_min=20)
    problem = po.Problem(net, [late, timeless, nowhere, *trips(10)], base(net))
    plan = po.plan_fleet(problem, po.Limits(time_s=None, rounds=8))
    assert [trip.vehicle for trip in plan.trips] == [f"T{k}" for k in range(10)]
    reasons = {one.vehicle: one.reason for one in plan.fleet.unserved}
    assert set(reasons) == {"late", "timeless", "nowhere"}
    assert "late even alone" in reasons["late"]
    assert "earliest_departure" in reasons["timeless"]
    assert "Atlantis" in reasons["nowhere"]


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"rules": "eu561", "task_relief": 1.0}, "driving rules and a task_relief"),
        ({"method": "astar"}, "A\\*"),
        ({"lead": "rotated"}, "rotated lead"), ({"company": "master"}, "company anywhere"),
        ({"delays": po.Delays(5), "robust": True}, "delays"),
    ],
)  # fmt: skip
def test_what_fleets_are_not_planned_with_is_refused_in_one_line(net, change, match):
    with pytest.raises(ScenarioError, match=match) as told:
        po.plan_fleet(asked(net, 4, **change), ROUNDS)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    ("limits", "match"),
    [
        ({"time_s": 0}, "time_s"), ({"rounds": 0}, "rounds"), ({"seed": -1}, "seed"),
        ({"routes": "any"}, "routes"), ({"per_trip": "two"}, "per_trip"),
        ({"apart": [("a", "a")]}, "apart"), ({"apart": "ab"}, "apart"),
        ({"carriers": ["a"]}, "carriers"), ({"threads": 1.5}, "threads"),
    ],
)  # fmt: skip
def test_limits_that_are_none(limits, match):
    with pytest.raises(ScenarioError, match=match):
        po.Limits(**limits)


def test_limits_without_an_end_and_names_without_a_trip(net):
    with pytest.raises(ScenarioError, match="neither time_s nor rounds"):
        po.plan_fleet(asked(net, 4), po.Limits(time_s=None))
    with pytest.raises(ScenarioError, match="no trip; correct the name"):
        po.plan_fleet(asked(net, 4), po.Limits(apart=[("T1", "nobody")]))
    with pytest.raises(ScenarioError, match="is no Problem"):
        po.plan_fleet("trips.csv")


def test_progress_is_told_and_the_gap_never_grows(net):
    told = []
    po.plan_fleet(asked(net), po.Limits(time_s=None, rounds=12), on_progress=told.append)
    assert len(told) > 3
    assert all(0 <= now.share <= 1 for now in told)
    savings = [now.saving for now in told]
    bounds = [now.bound for now in told]
    assert savings == sorted(savings)
    assert bounds == sorted(bounds, reverse=True)
    assert told[-1].gap <= told[0].gap


INTERRUPTED = """
import os, signal, sys
sys.path[:0] = {paths!r}
import platoon_osm as po
from test_plan_fleet import asked, grid
signal.signal(signal.SIGINT, signal.default_int_handler)
def tell(now):
    {act}
plan = po.plan_fleet(
    asked(grid(), 60), po.Limits(time_s=None, rounds=100000), write_to={file!r}, on_progress=tell
)
print(plan.fleet.ended, plan.fleet.saving)
"""


def run_interrupted(file, act):
    paths = [str(ROOT), str(ROOT / "tests" / "fleets"), str(ROOT / "tests" / "support")]
    code = INTERRUPTED.format(paths=paths, file=str(file), act=act)
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False
    )


def test_an_interrupt_ends_the_search_with_the_best_plan(tmp_path):
    file = tmp_path / "fleet.json"
    done = run_interrupted(file, "now.saving and os.kill(os.getpid(), signal.SIGINT)")
    assert done.returncode == 0, done.stderr
    assert done.stdout.split()[0] in ("interrupted", "proved")
    assert certify(file)[1].fleet.saving == float(done.stdout.split()[1])


def test_killed_in_the_middle_the_best_plan_so_far_is_on_disk(tmp_path):
    file = tmp_path / "fleet.json"
    act = f"os.path.exists({str(file)!r}) and now.share > 4e-5 and os._exit(9)"
    done = run_interrupted(file, act)
    assert done.returncode == 9, done.stderr
    _, plan = certify(file)
    assert plan.fleet.ended == "interrupted"
    assert plan.fleet.saving > 0
    assert json.loads(file.read_text())["format"] == "platoon-osm fleet"
    assert [path.name for path in tmp_path.iterdir()] == ["fleet.json"]


def test_time_for_telling_and_writing_the_plan_is_kept(net, tmp_path):
    limits = po.Limits(time_s=None, rounds=2)
    model = modelled(asked(net, 12), limits)
    for file in (None, tmp_path / "fleet.json"):
        course = Course(limits, lambda: False)
        FleetRun(model, limits, course, file, None)
        assert 0 < course.closing_s <= max(1.1 * course.seconds, 12 * A_TRUCK_WRITTEN_S)


def test_nothing_that_can_be_saved_is_told_so():
    net = grid(side=2)
    day = [po.Trip(f"T{k}", k, 3 - k, DAY, flexibility_min=10) for k in range(2)]
    plan = po.plan_fleet(po.Problem(net, day, base(net)), po.Limits(time_s=None, rounds=5))
    fleet = plan.fleet
    assert (fleet.saving, fleet.bound, fleet.gap, fleet.ended) == (0.0, 0.0, 0.0, "proved")
