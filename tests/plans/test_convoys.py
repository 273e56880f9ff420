"""Platoons of a fleet's plan: against chains grown one vehicle at a time."""

import pytest
from line_fleets import DRIVE_S, ROAD_M, line_fleet
from soak import chosen, soaked

from platoon_osm.plans.convoys import convoys_of, vehicle_m_by_size


def chains(companies):
    """Grow each platoon from one company: add whoever drives into or out of it without a stop."""
    together = [one for one in companies if len(one[1]) > 1]
    left = set(together)
    found = []
    while left:
        chain = {left.pop()}
        grows = True
        while grows:
            near = {
                one
                for one in left
                for road, own, start in chain
                if set(own) & set(one[1])
                and abs(one[0] - road) == 1
                and one[2] - start == DRIVE_S * (one[0] - road)
            }
            chain |= near
            left -= near
            grows = bool(near)
        found.append(frozenset(chain))
    return set(found)


@soaked
@pytest.mark.parametrize("seed", chosen(range(25), range(2000)))
def test_platoons_are_chains_of_companies(seed):
    plan, net, companies = line_fleet(seed, 2 + seed % 13, 2 + seed % 7)
    found = convoys_of(plan)
    wanted = chains(companies)
    assert {frozenset(companies[k] for k in one.stretches) for one in found} == wanted
    assert len(found) == len(wanted)
    for one in found:
        own = [companies[k] for k in one.stretches]
        assert one.vehicles == tuple(sorted({truck for _, who, _ in own for truck in who}))
        assert one.largest == max(len(who) for _, who, _ in own)
        assert one.begins_s == min(start for *_, start in own)
        assert one.ends_s == max(start for *_, start in own) + DRIVE_S
        assert one.vehicle_m == pytest.approx(sum(len(who) for _, who, _ in own) * ROAD_M)
        assert one.saving == pytest.approx(2.0 * sum(len(who) - 1 for _, who, _ in own))
        if one.forms:
            first = min(road for road, _, start in own if start == one.begins_s)
            assert one.forms == net.place_name(first)
    assert sum(one.saving for one in found) == pytest.approx(plan.fleet.saving)
    sums = vehicle_m_by_size(plan)
    assert sum(sums.values()) == pytest.approx(sum(v.length_m for v in plan.vehicles))
    assert sum(m for size, m in sums.items() if size > 1) == pytest.approx(plan.platoon_m)


def test_a_place_has_its_name_from_whoever_begins_or_ends_there():
    untold = 0
    for seed in range(60):
        plan, net, companies = line_fleet(seed, 9, 6)
        for one in convoys_of(plan):
            first = one.stretches[0]
            way = [way for way in plan.ways if first in way]
            # These come from a stretch at whose end another truck has arrived.
            before = {own[own.index(first) - 1] for own in way if own[0] != first}
            ends = {own[-1] for own in plan.ways}
            begun = any(own[0] == first for own in way)
            if begun or before & ends:
                assert one.forms == net.place_name(companies[first][0])
                untold += not begun
            assert one.parts in ("", net.place_name(companies[one.last][0] + 1))
    assert untold > 5


def test_the_frame_of_platoons():
    plan, *_ = line_fleet(3, 9, 5)
    frame = plan.to_frame("platoons")
    assert len(frame) == len(convoys_of(plan)) > 1
    assert frame["saving_EUR"].sum() == pytest.approx(plan.fleet.saving)
    assert (frame["parts"] > frame["forms"]).all()
    alone, *_ = line_fleet(0, 1, 3)
    assert list(alone.to_frame("platoons")) == list(frame)
