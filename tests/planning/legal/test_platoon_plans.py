"""Plans under the law of the Union, end to end, against every quarter of an hour of standing."""

from dataclasses import replace

import numpy as np
import pytest
from quarter_hours import asked_of, least, least_for_all, needed, oracle, question
from roads_with_hours import in_country
from soak import chosen, soaked

from platoon_osm import EdgeWeights, inspect_plan, plan_joint
from platoon_osm.errors import NoLegalTripError

LEAST_MET = chosen(2, 20)
met = []
for_all = []


@soaked
@pytest.mark.parametrize("seed", range(chosen(14, 400)))
def test_no_stops_and_no_departure_of_the_master_are_cheaper(seed):
    """Days and weeks near their limits, a Monday on the way, followers relieved or not."""
    problem = question(seed)
    try:
        plan = plan_joint(problem)
    except NoLegalTripError:
        return
    assert not inspect_plan(plan)
    one = oracle(problem)
    stops, rests = needed(one)
    alone = float(one.star.alone.sum())
    pays = plan.joint_cost - one.star.master_alone
    bound = plan.proof.bound - one.star.master_alone
    best = min(alone, least(one, stops + 1, rests))
    assert bound <= best + 1e-6
    if plan.proof.kind == "exact":
        assert pays <= best + 1e-6
    if pays < best - 1e-6 and not stands_longer(plan):
        # It may stand once more than its driving needs after what the driver has behind it.
        assert pays >= least(one, 9, rests + 1) - 1e-6
    met.append(pays < alone - 1e-6)


def stands_longer(plan):
    """Whether its master may stand longer than its law asks for."""
    return any("as long as it likes" in one for one in plan.proof.conditions)


@soaked
@pytest.mark.parametrize("seed", range(501, chosen(530, 700)))
def test_nothing_is_cheaper_for_all_together(seed):
    """Under "system", with a master that gains too: the bound holds, and what is exact is least."""
    problem = question(seed)
    own = problem.objective
    weights = EdgeWeights(own.solo, own.platoon, 0.93 * own.solo, "km", {})
    problem = replace(problem, objective=weights, optimum="system")
    try:
        plan = plan_joint(problem)
    except NoLegalTripError:
        return
    assert not inspect_plan(plan)
    one = oracle(problem)
    stops, rests = needed(one)
    alone = float(one.star.alone.sum()) + one.star.master_alone
    best = min(alone, least_for_all(one, stops + 1, rests))
    assert (plan.joint_cost if plan.proof.bound is None else plan.proof.bound) <= best + 1e-6
    if plan.proof.kind == "exact":
        assert plan.joint_cost <= best + 1e-6
    if not stands_longer(plan):
        assert plan.joint_cost >= min(best, least_for_all(one, 9, rests + 1)) - 1e-6
    for_all.append((plan.joint_cost < alone - 1e-6, plan.proof.kind == "exact"))


def test_some_of_them_meet_for_all():
    """Else the comparison above would compare nothing."""
    assert min(map(sum, zip(*for_all, strict=True)), default=9) >= 2 or not for_all


def test_some_of_them_meet():
    """Else the comparison above would compare nothing."""
    assert sum(met) >= LEAST_MET or not met


def test_a_road_that_only_leads_to_company_may_be_closed():
    """No way alone is, so it is the ways to the platoon and from it that tell."""
    looked = 0
    for seed in range(40):
        problem = question(seed)
        try:
            legal, ways = asked_of(problem)
        except NoLegalTripError:
            continue
        assert ways.open().all() != legal.has_closings
        alone = {int(edge) for route in legal.question.alone for edge in route}
        star = ways.own.star
        ramps = [
            (row, int(edge))
            for row in range(len(star.members))
            for node in np.flatnonzero(np.isfinite(ways.own.times.entry[row])).tolist()
            for edge in ways.approach(row, node)[0]
            if int(edge) not in alone
        ]
        if not ramps:
            continue
        row, edge = ramps[0]
        hours = {edge: {"hgv:conditional": "no @ (00:00-24:00)"}}
        shut = replace(problem, net=in_country(problem.net, "", hours))
        legal, ways = asked_of(shut)
        assert not legal.has_closings
        assert not ways.open()[row]
        assert not inspect_plan(plan_joint(shut))
        looked += 1
        if looked == 3:
            return
    raise AssertionError("no draw has such a road")
