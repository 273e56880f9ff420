"""Fleets on one line of roads, put together by hand: who is with whom on which road, and when."""

import random
from dataclasses import replace

import platoon_osm as po
from platoon_osm.costs.share import Share
from platoon_osm.plans.fleet import FleetRecord, Moment, Unserved
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.proof import Proof
from platoon_osm.plans.records import (
    NetworkIdentity,
    PlannedTrip,
    Platoon,
    SoloRoute,
    Stop,
    Stretch,
)
from platoon_osm.plans.stretches import linked
from platoon_osm.plans.timetable import Timetable, VehicleTimes

ROAD_M, DRIVE_S, LATER_S = 20_000.0, 900.0, 300.0
SAVED = 0.1


def line_net(roads, rename=str):
    """Roads that follow each other from west to east."""
    return po.RoadNetwork.from_edges(
        list(range(roads)), list(range(1, roads + 1)), [ROAD_M] * roads,
        lon=[9.0 + 0.25 * k for k in range(roads + 1)],
        lat=[45.0 + 0.05 * (k % 3) for k in range(roads + 1)],
        node_name=[rename(f"N{k}") for k in range(roads + 1)],
    )  # fmt: skip


def line_fleet(seed, trucks, roads, rename=str, unserved=2):
    """Trucks that drive parts of a line, drawn: on each road some are together.

    Each begins a road at a whole number of `LATER_S` after the hour of the road, so that one that
    goes on as late as it came does not stop. Returns the plan, its network and, for each company,
    (road, vehicles, start).
    """
    rng = random.Random(seed)
    net = line_net(roads, rename)
    ends = [sorted(rng.sample(range(roads + 1), 2)) for _ in range(trucks)]
    companies = []
    now = [0] * trucks
    for road in range(roads):
        here = [k for k in range(trucks) if ends[k][0] <= road < ends[k][1]]
        rng.shuffle(here)
        while here:
            size = min(len(here), rng.choice([1, 1, 2, 3]))
            own, here = tuple(here[:size]), here[size:]
            # Nobody catches up what it was late: it goes on at once or later.
            late = max(now[k] for k in own) + rng.choice([0, 0, 1])
            for k in own:
                now[k] = late
            companies.append((road, own, road * DRIVE_S + late * LATER_S))
    stretches = tuple(
        Stretch(
            (road,), own, ROAD_M, DRIVE_S,
            tuple(Share(20.0 * (1 - SAVED * (len(own) > 1 and place > 0)), 20.0, 6.0, 6.0)
                  for place in range(len(own))),
        )
        for road, own, _ in companies
    )  # fmt: skip
    ways = tuple(
        tuple(k for k, (_, own, _) in enumerate(companies) if truck in own)
        for truck in range(trucks)
    )

    def stop(node):
        return Stop(node, float(net.lon[node]), float(net.lat[node]), net.place_name(node))

    trips = tuple(
        PlannedTrip(
            rename(f"T{k}"), stop(a), stop(b),
            SoloRoute(tuple(range(a, b)), ROAD_M * (b - a), DRIVE_S * (b - a), 6.0 * (b - a),
                      20.0 * (b - a)),
        )
        for k, (a, b) in enumerate(ends)
    )  # fmt: skip
    days = tuple(
        VehicleTimes(trip.vehicle, companies[way[0]][2],
                     tuple((companies[k][2], companies[k][2] + DRIVE_S) for k in way))
        for trip, way in zip(trips, ways, strict=True)
    )  # fmt: skip
    groups = linked([own for _, own, _ in companies], trucks)
    saving = sum(share.gain for one in stretches for share in one.shares)
    alone = sum(trip.alone.cost for trip in trips)
    source = net.source
    plan = Plan(
        trips, stretches, ways,
        tuple(Platoon(group, None, "D") for group in groups if len(group) > 1),
        (), "D", "fleet", "system", "fleet", "EUR", {},
        NetworkIdentity(source.name, source.sha256, source.extracted, source.licence,
                        source.attribution, net.n, net.m, net.identity()),
        Proof("bound", alone - saving, alone - 1.2 * saving),
        timetable=Timetable("2026-03-02T06:00:00", True, days),
    )  # fmt: skip
    history = tuple(
        Moment(t, saving * (1 - 1 / (t + 2)), saving * (1.2 + 2 / (t + 1))) for t in range(9)
    )
    record = FleetRecord(
        saving, 1.2 * saving, alone, 9.0, 100.0, "given", "many", 3, 1, "time", 8, history,
        tuple(Unserved(rename(f"U{k}"), rename("no route")) for k in range(unserved)),
        ("waiting is free", "no platoon has more than 3 vehicles", rename("another")),
    )  # fmt: skip
    return replace(plan, fleet=record), net, companies
