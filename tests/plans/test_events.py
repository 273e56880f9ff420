"""Wherever a company grows an event says who joins, and wherever it shrinks who leaves."""

import random

from bundled import italy

import platoon_osm as po
from platoon_osm.plans.events import platoon_events
from platoon_osm.plans.records import Platoon, PlatoonPoint, Stretch


def drawn(rng):
    """Return stretches and ways: at each of some junctions, vehicles drive on in new companies."""
    count = rng.randint(2, 5)
    stretches, ways = [], [[] for _ in range(count)]
    begins = [rng.randint(0, 2) for _ in range(count)]
    ends = [rng.randint(begin + 1, 5) for begin in begins]
    for at in range(5):
        here = [k for k in range(count) if begins[k] <= at < ends[k]]
        rng.shuffle(here)
        while here:
            some = [here.pop() for _ in range(rng.randint(1, len(here)))]
            for k in some:
                ways[k].append(len(stretches))
            stretches.append(Stretch((at,), tuple(some), 1000.0, 60.0, ()))
    company = tuple(range(count))
    return stretches, ways, (Platoon(company, rng.choice([None, *company]), "C"),)


def point(index, kind, stretch):
    return PlatoonPoint(stretch, stretch, 0.0, 0.0, kind, 0.0)


def beside(ways, stretches, number, step):
    """Return the companies in which vehicles of a stretch drive before (-1) or after (+1) it."""
    found = set()
    for index in stretches[number].vehicles:
        place = ways[index].index(number) + step
        inside = 0 <= place < len(ways[index])
        found.add(stretches[ways[index][place]].company if inside else (index,))
    return {tuple(k for k in one if k in stretches[number].vehicles) for one in found}


def is_told(events, ways, stretches, number, kind, step):
    groups = beside(ways, stretches, number, step)
    own = [one for one in events if one.stretch == number and one.kind == kind]
    movers = {k for one in own for k in one.movers}
    # All but one group move, and nobody who stays with who does not.
    staying = [group for group in groups if not movers & set(group)]
    split = [group for group in groups if movers & set(group) and not set(group) <= movers]
    return bool(own) == (len(groups) > 1) and len(staying) <= 1 and not split


def test_every_meeting_and_parting_is_told_once():
    rng = random.Random(1)
    several = 0
    for _ in range(1500):
        stretches, ways, platoons = drawn(rng)
        events = platoon_events(stretches, ways, platoons, point)
        for number, stretch in enumerate(stretches):
            if stretch.together:
                assert is_told(events, ways, stretches, number, "merge", -1)
                assert is_told(events, ways, stretches, number, "separation", 1)
        for one in events:
            several += len(one.movers) > 1 and bool(one.others)
            assert set(one.movers) | set(one.others) == set(stretches[one.stretch].company)
            assert not set(one.movers) & set(one.others)
    assert several > 100


def test_a_master_that_meets_a_platoon_is_joined_by_it():
    net = italy()
    trips = [
        po.Trip("V0", "Torino", "Napoli"),
        po.Trip("V1", "Brescia", "Napoli"),
        po.Trip("V2", "Torino", "Napoli"),
    ]
    plan = po.plan_joint(net, po.paper_weights(net), trips, "best")
    alone_first = [k for k, way in enumerate(plan.ways) if not plan.stretches[way[0]].together]
    assert alone_first == [1]
    met = plan.ways[1][1]
    (event,) = (one for one in plan.events if one.kind == "merge" and one.stretch == met)
    assert sorted((*event.movers, *event.others)) == [0, 1, 2]
