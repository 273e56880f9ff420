"""Vehicles that must drive together: against every plan in which they do."""

import re
from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from exhaustive import _instants, _schedules, _Search, _shared_choices, optimum
from random_networks import network

import platoon_osm as po
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.fleets.apart_table import read_together
from platoon_osm.fleets.model import modelled
from platoon_osm.inspection.certificate.belief import certify
from platoon_osm.plans.convoys import convoys_of

DAY = datetime(2026, 3, 2, 6)
LIMITS = po.Limits(time_s=None, rounds=12)


def roads(rng, side=3):
    """A grid of two-way roads of 20 to 40 km."""
    node = np.arange(side * side).reshape(side, side)
    pairs = [*zip(node[:, :-1].ravel(), node[:, 1:].ravel(), strict=True)]
    pairs += zip(node[:-1].ravel(), node[1:].ravel(), strict=True)
    length = rng.integers(20_000, 40_000, len(pairs)).astype(float)
    both = [(int(a), int(b)) for a, b in pairs] + [(int(b), int(a)) for a, b in pairs]
    lon, lat = 9 + node % side / 4, 45 + node // side / 4
    return network(
        [a for a, _ in both], [b for _, b in both], [*length, *length], lon.ravel(), lat.ravel()
    )


def asked(seed, trucks=4, largest=None, flexibility=20):
    """A tiny fleet whose first two trips may have the same ends."""
    rng = np.random.default_rng(seed)
    net = roads(rng)
    ends = [rng.choice(9, 2, replace=False).tolist() for _ in range(trucks)]
    if seed % 2:
        ends[1] = ends[0]
    trips = [
        po.Trip(
            f"T{k}", a, b, DAY + timedelta(minutes=int(rng.integers(0, 25))),
            flexibility_min=flexibility,
        )
        for k, (a, b) in enumerate(ends)
    ]  # fmt: skip
    length = net.length_m
    costs = po.EdgeWeights(solo=length, platoon=0.9 * length, master=length, unit="m", params={})
    return po.Problem(net, trips, costs, max_platoon=largest)


class _Together(_Search):
    """The same search, in which only plans count where trucks 0 and 1 drive together."""

    alike: bool

    def _step(self, i, cost):
        if i < len(self.order):
            super()._step(i, cost)
            return
        own = {
            k: self.thinned[j][choice][2]
            for j, (k, choice) in enumerate(zip(self.order, self.chosen, strict=True))
        }
        common = {*own[0]} & {*own[1]}
        kept = {*own[0]} == {*own[1]} if self.alike else bool(common)
        if kept and cost < self.cost - 0.5:
            self.cost, self.found = cost, list(self.chosen)


def best_together(instance):
    """The least cost of all plans in which trucks 0 and 1 drive together; inf if there is none."""
    instants = _instants(instance)
    choices = [_schedules(instance, k, instants, 40_000) for k in range(instance.trucks)]
    search = _shared_choices(instance, choices, _Together)
    search.alike = (instance.origin[0], instance.destination[0]) == (
        instance.origin[1], instance.destination[1],
    )  # fmt: skip
    search._step(0, 0.0)
    return search.cost


def are_together(plan):
    """Whether vehicles 0 and 1 share a stretch, all of them if they have the same ends."""
    own = [{k for k in way if {0, 1} <= {*plan.stretches[k].vehicles}} for way in plan.ways[:2]]
    ends = [(trip.origin, trip.destination) for trip in plan.trips[:2]]
    if ends[0] == ends[1]:
        return own[0] == own[1] == {*plan.ways[0]} == {*plan.ways[1]}
    return bool(own[0]) and own[0] == own[1]


@pytest.mark.parametrize("per_trip", ["many", "one"])
def test_plans_are_no_better_than_all_that_keep_together(per_trip, tmp_path):
    equal, forced, impossible = 0, 0, 0
    for seed in range(20):
        problem = asked(seed, trucks=3, flexibility=(20, 45)[seed // 2 % 2])
        limits = replace(LIMITS, per_trip=per_trip, together=[("T0", "T1")], rounds=4)
        model = modelled(problem, limits)
        least = best_together(model.instance)
        if np.isinf(least):
            impossible += 1
            with pytest.raises(ScenarioError, match="'T0', 'T1' must drive together") as told:
                po.plan_fleet(problem, limits)
            assert "\n" not in str(told.value)
            continue
        plan = po.plan_fleet(problem, limits, write_to=tmp_path / "fleet.json")
        certify(tmp_path / "fleet.json")
        assert are_together(plan)
        unit = model.lanes.grains
        best = (int(model.instance.alone_cost.sum()) - least) / unit
        assert plan.fleet.saving <= best + 1e-6
        free = int(model.instance.alone_cost.sum()) - optimum(model.instance).cost
        assert plan.fleet.bound >= free / unit - 1e-6
        equal += plan.fleet.saving >= best - 1e-3
        forced += best < free / unit - 1e-3
    assert impossible >= 2
    assert forced >= 2
    assert equal >= (20 - impossible) - (2 if per_trip == "many" else 4)


def test_who_needs_no_force_is_planned_as_without():
    problem = asked(1, trucks=4)
    free = po.plan_fleet(problem, LIMITS)
    vehicles = max((one.vehicles for one in convoys_of(free)), key=len)
    names = tuple(f"T{k}" for k in vehicles)
    plan = po.plan_fleet(problem, replace(LIMITS, together=[names]))
    assert any({*vehicles} <= {*one.vehicles} for one in convoys_of(plan))
    assert any("must drive together" in one for one in plan.fleet.conditions)
    again = po.plan_fleet(problem, replace(LIMITS, together=[names], threads=1))
    assert again.stretches == plan.stretches


@pytest.mark.parametrize(
    ("change", "largest", "said"),
    [
        ({"together": [("T0", "T1", "T2")]}, 2, "'T0', 'T1', 'T2' must drive together, and a "
         "platoon has at most 2"),
        ({"together": [("T0", "T1")], "carriers": {"T0": "north"}}, None, "one carrier"),
        ({"together": [("T0", "T1")], "apart": [("T1", "T0")]}, None, "'T0', 'T1' must drive "
         "together and must not"),
        ({"together": [("T0", "T1")], "apart": [("T1", "T2")]}, None, "kept apart from them"),
        ({"together": [("T0", "T1")], "rules": "eu561"}, None, "driving rules and vehicles that"),
        ({"together": [("T0", "T9")]}, None, "together names 'T9', which has no trip"),
    ],
)  # fmt: skip
def test_what_cannot_be_met_is_told_in_one_line(change, largest, said):
    problem = replace(asked(1, largest=largest), rules=change.pop("rules", "none"))
    with pytest.raises(ScenarioError, match=re.escape(said)) as told:
        po.plan_fleet(problem, replace(LIMITS, **change))
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    ("together", "said"),
    [
        ("ab", "give groups of vehicle names"), ([("a",)], "two and more"),
        ([("a", "b"), ("b", "c")], "'b' twice"), ([("a", 1)], "two and more"),
    ],
)  # fmt: skip
def test_groups_that_are_none(together, said):
    with pytest.raises(ScenarioError, match=said):
        po.Limits(together=together)


def test_a_table_of_groups(tmp_path):
    path = tmp_path / "together.csv"
    path.write_text("vehicle,with,with\na,b,c\nd,e\n")
    assert read_together(path) == (("a", "b", "c"), ("d", "e"))
    path.write_text("a,b\nc\n")
    with pytest.raises(PlatoonError, match="line 2: 'c' is no group; give two or more"):
        read_together(path)
