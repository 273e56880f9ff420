"""Questions under the law of the Union whose times are whole quarters of an hour, and their oracle.

Costs know no times, and every limit is a whole number of quarters. So what can be driven at all can
be driven at such moments, and every quarter of standing is enough to try.
"""

import itertools
import math
from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
from small_law import Drawn, all_stops

from platoon_osm import Trip
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.driving.state import DriverState
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.asked import Asked
from platoon_osm.planning.legal.driver.road import FREE, road_of
from platoon_osm.planning.legal.legal_question import LegalQuestion
from platoon_osm.planning.legal.member_ways import MemberWays
from platoon_osm.planning.legal.platoon.record import MASTER, Timetable
from platoon_osm.planning.legal.platoon.star_times import NEVER_S, OPEN_S, Span, VehicleRules
from platoon_osm.planning.legal.star_input import star_way
from platoon_osm.planning.problem import Problem

QUARTER = 900
HALF_HOUR_M = 40_000.0
"""What is driven in half an hour."""

MONDAY = datetime(2026, 3, 9)
SPANS = ("spell", "break", "day", "long_day", "rest", "reduced_rest", "window", "long_window",
         "week", "fortnight", "weekly_rest", "weekly_after")  # fmt: skip


def question(seed, members=2):
    """Draw a road with turn-offs, a master that drives it, and members that come and go."""
    rng = np.random.default_rng(seed)
    line = int(rng.integers(4, 6))
    hops = rng.integers(2, 7, line - 1)
    edges = [(k, k + 1, int(one)) for k, one in enumerate(hops)]
    near_monday = rng.random() < 0.4
    first = MONDAY - timedelta(hours=6) if near_monday else datetime(2026, 3, 3, 6)
    trips, nodes = [], line
    for k in range(members):
        ends = []
        for side in range(2):
            if rng.random() < 0.3:
                ends.append(int(rng.integers(0, 2)) if side == 0 else line - 1)
                continue
            low = 0 if side == 0 else line // 2
            for at in rng.choice(
                np.arange(low, low + line // 2 + line % 2 * side), 2, replace=False
            ):
                half_hours = int(rng.integers(1, 4))
                edges.append((nodes, int(at), half_hours) if side == 0 else
                             (int(at), nodes, half_hours))  # fmt: skip
            ends.append(nodes)
            nodes += 1
        if ends[0] >= ends[1] and ends[1] < line:
            ends[0] = 0
        trips.append(drawn_trip(rng, f"M{k}", *ends, first, near_monday))
    trips.insert(0, drawn_trip(rng, "A", 0, line - 1, first, near_monday))
    if rng.random() < 0.5:
        edges.append((int(rng.integers(1, line - 1)), nodes, 1))
        nodes += 1
    edges.sort(key=lambda one: one[:2])
    net = RoadNetwork.from_edges(
        [one[0] for one in edges], [one[1] for one in edges],
        [one[2] * HALF_HOUR_M for one in edges],
        lon=np.arange(nodes) / 10, lat=45 + np.arange(nodes) % 3 / 10,
    )  # fmt: skip
    solo = net.length_m / 1000 * rng.uniform(0.9, 1.1, net.m)
    weights = EdgeWeights(solo, 0.8 * solo, solo, "km", {})
    return Problem(
        net, tuple(trips), weights, rules="eu561", case="C", master="A", company="master",
        task_relief=float(rng.choice([0.0, 0.5, 1.0])),
    )  # fmt: skip


def drawn_trip(rng, name, origin, destination, first, near_monday):
    """Draw when a vehicle may drive, and what its driver has behind it."""
    hours = 3600.0 / QUARTER  # quarters of an hour
    today = int(rng.integers(0, 30)) if rng.random() < 0.5 else 0
    broken = min(today, int(rng.integers(0, 19)))
    duty = None if not today and rng.random() < 0.6 else today + int(rng.integers(0, 12))
    week = today + int(rng.integers(0, 40))
    if near_monday or rng.random() < 0.3:
        week = max(today, 56 * hours - int(rng.integers(16, 70)))
    since = 0.0 if duty is None else max(duty, 144 * hours - int(rng.integers(30, 120)))
    state = DriverState(
        driven_since_break_s=broken * QUARTER, driven_today_s=today * QUARTER,
        first_part_taken=bool(broken and rng.random() < 0.3),
        duty_s=None if duty is None else duty * QUARTER, driven_this_week_s=week * QUARTER,
        driven_last_week_s=min(56 * hours, 90 * hours - week) * QUARTER * float(rng.random() < 0.4),
        since_weekly_rest_s=since * QUARTER, long_days_used=int(rng.integers(0, 3)),
        reduced_rests_used=int(rng.integers(2, 4)),
    )  # fmt: skip
    return Trip(
        name, origin, destination, first + timedelta(seconds=QUARTER * int(rng.integers(0, 9))),
        flexibility_min=15.0 * int(rng.integers(0, 9)), driver=state,
    )  # fmt: skip


def quarters(seconds):
    """Return seconds as quarters of an hour; what has no end keeps none."""
    found = np.asarray(seconds, np.int64)
    far = (abs(found) >= OPEN_S) | (found == FREE)
    assert not (found[~far] % QUARTER).any()
    return np.where(far, found, found // QUARTER)


def small(rules):
    """Return a vehicle's law with times in quarters."""
    limits, state = rules.limits, rules.state
    own = {f"{name}_s": getattr(limits, f"{name}_s") / QUARTER for name in SPANS}
    limits = replace(limits, parts_s=tuple(one / QUARTER for one in limits.parts_s), **own)
    times = {
        name: getattr(state, name) / QUARTER for name in DriverState.__dataclass_fields__
        if name.endswith("_s") and getattr(state, name) is not None
    }  # fmt: skip
    return VehicleRules(limits, replace(state, **times), int(quarters(rules.state_at_s)))


def asked_of(problem):
    """Return a problem's question with its law, and the ways of its master's star."""
    asked = Asked.of(problem).question
    legal = LegalQuestion(asked, [problem.vehicle_of(trip) for trip in problem.trips])
    return legal, MemberWays(legal, star_way(legal, asked.star(0), "C"))


def oracle(problem):
    """Return the master's star of a problem, in quarters, and the real ways of its members."""
    _, ways = asked_of(problem)
    star = ways.own.times

    def road(one):
        return road_of(quarters(one.drive_s), one.stay_s)

    def spans(window):
        return Span(*(int(quarters(one)) for one in
                      (window.earliest_s, window.latest_s, window.arrival_s)))  # fmt: skip

    def told(one):
        return tuple(quarters(one.drive_s).tolist()), tuple(one.stay_s.tolist())

    members, nodes = range(len(star.alone)), range(len(star.node_at))
    in_quarters = replace(
        star, road=road(star.road), window=spans(star.window), rules=small(star.rules),
        approach_s=quarters(star.approach_s), onward_s=quarters(star.onward_s),
        alone_s=quarters(star.alone_s), windows=tuple(map(spans, star.windows)),
        member_rules=tuple(map(small, star.member_rules)), monday_s=0,
    )  # fmt: skip
    known = [
        [[told(ask(m, i)) if times[m, i] < NEVER_S else None for i in nodes] for m in members]
        for ask, times in (
            (ways.trips.road_to, star.approach_s), (ways.trips.road_from, star.onward_s)
        )
    ]  # fmt: skip
    next_week = int(quarters(star.monday_s + 7 * 86_400))
    return Drawn(in_quarters, *known, [], next_week)


def cheapest(one, table, member, known):
    """Return what a member pays: its pairs are tried, the cheapest first."""
    star = one.star
    entry, leave, platoon = star.entry[member], star.leave[member], star.platoon[member]
    pairs = sorted(
        (entry[i] + platoon[j] - platoon[i] + leave[j], i, j)
        for i, j in itertools.combinations(range(len(star.node_at)), 2)
    )
    for cost, i, j in pairs:
        if cost >= star.alone[member] - 1e-9:
            break
        low, high = star.node_at[i], star.node_at[j]
        key = member, i, j, table.stops, tuple(table.leave_s[low:high])
        if key not in known:
            known[key] = one.real(member, i, j, table) is not None
        if known[key]:
            return cost
    return star.alone[member]


def timetables(one, most_stops, rests):
    """Yield what the master can drive, at all departures with so many stops."""
    star = one.star
    drive = int(star.road.drive_s.sum())
    for stops in all_stops(star, rests):
        if len(stops) > most_stops:
            continue
        stood = sum(length for _, length in stops)
        last = min(star.window.latest_s, star.window.arrival_s - drive - stood)
        for departure in range(star.window.earliest_s, last + 1):
            table = Timetable.of(star, departure, stops)
            if one.real(MASTER, 0, 0, table) is not None:
                yield table


def least(one, most_stops, rests):
    """Return the least that members pay over all departures and so many stops of the master."""
    members, best, known = range(len(one.star.alone)), math.inf, {}
    for table in timetables(one, most_stops, rests):
        best = min(best, sum(cheapest(one, table, k, known) for k in members))
    return best


def least_for_all(one, most_stops, rests):
    """Return the least that members and master pay: what it gains counts once an edge."""
    star, best, known = one.star, math.inf, {}
    members = range(len(star.alone))
    for table in timetables(one, most_stops, rests):
        options = [list(drivable_pairs(one, table, k, known)) for k in members]
        for some in itertools.product(*options):
            met = {edge for _, i, j in some for edge in range(i, j)}
            best = min(best, sum(cost for cost, _, _ in some) - sum(star.gain[k] for k in met))
    return best + star.master_alone


def drivable_pairs(one, table, member, known):
    """Yield what a member may do that all together could want: cost and the two nodes."""
    star = one.star
    entry, leave, platoon = star.entry[member], star.leave[member], star.platoon[member]
    yield star.alone[member], 0, 0
    for i, j in itertools.combinations(range(len(star.node_at)), 2):
        cost = entry[i] + platoon[j] - platoon[i] + leave[j]
        if cost - star.gain[i:j].sum() >= star.alone[member]:
            continue
        low, high = star.node_at[i], star.node_at[j]
        key = member, i, j, table.stops, tuple(table.leave_s[low:high])
        if key not in known:
            known[key] = one.real(member, i, j, table) is not None
        if known[key]:
            yield cost, i, j


def needed(one):
    """Return how many stops and rests the master's driving takes if its driver is rested."""
    limits, drive = one.star.rules.limits, int(one.star.road.drive_s.sum())
    breaks = math.ceil(drive / limits.spell_s) - 1
    rests = math.ceil(drive / limits.long_day_s) - 1
    return max(breaks, rests), rests
