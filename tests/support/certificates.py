"""Fleet files for tiny fleets: from an instance, schedules, and shares drawn at random."""

from __future__ import annotations

import numpy as np
from exhaustive import Schedule, cheapest_alone, cost_of

from platoon_osm.costs.share import Share
from platoon_osm.fleets.instance import Instance
from platoon_osm.plans.fleet import FleetRecord
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.proof import Proof
from platoon_osm.plans.records import NetworkIdentity, PlannedTrip, SoloRoute, Stop, Stretch
from platoon_osm.plans.timetable import Timetable, VehicleTimes

__all__ = [
    "certificate_of",
    "drawn_shares",
    "empty_shares",
    "file_of",
    "file_with_plan",
    "slow_bound",
]


def routes_of(instance: Instance) -> list[list[int]]:
    """Return the lanes of each truck's way alone."""
    rows = zip(
        *(
            getattr(instance, name).tolist()
            for name in ("origin", "destination", "earliest", "latest", "kind")
        ),
        strict=True,
    )
    return [cheapest_alone(instance, row) for row in rows]


def empty_shares(instance: Instance) -> dict:
    """Return no shares at all: valid, and weak."""
    return {
        "lane_first": [0] * (instance.lanes + 1), "starts": [], "truck": [], "lane": [],
        "first_bucket": [], "first_share": [0], "share": [],
    }  # fmt: skip


def drawn_shares(instance: Instance, rng: np.random.Generator) -> dict:
    """Return valid shares drawn at random, of either regime, for most pairs."""
    lane_first, starts = [0], []
    told = {
        name: [] for name in ("truck", "lane", "first_bucket", "first_share", "share")
    }  # fmt: skip
    told["first_share"].append(0)
    listed = rng.random(instance.pairs) < 0.85
    rows: dict[int, list[int]] = {}
    for pair in np.flatnonzero(listed).tolist():
        rows.setdefault(int(instance.pair_lane[pair]), []).append(pair)
    at_bucket: dict[int, list[int]] = {}
    spans: dict[int, tuple[int, int]] = {}
    for lane in range(instance.lanes):
        own = rows.get(lane, [])
        if own:
            low = int(instance.opens[own].min()) - int(rng.integers(0, 2))
            high = int(instance.closes[own].max())
            cuts = sorted({low, *(int(x) for x in rng.integers(low, high + 2, 3))})
            for pair in own:
                opening = len(starts) + sum(c <= int(instance.opens[pair]) for c in cuts) - 1
                closing = len(starts) + sum(c <= int(instance.closes[pair]) for c in cuts) - 1
                spans[pair] = opening, closing
                for bucket in range(opening, closing + 1):
                    at_bucket.setdefault(bucket, []).append(pair)
            starts += cuts
        lane_first.append(len(starts))
    given: dict[tuple[int, int], int] = {}
    for bucket, own in at_bucket.items():
        lane = int(instance.pair_lane[own[0]])
        for pair, share in zip(own, _valid(instance, lane, len(own), rng), strict=True):
            given[pair, bucket] = share
    order = [pair for own in rows.values() for pair in own]
    for pair in (order[i] for i in rng.permutation(len(order))):
        opening, closing = spans[pair]
        told["truck"].append(int(instance.pair_truck[pair]))
        told["lane"].append(int(instance.pair_lane[pair]))
        told["first_bucket"].append(opening)
        told["share"] += [given[pair, bucket] for bucket in range(opening, closing + 1)]
        told["first_share"].append(len(told["share"]))
    return {"lane_first": lane_first, "starts": starts, **told}


def _valid(instance: Instance, lane: int, n: int, rng: np.random.Generator) -> list[int]:
    extra, leader = int(instance.extra[lane]), int(instance.leader_saves[lane])
    if n == 1:
        return [extra + leader]
    if leader and rng.random() < 0.4:
        x = int(rng.integers(0, leader + 1))
        found = [-x] * n
        found[int(rng.integers(n))] = extra + x
        return found
    most = min(n, instance.largest or n)
    weights = rng.random(n) ** 2
    total = np.sort(weights)[-most:].sum()
    return [int(extra * one / total) for one in weights]


def certificate_of(
    instance: Instance,
    schedules: tuple[Schedule, ...],
    shares: dict,
    bound: int = 0,
    rounds: int = 4,
) -> dict:
    """Return a certificate as plain JSON types."""
    first = np.concatenate([[0], np.cumsum([len(own) for own in schedules])]).tolist()
    return {
        "tick_s": 1.0, "grain": "0.01", "nodes": instance.nodes,
        **{
            name: getattr(instance, name).tolist()
            for name in (
                "tail", "head", "drive", "alone", "member", "extra", "lane_kind", "origin",
                "destination", "earliest", "latest_departure", "latest", "kind",
            )
        },
        "vehicles": [f"truck {k}" for k in range(instance.trucks)],
        "largest": instance.largest, "given": instance.given, "waiting": instance.waiting,
        "routes": routes_of(instance), "rounds": rounds, "shares": shares,
        "schedules": {
            "first": first,
            "lane": [lane for own in schedules for lane, _ in own],
            "depart": [at for own in schedules for _, at in own],
        },
        "lane_edges": {
            "first": list(range(instance.lanes + 1)), "edge": list(range(instance.lanes)),
        },
        "claims": {
            "alone": int(instance.alone_cost.sum()), "cost": cost_of(instance, schedules),
            "bound": bound,
        },
    }  # fmt: skip


