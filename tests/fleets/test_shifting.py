"""Shifted instants: the same companies, nobody later, no wait on the road that could be at home."""

import numpy as np
import pytest

from platoon_osm.fleets.companies import companies_of, platoons_within
from platoon_osm.fleets.instance import Instance
from platoon_osm.fleets.shifting import shifted


def drawn(seed, trucks=7, lanes=6, slack=9):
    """A line of roads and trucks that drive parts of it, snapped to each other at random."""
    rng = np.random.default_rng(seed)
    drive = rng.integers(1, 5, lanes)
    begins = rng.integers(0, lanes, trucks)
    ends = np.array([rng.integers(b, lanes) + 1 for b in begins])
    ways = [np.arange(b, e) for b, e in zip(begins, ends, strict=True)]
    earliest = rng.integers(0, 8, trucks)
    latest = earliest + [drive[way].sum() for way in ways] + rng.integers(0, slack, trucks)
    leaves = earliest + rng.integers(0, 4, trucks)
    departs, entered = [], {}
    for k, way in enumerate(ways):
        at, own = earliest[k], []
        for lane in way.tolist():
            left = drive[lane : ends[k]].sum()
            close = latest[k] - left
            close = min(close, max(at, leaves[k])) if lane == way[0] else close
            open_to = [t for t in entered.get(lane, ()) if at <= t <= close]
            if open_to and rng.random() < 0.8:
                at = int(rng.choice(open_to))
            else:
                at = int(rng.integers(at, close + 1))
            own.append(at)
            entered.setdefault(lane, set()).add(at)
            at += drive[lane]
        departs.append(np.array(own, np.int64))
    one = np.ones(lanes, np.int64)
    pairs = np.concatenate(ways)
    sizes = [len(way) for way in ways]
    leaves = np.array([max(d[0], x) for d, x in zip(departs, leaves, strict=True)])
    instance = Instance(
        nodes=lanes + 1, tail=np.arange(lanes), head=np.arange(lanes) + 1, drive=drive,
        alone=10 * one, member=9 * one, extra=one, lane_kind=0 * one, origin=begins,
        destination=ends, earliest=earliest, latest_departure=leaves, latest=latest,
        kind=np.zeros(trucks), largest=int(rng.choice([0, 2, 3])), given=True, waiting=0,
        first_pair=np.concatenate([[0], np.cumsum(sizes)]),
        pair_truck=np.repeat(np.arange(trucks), sizes), pair_lane=pairs, opens=0 * pairs,
        closes=0 * pairs, on_alone=np.ones(len(pairs), bool), alone_cost=np.zeros(trucks),
    )  # fmt: skip
    return instance, ways, departs


def waits(instance, ways, departs):
    """Ticks on the road without moving, truck by truck."""
    return [
        int(np.maximum(0, at[1:] - at[:-1] - instance.drive[way[:-1]]).sum())
        for way, at in zip(ways, departs, strict=True)
    ]


@pytest.mark.parametrize("seed", range(120))
def test_shifting_keeps_companies_and_windows(seed):
    instance, ways, departs = drawn(seed)
    found = shifted(instance, ways, departs)
    for k, (way, before, after) in enumerate(zip(ways, departs, found, strict=True)):
        assert after[0] >= instance.earliest[k]
        assert after[0] <= instance.latest_departure[k]
        assert (after[1:] >= after[:-1] + instance.drive[way[:-1]]).all()
        assert after[-1] <= before[-1]
    met = {}
    for way, before, after in zip(ways, departs, found, strict=True):
        for lane, old, new in zip(way.tolist(), before.tolist(), after.tolist(), strict=True):
            assert met.setdefault((lane, old), new) == new
    assert sum(waits(instance, ways, found)) <= sum(waits(instance, ways, departs))


def test_a_wait_for_a_merge_is_moved_to_the_origin():
    instance, ways, departs = drawn(3)
    alone = [np.sort(at) for at in departs]
    assert len(alone) == len(ways)
    way = np.array([0, 1])
    late = np.array([0, 0 + instance.drive[0] + 3], np.int64)
    lone = Instance(
        **{
            name: getattr(instance, name)
            for name in ("nodes", "tail", "head", "drive", "alone", "member", "extra",
                         "lane_kind", "largest", "given", "waiting")
        },
        origin=np.array([0, 1]), destination=np.array([2, 2]),
        earliest=np.array([0, late[1]]), latest_departure=np.array([90, 90]),
        latest=np.array([99, 99]), kind=np.zeros(2), first_pair=np.array([0, 2, 3]),
        pair_truck=np.array([0, 0, 1]), pair_lane=np.array([0, 1, 1]), opens=np.zeros(3),
        closes=np.zeros(3), on_alone=np.ones(3, bool), alone_cost=np.zeros(2),
    )  # fmt: skip
    found = shifted(lone, [way, way[1:]], [late, late[1:]])
    assert found[0].tolist() == [3, late[1]]
    assert found[1].tolist() == [late[1]]


@pytest.mark.parametrize("seed", range(60))
def test_companies_are_those_who_enter_at_one_instant_in_as_few_platoons_as_allowed(seed):
    instance, ways, departs = drawn(seed, trucks=11, slack=20)
    found = companies_of(instance, ways, departs)
    together = {}
    for k, (way, at) in enumerate(zip(ways, departs, strict=True)):
        for place, key in enumerate(zip(way.tolist(), at.tolist(), strict=True)):
            together.setdefault(key, []).append(k)
            assert k in found[k][place]
    for (lane, at), trucks in together.items():
        platoons = {
            found[k][ways[k].tolist().index(lane)]
            for k in trucks
            if departs[k][ways[k].tolist().index(lane)] == at
        }
        assert sorted(one for platoon in platoons for one in platoon) == trucks
        q = instance.largest or 99
        assert len(platoons) == -(-len(trucks) // q)
        assert all(len(platoon) <= q for platoon in platoons)
        alone = sum(len(platoon) == 1 for platoon in platoons)
        assert alone == (1 if len(trucks) == 1 or (q == 2 and len(trucks) % 2) else 0)


def test_platoons_stay_together_where_that_fits():
    before = {0: (0, 3), 3: (0, 3), 1: (1, 2, 4), 2: (1, 2, 4), 4: (1, 2, 4), 5: (5,)}
    assert sorted(platoons_within(range(6), 3, before)) == [(0, 3, 5), (1, 2, 4)]
