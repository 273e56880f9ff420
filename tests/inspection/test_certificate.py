"""The checker of fleets: what it works out against enumeration, and what it refuses."""

from __future__ import annotations

import copy

import numpy as np
import pytest
from certificates import certificate_of, drawn_shares, empty_shares, file_of, slow_bound
from exhaustive import optimum, random_instance

from platoon_osm.errors import PlatoonError
from platoon_osm.inspection.certificate.belief import certified
from platoon_osm.inspection.certificate.faults import FaultError
from platoon_osm.inspection.certificate.told import told_of
from platoon_osm.inspection.certificate.ways import alone_costs
from platoon_osm.inspection.certificate.dropping import needed_pairs
from platoon_osm.inspection.certificate.windows import all_pairs


def checked(certificate):
    return certified(told_of(file_of(certificate)))


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
    told = told_of(file_of(certificate_of(instance, optimum(instance).schedules, empty_shares(instance))))
    pairs = all_pairs(told)
    if not told.given:
        pairs = needed_pairs(told, pairs, alone_costs(told))
    assert pairs.first.tolist() == instance.first_pair.tolist()
    order = np.lexsort((pairs.lane, told.tail[pairs.lane], np.repeat(np.arange(told.trucks), np.diff(pairs.first))))
    assert order.tolist() == list(range(len(order)))
    for own, theirs in ((pairs.lane, instance.pair_lane), (pairs.opens, instance.opens),
                        (pairs.closes, instance.closes), (pairs.on_alone, instance.on_alone)):
        assert own.tolist() == theirs.tolist()
