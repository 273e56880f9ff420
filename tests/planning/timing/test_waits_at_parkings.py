"""Who waits for company does so at the last truck parking before it, and nobody else notices."""

import random
from dataclasses import replace
from datetime import datetime, timedelta
from itertools import pairwise
from zoneinfo import ZoneInfo

import numpy as np
import pytest
from bundled import italy
from roads_with_hours import in_country

import platoon_osm as po
from platoon_osm.network.columns import POINT_KINDS
from platoon_osm.network.restrictions import encode
from platoon_osm.network.road_network import NamedPoints, RoadNetwork
from platoon_osm.network.texts import TextTable
from platoon_osm.planning import joint
from platoon_osm.plans.standing import standing, waited_s
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE
from platoon_osm.vehicles.stop_offers import offers_to

DAY = datetime(2026, 3, 3, 6, tzinfo=ZoneInfo("Europe/Rome"))
NEAR_M = 50_000.0


@pytest.fixture
def both(monkeypatch):
    """Return a function that plans with waits where they arise, and with waits moved."""

    def plans(*asked, **options):
        moved = po.plan_joint(*asked, **options)
        with monkeypatch.context() as patch:
            patch.setattr(joint, "with_waits_at_parkings", lambda plan, *_: plan)
            return po.plan_joint(*asked, **options), moved

    return plans


def crossing(stops=(), hours=None):
    """Return a road of 240 km east and one of 120 km that meets it after 120.

    Stops lie beside the latter: km along it, kind, name, tags.
    """
    lon, lat = [0.0, 1.5, 3.0, 1.5, 1.5], [45.0, 45.0, 45.0, 44.0, 44.5]
    tail, head = [0, 1, 3, 4, 1], [1, 2, 4, 1, 4]
    net = RoadNetwork.from_edges(
        tail, head, lon=lon, lat=lat, length_m=[120_000.0, 120_000.0, 60_000.0, 60_000.0, 60_000.0],
        speed_mps=80 / 3.6,
    )  # fmt: skip
    edge = int(((net.tail == 4) & (net.head == 1)).argmax())
    net = in_country(net, "", None if hours is None else {edge: {"hgv:conditional": hours}})
    texts = [*net.texts]
    points = NamedPoints(
        np.full(len(stops), 1.5005),
        np.array([44.0 + km / 120 for km, *_ in stops], float),
        np.array([POINT_KINDS.index(kind) for _, kind, *_ in stops], np.uint8),
        np.array([len(texts) + 2 * k for k in range(len(stops))], np.int32),
        np.zeros(len(stops), np.int64),
        tags=np.array([len(texts) + 2 * k + 1 for k in range(len(stops))], np.int32),
    )
    texts += [text for *_, name, tags in stops for text in (name, encode([tags]))]
    return replace(net, texts=TextTable.from_strings(texts), points=points, _file=None)


def wait_of_second(net, minutes=30):
    """The second reaches the crossing by road in 90 min and has to leave that much earlier."""
    early = DAY - timedelta(minutes=minutes)
    trips = [po.Trip("A", 0, 2, DAY, DAY), po.Trip("B", 3, 2, early, early)]
    plan = po.plan_joint(net, po.paper_weights(net), trips, "C", master="A")
    assert plan.vehicles[1].merge is not None
    (wait,) = standing(plan.timetable.vehicles[1])
    assert wait.duration_s == pytest.approx(minutes * 60)
    return plan, wait


AREA = {"highway": "services"}
PARKING = {"amenity": "parking", "hgv": "yes"}


@pytest.mark.parametrize(
    ("stops", "name"),
    [
        ([], None),
        ([(108, "services", "Near", AREA)], "Near"),
        ([(80, "services", "Far", AREA), (108, "services", "Near", AREA)], "Near"),
        ([(80, "services", "Far", AREA), (108, "rest_area", "Cars", {"hgv": "no"} | AREA)],
         "Far"),
        ([(108, "rest_area", "Low", {"highway": "rest_area", "maxheight": "3"})], None),
        ([(108, "fuel", "Pump", {"amenity": "fuel", "hgv": "yes"})], None),
        ([(75, "services", "Other road section", AREA)], "Other road section"),
        # 52 km before the crossing.
        ([(68, "services", "Too far back", AREA)], None),
        ([(100, "parking", "Short stay", PARKING | {"maxstay": "15 minutes"})], None),
        ([(90, "parking", "Long stay", PARKING | {"maxstay": "2 hours"}),
          (100, "parking", "Short stay", PARKING | {"maxstay": "15 minutes"})],
         "Long stay"),
    ],
)  # fmt: skip
def test_the_last_parking_that_is_near_is_taken(stops, name):
    plan, wait = wait_of_second(crossing(stops))
    assert (wait.place.name if wait.place else None) == name
    told = next(line for line in plan.summary().splitlines() if line.startswith("B merges"))
    assert f"after waiting 30 min{f' at {name}' if name else ')'}" in told
    if name is not None:
        km = next(km for km, _, own, _ in stops if own == name)
        legs = plan.timetable.vehicles[1].legs
        assert legs[0][1] - legs[0][0] == pytest.approx(km * 1000 / 80 * 3.6, rel=1e-3)
        assert wait.start_s == legs[0][1]
        assert wait.end_s == pytest.approx(legs[1][0])


