"""Bounds, in floats and as certified, never above the true least cost; and what that cost obeys."""

from __future__ import annotations

import numpy as np
import pytest
from certificates import certificate_of, file_of
from exhaustive import instance_of, optimum, random_instance
from soak import chosen, soaked

from platoon_osm.fleets.bound.bound import Bound
from platoon_osm.inspection.certificate.belief import certified
from platoon_osm.inspection.certificate.told import told_of

LANES = ("tail", "head", "drive", "alone", "member", "extra", "lane_kind")
TRUCKS = ("origin", "destination", "earliest", "latest_departure", "latest", "kind")


def told_shares(instance, shares):
    """Return shares of the planner as a certificate tells them."""
    return {
        "lane_first": shares.lane_first.tolist(), "starts": shares.starts.tolist(),
        "truck": instance.pair_truck[shares.pairs].tolist(),
        "lane": instance.pair_lane[shares.pairs].tolist(),
        "first_bucket": shares.first_bucket.tolist(),
        "first_share": shares.first_share.tolist(), "share": shares.share.tolist(),
    }  # fmt: skip


@soaked
@pytest.mark.parametrize("part", range(chosen(2, 100)))
def test_no_bound_is_above_the_least_cost(part):
    tight = 0
    for seed in range(20 * part, 20 * part + 20):
        waiting = (0, 0, 1, 5)[seed % 4]
        instance = random_instance(seed, waiting=waiting, trucks=2 + seed % 3 if waiting else None)
        best = optimum(instance)
        bound = Bound(instance, seed=seed)
        for steps in (1, 5, 60):
            bound.improve(float(best.cost), steps, lambda: False)
            assert bound.cost <= best.cost + 1e-6
        shares, least = bound.certified()
        certificate = certificate_of(
            instance, best.schedules, told_shares(instance, shares), int(least)
        )
        belief = certified(told_of(file_of(certificate)))
        assert least == belief.least <= best.cost
        # Rounding down takes at most a grain of each share that some schedule pays.
        assert least >= bound.cost - len(shares.share) - 1
        tight += least == best.cost
    assert tight > 5


def columns(instance, trucks):
    """Return lanes and some trucks of an instance as columns."""
    return (
        {name: getattr(instance, name).tolist() for name in LANES},
        {name: getattr(instance, name)[trucks].tolist() for name in TRUCKS},
    )


@pytest.mark.parametrize("seed", range(chosen(12, 400)))
@soaked
def test_one_more_truck_never_makes_the_others_best_worse(seed):
    instance = random_instance(seed, given=False)
    options = {
        "nodes": instance.nodes, "largest": instance.largest, "given": False,
    }  # fmt: skip
    saved = [0]
    for count in range(1, instance.trucks + 1):
        some = instance_of(*columns(instance, np.arange(count)), **options)
        saved.append(int(some.alone_cost.sum()) - optimum(some).cost)
    assert saved == sorted(saved)
    order = np.random.default_rng(seed).permutation(instance.trucks)
    other = instance_of(*columns(instance, order), **options)
    assert int(other.alone_cost.sum()) - optimum(other).cost == saved[-1]
    bounds = []
    for own in (instance, other):
        bound = Bound(own)
        bound.improve(float(optimum(own).cost), 60, lambda: False)
        bounds.append(bound.certified()[1])
    # Steps differ in their last digits, bounds by what is left to gain.
    assert abs(bounds[0] - bounds[1]) <= max(2, 0.02 * instance.alone_cost.sum())
