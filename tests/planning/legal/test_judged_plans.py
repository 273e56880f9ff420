"""Plans before two judges that know nothing of the planner: the checker, and the articles."""

import random
from dataclasses import replace
from datetime import datetime, timedelta

import pytest
from articles import legal, records
from soak import chosen

from platoon_osm import PaperCosts, Problem, Trip, inspect_plan, load_network, solve
from platoon_osm.driving.state import DriverState
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.plans.plan import Plan

NORTH = ("Milano", "Torino", "Venezia", "Brescia", "Genova", "Verona", "Padova")
SOUTH = ("Roma", "Napoli", "Firenze", "Ancona", "Bari", "Bologna")
SEEDS = chosen((0, 1, 2, 3, 4, 5, 6, 8, 37), range(200))


@pytest.fixture(scope="module")
def net():
    return load_network("italy-motorways")


def drawn_state(rng):
    if rng.random() < 0.3:
        return DriverState(drivers=rng.choice([1, 1, 2]))
    broken = rng.choice([0, rng.randint(0, 16_200), rng.randint(15_000, 16_200)])
    today = rng.randint(broken, 30_000)
    return DriverState(
        driven_since_break_s=broken, driven_today_s=today, duty_s=today + rng.randint(0, 7200),
        first_part_taken=broken > 0 and rng.random() < 0.3, driven_this_week_s=today,
        long_days_used=rng.randint(0, 2), reduced_rests_used=rng.randint(0, 3),
        since_weekly_rest_s=today + 7200, drivers=rng.choice([1, 1, 1, 2]),
    )  # fmt: skip


def question(net, seed):
    """Draw one or two trips that begin on a Monday or Tuesday, when no week matters."""
    rng = random.Random(seed)
    first = datetime(2026, 3, rng.choice([2, 3]), rng.randrange(4, 20))
    trips = [
        Trip(
            f"v{k}", rng.choice(NORTH), rng.choice(SOUTH), first + timedelta(minutes=20 * k),
            flexibility_min=rng.choice([0, 60, 120, 240]), driver=drawn_state(rng),
        )
        for k in range(rng.choice([1, 2, 2]))
    ]  # fmt: skip
    return Problem(
        net, tuple(trips), PaperCosts(), rules="eu561", task_relief=rng.choice([0, 0, 0.5, 1])
    )


def by_law(plan):
    """Return who breaks the law by the checker, and who by the articles."""
    names = [trip.vehicle for trip in plan.trips]
    own = [one for one in inspect_plan(plan) if one.violation.article not in ("plan", "window")]
    by_articles = {
        name for k, name in enumerate(names) if not all(map(legal, records(plan, k)))
    }  # fmt: skip
    return {one.vehicle for one in own if one.violation.over_s > 3}, by_articles


def mutated(plan, rng):
    """Return a plan in which a vehicle stands or drives longer or shorter, on its own."""
    table = plan.timetable
    k = rng.randrange(len(plan.trips))
    times = table.vehicles[k]
    legs = [list(leg) for leg in times.legs]
    at = rng.randrange(len(legs))
    gap = legs[at][0] - legs[at - 1][1] if at else 0.0
    lasts = rng.choice([-gap, -rng.random() * gap, -min(gap, 600.0), 1800.0, 7200.0])
    for later in range(at, len(legs)):
        legs[later] = [moment + lasts for moment in legs[later]]
    if not at or not lasts:
        legs[at][1] += 900.0
        for later in range(at + 1, len(legs)):
            legs[later] = [moment + 900.0 for moment in legs[later]]
    drivers = times.drivers
    if len(drivers) == 2 and rng.random() < 0.5:
        swapped = [list(one.drives) for one in drivers]
        giver = 0 if at in swapped[0] else 1
        swapped[giver].remove(at)
        swapped[1 - giver] = sorted([*swapped[1 - giver], at])
        drivers = tuple(
            replace(one, drives=tuple(own)) for one, own in zip(drivers, swapped, strict=True)
        )
    own = replace(
        times, legs=tuple(map(tuple, legs)), pauses=(), drivers=drivers,
        departure_s=min(times.departure_s, legs[0][0]),
    )  # fmt: skip
    vehicles = tuple(own if i == k else one for i, one in enumerate(table.vehicles))
    late = any(one.late_s for one in vehicles)
    return replace(plan, timetable=replace(table, vehicles=vehicles, feasible=not late))


@pytest.mark.parametrize("seed", SEEDS)
def test_both_judges_find_nothing_and_agree_on_mutated_plans(net, seed):
    try:
        plan = solve(question(net, seed))
    except ScenarioError as error:
        pytest.skip(str(error))
    assert by_law(plan) == (set(), set())
    assert plan.joint_cost <= plan.solo_cost * (1 + 1e-9)
    assert plan.proof.bound <= plan.joint_cost * (1 + 1e-9)
    assert Plan.from_dict(plan.to_dict()) == plan
    rng = random.Random(seed)
    for _ in range(40):
        try:
            other = mutated(plan, rng)
            for _ in range(rng.randrange(3)):
                other = mutated(other, rng)
        except PlatoonError:
            continue
        by_checker, by_articles = by_law(other)
        assert by_checker == by_articles


def test_the_mutated_plans_are_both_legal_and_not(net):
    rng = random.Random(0)
    plan = solve(
        Problem(net, (Trip("A", "Milano", "Napoli", datetime(2026, 3, 2, 6)),), PaperCosts(),
                rules="eu561")
    )  # fmt: skip
    told = [bool(by_law(mutated(plan, rng))[0]) for _ in range(30)]
    assert 5 < sum(told) < 25
