"""A platoon under the law against every stop, departure, pair of points and second of standing."""

import math

import numpy as np
import pytest
from small_law import NO_PARTS, all_stops, drawn

from platoon_osm.planning.legal import platoon_search
from platoon_osm.planning.legal.platoon_record import MASTER, Timetable
from platoon_osm.planning.legal.platoon_search import search_platoon


@pytest.fixture(autouse=True)
def short_spans(monkeypatch):
    """Let spans of a few seconds be split, too, and pairs be ruled out at once."""
    monkeypatch.setattr(platoon_search, "SPLIT_S", 3)
    monkeypatch.setattr(platoon_search, "ASKED_AT", range(1, 99))


def pairs_of(star, member):
    nodes = range(len(star.node_at))
    cost = star.entry[member][:, None] + star.leave[member] + np.subtract.outer(
        -star.platoon[member], -star.platoon[member]
    )  # fmt: skip
    return sorted((cost[i, j], i, j) for i in nodes for j in nodes if i < j)


def cheapest(one, table, alone, member, known):
    """Try all pairs, the cheapest first."""
    star = one.star
    for cost, i, j in pairs_of(star, member):
        if cost >= alone[member]:
            break
        low, high = star.node_at[i], star.node_at[j]
        key = member, i, j, table.stops, tuple(table.leave_s[low:high])
        if key not in known:
            known[key] = one.real(member, i, j, table) is not None
        if known[key]:
            return cost
    return alone[member]


def everything(one, rests=0):
    """Return the least cost of members over all stops and departures; inf if there is none."""
    star = one.star
    members = range(len(star.alone))
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in members]
    best, known = math.inf, {}
    drive = int(star.road.drive_s.sum())
    for stops in all_stops(star, rests):
        stood = sum(length for _, length in stops)
        last = min(star.window.latest_s, star.window.arrival_s - drive - stood)
        for departure in range(star.window.earliest_s, last + 1):
            table = Timetable.of(star, departure, stops)
            if one.real(MASTER, 0, 0, table) is not None:
                best = min(best, sum(cheapest(one, table, alone, k, known) for k in members))
    return best, alone


KINDS = {
    "rest only where it may": {},
    "rest anywhere": {"everywhere": True},
    "half relieved": {"relief": 0.5},
    "fully relieved": {"relief": 1.0},
    "no break in parts": {"limits": NO_PARTS},
    "a night on the way": {"night": True},
}


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_cheaper_than_what_is_found(kind, seed):
    one = drawn(1000 + seed, **KINDS[kind])
    rests = int(kind == "a night on the way")
    best, alone = everything(one, rests)
    found = search_platoon(
        one.star, one.real, 60, free=one.free, in_time=np.isfinite(alone), extra_stops=6
    )
    assert found.proved
    if math.isinf(best) and not rests:
        # A rest more than its driving needs may help a master that cannot go without.
        best, _ = everything(one, 1)
    assert found.cost - one.star.master_alone == pytest.approx(best)


def test_draws_hold_what_matters():
    """Else the comparison above would compare nothing."""
    met, apart, nobody = 0, 0, 0
    for seed in range(40):
        one = drawn(seed)
        found = search_platoon(one.star, one.real, 60, extra_stops=6)
        nobody += found.timetable is None
        for member in found.members:
            met += not member.is_alone
            apart += member.is_alone
    assert min(met, apart, nobody) >= 5
