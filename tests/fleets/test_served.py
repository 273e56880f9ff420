"""Tables of which some rows cannot be read or planned: the others are, and these are told."""

import numpy as np
import pytest

from platoon_osm.costs.money.fuel_costs import FuelCosts
from platoon_osm.errors import PlatoonError
from platoon_osm.fleets.served import served
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.asked import Asked
from platoon_osm.planning.problem import Problem
from platoon_osm.planning.scenario.trip_tables import read_fleet_table, read_trips
from platoon_osm.plans.trip import Trip

GOOD = "a,Alba,Bra,2026-03-02 06:00,30,{}\n"
HEADER = "vehicle,origin,destination,earliest_departure,flexibility_min,carrier\n"
BAD = {
    "no time": "b,Alba,Bra,soon,30,\n",
    "no minutes": "c,Alba,Bra,2026-03-02 06:00,thirty,\n",
    "no place": "d,,Bra,2026-03-02 06:00,30,\n",
    "no vehicle": ",Alba,Bra,2026-03-02 06:00,30,\n",
    "twice": "a,Alba,Bra,2026-03-02 06:00,30,\n",
    "a zone": "z,Alba,Bra,2026-03-02T06:00+01:00,30,\n",
    "too many": "e,Alba,Bra,2026-03-02 06:00,30,,more\n",
}


def test_a_table_in_part(tmp_path):
    path = tmp_path / "trips.csv"
    path.write_text(HEADER + GOOD.format("North") + "".join(BAD.values()) + "y,Alba,Bra,,,\n")
    table = read_fleet_table(path)
    assert [trip.vehicle for trip in table.trips] == ["a", "y"]
    assert table.carriers == {"a": "North"}
    told = {one.vehicle: one.reason for one in table.unserved}
    assert list(told) == ["b", "c", "d", "trips.csv line 6", "a", "z", "e"]
    for vehicle, words in (
        ("b", "line 3: earliest_departure = soon must be a day and a time"),
        ("c", "flexibility_min"), ("d", "origin is empty"),
        ("trips.csv line 6", "vehicle is empty"),
        ("a", "has a trip already (trips.csv line 2)"), ("z", "zone"),
        ("e", "has 7 cells, the header 6"),
    ):  # fmt: skip
        assert words in told[vehicle], vehicle


@pytest.mark.parametrize("kind", list(BAD))
def test_what_is_listed_is_what_a_plan_refuses(tmp_path, kind):
    path = tmp_path / "trips.csv"
    path.write_text(HEADER.replace(",carrier", ",profile") + GOOD.format("") + BAD[kind])
    (one,) = read_fleet_table(path).unserved
    with pytest.raises(PlatoonError) as caught:
        read_trips(path)
    # A plan tells unlike clocks of the file, for none of its rows is wrong by itself.
    assert str(caught.value).removeprefix(f"{path}: ") == one.reason


def test_carriers_are_no_matter_of_a_single_plan(tmp_path):
    path = tmp_path / "trips.csv"
    path.write_text(HEADER + GOOD.format("North"))
    with pytest.raises(PlatoonError, match="carrier counts in fleets alone"):
        read_trips(path)


def network(rng, n=9):
    """Some nodes of which not all lead to all."""
    tail, head = np.nonzero((rng.random((n, n)) < 0.16) & ~np.eye(n, dtype=bool))
    if len(tail) == 0:
        tail, head = np.array([0]), np.array([1])
    length = rng.integers(1_000, 50_000, len(tail)).astype(float)
    lon, lat = 9 + rng.random(n), 45 + rng.random(n)
    return RoadNetwork.from_edges(tail, head, length, lon=lon, lat=lat)


@pytest.mark.parametrize("seed", range(12))
def test_those_served_are_those_that_can_be_planned_alone(seed):
    rng = np.random.default_rng(seed)
    net = network(rng)
    trips = [
        Trip(f"t{k}", int(rng.integers(0, net.n + 1)), "nowhere" if k == 3 else int(b))
        for k, b in enumerate(rng.integers(0, net.n, 12))
    ]
    costs = FuelCosts()

    def alone(trip):
        try:
            Asked.of(Problem(net, (trip,), costs))
        except PlatoonError as error:
            return str(error)
        return None

    reasons = {trip.vehicle: alone(trip) for trip in trips}
    if all(reasons.values()):
        with pytest.raises(PlatoonError):
            served(Problem(net, tuple(trips), costs))
        return
    asked, unserved = served(Problem(net, tuple(trips), costs))
    kept = [trip.vehicle for trip in asked.question.problem.trips]
    assert kept == [trip.vehicle for trip in trips if reasons[trip.vehicle] is None]
    assert [one.vehicle for one in unserved] == [name for name, why in reasons.items() if why]
    for one in unserved:
        assert reasons[one.vehicle].endswith(one.reason)
        assert not one.reason.startswith("trip ")
    whole = Asked.of(Problem(net, tuple(t for t in trips if t.vehicle in kept), costs))
    assert [(end.origin, end.destination) for end in asked.question.ends] == [
        (end.origin, end.destination) for end in whole.question.ends
    ]
