"""A master that stands longer for its members, against every stop and every second more of it."""

import itertools
import math
from dataclasses import replace
from datetime import datetime

import numpy as np
import pytest
from small_law import all_stops, drawn
from soak import chosen

import platoon_osm as po
from platoon_osm.planning.legal.platoon import kernel, longer_stops, spans
from platoon_osm.planning.legal.platoon.record import MASTER, Timetable
from platoon_osm.planning.legal.platoon.search import search_platoon
from platoon_osm.planning.legal.platoon.star_times import Span

MORE = 3
"""By how much each stop may last longer in the comparison."""


@pytest.fixture
def few_seconds(monkeypatch):
    """Let waits and spans be of few seconds."""
    monkeypatch.setattr(spans, "SPLIT_S", 3)
    monkeypatch.setattr(kernel, "CELLS", 3)
    monkeypatch.setattr(longer_stops, "WAITS_S", (1, 2, 3, 5))
    monkeypatch.setattr(longer_stops, "LONGER_BREAKS_S", (1, 2, 4))


def bound_to_leave(seed):
    """Return a star whose master has to leave at one moment, and may arrive later."""
    one = drawn(seed)
    begin = one.star.window.earliest_s
    one.star = replace(one.star, window=Span(begin, begin, one.star.window.arrival_s + 3))
    return one


class Costs:
    """What members pay, pair by pair, with the real trips of an oracle."""

    def __init__(self, one):
        self.one, self.known = one, {}
        members = range(len(one.star.alone))
        self.alone = [one.star.alone[k] if one.goes_alone(k) else math.inf for k in members]

    def of(self, stops, departure):
        """Return what all members pay; inf if the master cannot drive like that."""
        star, one = self.one.star, self.one
        table = Timetable.of(star, departure, stops)
        late = table.arrive_s[-1] > star.window.arrival_s
        if late or one.real(MASTER, 0, 0, table) is None:
            return math.inf
        return sum(self.cheapest(table, member) for member in range(len(self.alone)))

    def cheapest(self, table, member):
        """Return what one pays."""
        star, best = self.one.star, self.alone[member]
        entry, leave, own = star.entry[member], star.leave[member], star.platoon[member]
        for i, j in itertools.combinations(range(len(star.node_at)), 2):
            cost = entry[i] + own[j] - own[i] + leave[j]
            low, high = star.node_at[i], star.node_at[j]
            key = member, i, j, table.stops, tuple(table.leave_s[low:high])
            if cost >= best:
                continue
            if key not in self.known:
                self.known[key] = self.one.real(member, i, j, table) is not None
            best = cost if self.known[key] else best
        return best

    def least(self, more):
        """Return the least cost over all stops, each up to some seconds longer."""
        departure, best = self.one.star.window.earliest_s, math.inf
        for stops in all_stops(self.one.star, 0):
            for longer in itertools.product(range(more + 1), repeat=len(stops)):
                held = tuple(
                    (at, some + wait) for (at, some), wait in zip(stops, longer, strict=True)
                )
                best = min(best, self.of(held, departure))
        return best


SEEDS = chosen((0, 12, 20, 33, 36, 37, 42, 46, 47, 48), range(60))


def test_it_stands_longer_where_that_is_cheaper(few_seconds):
    waited, as_good, compared = 0, 0, 0
    for seed in SEEDS:
        one = bound_to_leave(seed)
        costs, own = Costs(one), one.star.master_alone
        in_time = np.isfinite(costs.alone)
        asked = one.star, one.real, 60
        found = search_platoon(*asked, roads=one, in_time=in_time, extra_stops=6)
        stands = search_platoon(*asked, roads=one, in_time=in_time, extra_stops=6, waits=False)
        if math.isinf(costs.least(0)):
            continue
        compared += 1
        assert stands.cost - own == pytest.approx(costs.least(0))
        assert found.waits == (found.cost < stands.cost - 1e-6)
        assert found.cost - own == pytest.approx(costs.of(found.stops, found.departure_s))
        least = costs.least(MORE)
        assert found.waiting_bound - own <= min(least, found.cost - own) + 1e-6
        waited += found.waits
        as_good += found.cost - own <= least + 1e-6
        if found.waits:
            for k, (at, length) in enumerate(found.stops):
                less = (*found.stops[:k], (at, length - 1), *found.stops[k + 1 :])
                if (at, length) not in stands.stops:
                    assert costs.of(less, found.departure_s) > found.cost - own - 1e-9
    assert waited >= 3
    assert as_good >= 0.95 * compared


def test_who_has_to_leave_on_time_waits_for_company_at_its_breaks():
    """Four to Napoli that leave at six: one break of the master is longer, and all is legal."""
    net = po.load_network("italy-motorways")
    six = datetime(2026, 3, 3, 6)
    starts = ("Milano", "Torino", "Venezia", "Brescia")
    trips = [po.Trip(one, one, "Napoli", six, latest_departure=six) for one in starts]
    plan = po.plan_joint(net, po.paper_weights(net), trips, rules="eu561")
    assert plan.proof.kind == "bound"
    assert any("as long as it likes" in one for one in plan.proof.conditions)
    assert plan.proof.bound < plan.joint_cost
    leads = plan.timetable.vehicles[plan.platoons[0].master]
    longest = max(one.end_s - one.start_s for one in leads.pauses if "break" in one.purposes)
    assert longest > 45 * 60 + 60
    assert not po.inspect_plan(plan)