def test_a_road_that_closes_meanwhile_is_not_driven_later():
    stops = [(66, "services", "Early", AREA), (80, "services", "Stop", AREA)]
    # It passes from 60 to 120 km between 06:15 and 07:00; half an hour later the road is closed.
    plan, wait = wait_of_second(crossing(stops, "no @ (07:10-09:00)"))
    assert wait.place is None
    plan, wait = wait_of_second(crossing(stops, "no @ (07:40-09:00)"))
    assert wait.place.name == "Stop"
    assert not any("keeps to" in one for one in plan.remarks)


def met_at(plan):
    """Return when each vehicle begins and ends to drive with whom."""
    found = []
    for index, way in enumerate(plan.ways):
        legs = plan.timetable.vehicles[index].legs
        for (number, span), (last, end) in pairwise(zip(way, legs, strict=True)):
            before, after = plan.stretches[number].company, plan.stretches[last].company
            if before != after:
                found.append(
                    (
                        index,
                        before,
                        after,
                        round(span[1], 3) if len(before) > 1 else 0,
                        round(end[0], 3),
                    )
                )
    return found  # fmt: skip


def drawn(rng, net):
    """Return trips to the south of Italy, most of which have to leave by some time."""
    north = ["Torino", "Milano", "Genova", "Brescia", "Verona", "Venezia", "Bologna"]
    trips = [po.Trip("V0", rng.choice(north[:2]), rng.choice(["Napoli", "Bari"]), DAY, DAY)]
    for k in range(1, rng.randint(2, 4)):
        leaves = DAY + timedelta(minutes=rng.randint(-60, 150))
        last = rng.choice([leaves, leaves + timedelta(minutes=20), None])
        there = rng.choice(["Firenze", "Roma", "Napoli", "Bari", "Pescara"])
        trips.append(po.Trip(f"V{k}", rng.choice(north), there, leaves, last))
    return net, po.paper_weights(net), trips, rng.choice(["C", "best"])


def test_meetings_costs_and_times_stay_and_no_parking_is_passed_before_a_wait(both):
    rng = random.Random(5)
    net = italy()
    moved_waits = plain_waits = 0
    for number in range(12):
        before, after = both(*drawn(rng, net), rules="eu561" if number == 0 else "none")
        assert after.proof.cost == pytest.approx(before.proof.cost)
        assert met_at(after) == met_at(before)
        assert after.remarks == before.remarks
        for index, (old, new) in enumerate(zip(before.times, after.times, strict=True)):
            assert (new.departure_s, new.arrival_s) == (old.departure_s, old.arrival_s)
            stood = [sum(one.duration_s for one in standing(times)) for times in (old, new)]
            assert stood[0] == pytest.approx(stood[1], abs=0.01)
            assert waited_s(new) <= waited_s(old) + 0.01
            moved_waits += sum(one.purposes == ("company",) for one in new.pauses)
            for wait in standing(new):
                if wait.place is None and wait.before:
                    plain_waits += 1
                    assert not passed_before(after, net, index, wait.before)
        assert po.Plan.from_dict(after.to_dict()) == after
    assert moved_waits >= 3
    assert plain_waits >= 1


def passed_before(plan, net, index, leg):
    """Return the parkings that a vehicle passes shortly before a leg, since it stood or met."""
    way, times = plan.ways[index], plan.times[index]
    company = plan.stretches[way[leg - 1]].company
    found, back_m = [], 0.0
    for k in range(leg - 1, -1, -1):
        stretch = plan.stretches[way[k]]
        if stretch.company != company:
            break
        if (
            len({plan.ways[other][plan.ways[other].index(way[k]) + 1 :][:1] for other in company})
            > 1
        ):
            return []  # they part here
        for passed in po.stops_along(net, stretch.edges, stretch.span):
            near = back_m + stretch.length_m - passed.at_m < NEAR_M - 1
            if near and "parking" in offers_to(passed.stop, DEFAULT_VEHICLE):
                found.append(passed.stop.name)
        back_m += stretch.length_m
        if times.waits[k]:
            break
    return found