def file_of(certificate: dict) -> dict:
    """Return a fleet file without a plan."""
    return {"format": "platoon-osm fleet", "version": 1, "plan": {}, "certificate": certificate}


def slow_bound(instance: Instance, shares: dict) -> int:
    """Return the sum of all trucks' cheapest schedules under shares, tick by tick."""
    row_of = {
        (k, lane): row
        for row, (k, lane) in enumerate(zip(shares["truck"], shares["lane"], strict=True))
    }
    return sum(_slow_truck(instance, shares, row_of, k) for k in range(instance.trucks))


def _slow_truck(instance: Instance, shares: dict, row_of: dict, k: int) -> int:
    far = 10**12
    goal, latest = int(instance.destination[k]), int(instance.latest[k])
    pairs = range(int(instance.first_pair[k]), int(instance.first_pair[k + 1]))
    # value[node]: least cost from there at the present tick, going back in time.
    after: list[list[int]] = []
    for tick in range(latest, int(instance.earliest[k]) - 1, -1):
        now = [far if not after else after[-1][v] + instance.waiting for v in range(instance.nodes)]
        now[goal] = 0
        for pair in pairs:
            lane = int(instance.pair_lane[pair])
            then = tick + int(instance.drive[lane])
            if instance.opens[pair] <= tick <= instance.closes[pair] and then <= latest:
                price = _price(instance, shares, row_of.get((k, lane)), lane, tick)
                onward = now if then == tick else after[latest - then]
                u = int(instance.tail[lane])
                now[u] = min(now[u], price + onward[int(instance.head[lane])])
        after.append(now)
    origin = int(instance.origin[k])
    starts = range(int(instance.earliest[k]), int(instance.latest_departure[k]) + 1)
    return min(after[latest - tick][origin] for tick in starts)


def _price(instance: Instance, shares: dict, row: int | None, lane: int, tick: int) -> int:
    alone, member = int(instance.alone[lane]), int(instance.member[lane])
    if row is None:
        return min(alone, member - int(instance.leader_saves[lane]))
    first, last = shares["lane_first"][lane], shares["lane_first"][lane + 1]
    bucket = max(b for b in range(first, last) if shares["starts"][b] <= tick)
    offset = bucket - shares["first_bucket"][row]
    return min(alone, member + shares["share"][shares["first_share"][row] + offset])


def file_with_plan(certificate: dict, instance: Instance, schedules: tuple[Schedule, ...]) -> dict:
    """Return a fleet file whose plan drives the lanes of an instance as edges of a network."""
    plan = _plan(certificate, instance, schedules).to_dict()
    return {**file_of(certificate), "plan": plan}


def _plan(certificate: dict, instance: Instance, schedules: tuple[Schedule, ...]) -> Plan:
    grain = float(certificate["grain"])
    stop = Stop(0, 0.0, 0.0, "somewhere")
    trips = tuple(
        PlannedTrip(
            name, stop, stop,
            SoloRoute(tuple(route), 1.0, 1.0, 0.0, float(instance.alone[route].sum()) * grain),
        )
        for name, route in zip(certificate["vehicles"], certificate["routes"], strict=True)
    )  # fmt: skip
    together: dict[tuple[int, int], list[int]] = {}
    for k, own in enumerate(schedules):
        for entry in own:
            together.setdefault(entry, []).append(k)
    stretches: list[Stretch] = []
    number: dict[tuple[int, int, int], int] = {}
    for (lane, at), trucks in together.items():
        for company in _parted(trucks, instance.largest):
            for k in company:
                number[lane, at, k] = len(stretches)
            shares = tuple(Share(1.0, 1.0, 0.0, 0.0) for _ in company)
            stretches.append(Stretch((lane,), company, 1.0, float(instance.drive[lane]), shares))
    ways = tuple(tuple(number[lane, at, k] for lane, at in own) for k, own in enumerate(schedules))
    times = tuple(
        VehicleTimes(
            certificate["vehicles"][k], float(own[0][1]),
            tuple((float(at), float(at + instance.drive[lane])) for lane, at in own),
            float(instance.earliest[k]), float(instance.latest_departure[k]),
            float(instance.latest[k]),
        )
        for k, own in enumerate(schedules)
    )  # fmt: skip
    alone, cost = int(instance.alone_cost.sum()), cost_of(instance, schedules)
    fleet = FleetRecord(
        saving=(alone - cost) * grain, bound=(alone - certificate["claims"]["bound"]) * grain,
        alone_cost=alone * grain, seconds=1.0, peak_mb=1.0,
        routes="given" if instance.given else "free", per_trip="many",
        max_platoon=instance.largest or None, seed=0, ended="rounds", rounds=1,
    )  # fmt: skip
    network = NetworkIdentity("drawn", "", "", "", "", instance.nodes, instance.lanes, "")
    return Plan(
        trips, tuple(stretches), ways, (), (), "D", "D", "system", "dijkstra", "euro", {}, network,
        Proof("heuristic", cost * grain, None), fleet=fleet,
        timetable=Timetable("2026-01-05T00:00:00", True, times),
    )  # fmt: skip


def _parted(trucks: list[int], largest: int) -> list[tuple[int, ...]]:
    """Return a company as platoons that are allowed."""
    if not largest or len(trucks) <= largest:
        return [tuple(trucks)]
    if largest == 2:
        return [tuple(trucks[at : at + 2]) for at in range(0, len(trucks), 2)]
    count = -(-len(trucks) // largest)
    return [tuple(trucks[at::count]) for at in range(count)]
