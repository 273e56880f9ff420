"""The checker of fleets: what it works out against enumeration, and what it refuses."""

from __future__ import annotations

import json
from decimal import Decimal

import numpy as np
import pytest
from certificates import (
    certificate_of,
    drawn_shares,
    empty_shares,
    file_of,
    file_with_plan,
    slow_bound,
)
from exhaustive import optimum, random_instance

from platoon_osm.inspection.certificate import cheapest, dropping, heap, sharing, windows
from platoon_osm.inspection.certificate.belief import certified, certified_with_plan
from platoon_osm.inspection.certificate.dropping import needed_pairs
from platoon_osm.inspection.certificate.told import told_of
from platoon_osm.inspection.certificate.warmth import warm_up
from platoon_osm.inspection.certificate.ways import alone_costs
from platoon_osm.inspection.certificate.windows import all_pairs


def checked(certificate):
    return certified(told_of(file_of(certificate)))


def written(seed, **options):
    """Return an instance, its best plan, and the file that proves what can be proved of it."""
    instance = random_instance(seed, **options)
    best = optimum(instance)
    shares = drawn_shares(instance, np.random.default_rng(seed))
    bound = slow_bound(instance, shares)
    certificate = certificate_of(instance, best.schedules, shares, bound)
    return instance, best, file_with_plan(certificate, instance, best.schedules)


@pytest.mark.parametrize("seed", range(30))
def test_a_true_file_is_believed(seed):
    instance, best, file = written(seed, waiting=None)
    belief, plan = certified_with_plan(told_of(json.loads(json.dumps(file))))
    assert belief.saving == (int(instance.alone_cost.sum()) - best.cost) * Decimal("0.01")
    assert belief.bound >= belief.saving
    assert plan.fleet.bound == pytest.approx(float(belief.bound))


@pytest.mark.parametrize("seed", range(40))
def test_it_works_out_what_enumeration_does(seed):
    instance = random_instance(seed, waiting=None)
    best = optimum(instance)
    shares = drawn_shares(instance, np.random.default_rng(seed))
    belief = checked(certificate_of(instance, best.schedules, shares))
    assert belief.least == slow_bound(instance, shares)
    assert belief.cost == best.cost
    assert belief.alone == instance.alone_cost.sum()
    assert belief.least <= best.cost
    assert belief.dearer == 0


@pytest.mark.parametrize("seed", range(20))
def test_its_pairs_are_those_of_the_planner(seed):
    instance = random_instance(seed)
    schedules = optimum(instance).schedules
    told = told_of(file_of(certificate_of(instance, schedules, empty_shares(instance))))
    pairs = all_pairs(told)
    if not told.given:
        pairs = needed_pairs(told, pairs, alone_costs(told))
    assert pairs.first.tolist() == instance.first_pair.tolist()
    for name, column in (
        ("pair_lane", pairs.lane), ("opens", pairs.opens), ("closes", pairs.closes),
        ("on_alone", pairs.on_alone),
    ):  # fmt: skip
        assert column.tolist() == getattr(instance, name).tolist(), name


def test_after_warming_up_nothing_is_compiled_any_more():
    warm_up()
    kernels = [
        item
        for module in (cheapest, dropping, heap, sharing, windows)
        for item in vars(module).values()
        if hasattr(item, "signatures") and item.__module__ == module.__name__
    ]
    before = [len(kernel.signatures) for kernel in kernels]
    called = {kernel.__name__ for kernel, count in zip(kernels, before, strict=True) if count == 1}
    # Others are part of these, and need not be loaded themselves.
    assert called >= {"_cheapest", "_windows", "_mark_overlaps", "_mark_cheaper", "_first_invalid"}
    for given in (True, False):
        certified_with_plan(told_of(written(3, waiting=1, largest=2, given=given)[2]))
    assert [len(kernel.signatures) for kernel in kernels] == before
