"""A day of trips drawn: by volume, far enough, by the hour, and read back as it was written."""

import re
from collections import Counter
from datetime import date

import numpy as np
import pytest
from bundled import italy as italy_map

from platoon_osm.cli import main
from platoon_osm.errors import PlatoonError
from platoon_osm.fleets.day.demand import demand_in, gravity_demand
from platoon_osm.fleets.day.draw import draw_trips
from platoon_osm.fleets.day.trip_file import write_trips
from platoon_osm.network.location import Place
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.scenario.trip_tables import read_trips
from platoon_osm.plans.trip import Trip


@pytest.fixture(scope="module")
def italy():
    return italy_map()


@pytest.fixture
def line():
    """Four nodes in a row, both ways, 60 km each; their ids are 11 to 14."""
    tail, head = [0, 1, 2, 1, 2, 3], [1, 2, 3, 0, 1, 2]
    net = RoadNetwork.from_edges(
        tail, head, [60_000.0] * 6, lon=[9.0, 9.7, 10.4, 11.1], lat=[45.0] * 4
    )
    return net.with_columns(node_id=[11, 12, 13, 14])


@pytest.fixture
def flows(tmp_path):
    path = tmp_path / "traffic.csv"
    path.write_text("origin,destination,volume\n11,13,300\n11,14,100\n12,13,9999\n11,99,50\n")
    return path


def test_ways_are_drawn_by_volume_and_far_enough(line, flows):
    trips = draw_trips(line, 2000, flows=flows, min_km=100, seed=3)
    ends = Counter((trip.origin.osmid, trip.destination.osmid) for trip in trips)
    assert set(ends) == {(11, 13), (11, 14)}  # 12 to 13 is near, 99 is nowhere
    # Three of four; five standard deviations of a binomial draw are 97.
    assert abs(ends[11, 13] - 1500) < 97
    demand = demand_in(flows, line)
    np.testing.assert_allclose(demand.length_m, [120e3, 180e3, 60e3])
    assert demand.left_out == pytest.approx(50 / 10449)


def test_places_are_ids_coordinates_or_names(italy, tmp_path):
    (tmp_path / "segments.csv").write_text(
        "source,target,position_x,position_y\n7,8,7.68,45.07\n8,7,14.27,40.85\n"
    )
    path = tmp_path / "traffic.csv"
    path.write_text("origin,destination,volume\n7,8,10\n Bologna,Roma,10\nNowhere at all,7,5\n")
    demand = demand_in(path, italy)
    assert demand.left_out == pytest.approx(0.2)
    named = [(demand.places[a], demand.places[b]) for a, b in zip(
        demand.origin, demand.destination, strict=True)]  # fmt: skip
    assert named == [((7.68, 45.07), (14.27, 40.85)), ("Bologna", "Roma")]
    assert demand.length_m[0] > demand.length_m[1] > 300e3


def test_an_id_that_a_far_node_has_by_chance_is_not_taken(line, flows):
    flows.with_name("segments.csv").write_text(
        "source,position_x,position_y\n11,10.39,45.0\n13,10.4,45.0\n14,11.1,45.0\n"
    )
    demand = demand_in(flows, line)
    # 11 stands near the third node, so its way to 13 is short, and to 14 one edge.
    assert demand.length_m.max() < 62e3


def test_hours_of_a_day(line, flows):
    def hours(day):
        trips = draw_trips(line, 4000, flows=flows, day=day)
        return np.array([trip.earliest_departure.hour for trip in trips])

    even = np.bincount(hours("uniform"), minlength=24)
    assert even.min() > 166 - 5 * 13
    assert even.max() < 166 + 5 * 13
    peaked = np.bincount(hours("peaked"), minlength=24)
    # Within an hour of 6: 68 % of a half, and a twelfth of a quarter.
    assert abs(peaked[5:7].sum() - 4000 * (0.5 * 0.6827 + 0.25 / 12)) < 160
    assert peaked[17:19].sum() > 3 * peaked[11:13].sum()


def test_towns_by_gravity(italy):
    demand = gravity_demand(italy)
    by_name = {
        (demand.places[a], demand.places[b]): (w, d)
        for a, b, w, d in zip(
            demand.origin, demand.destination, demand.weight, demand.length_m, strict=True
        )
    }
    # T_ij d_ij is the product of inhabitants, so it is a table of rank one.
    t = {pair: w * d for pair, (w, d) in by_name.items()}
    one = t["Roma", "Bologna"] * t["Milano", "Torino"]
    assert one == pytest.approx(t["Roma", "Torino"] * t["Milano", "Bologna"])
    trips = draw_trips(italy, 50, seed=1, on=date(2026, 7, 1), flexibility_min=10)
    assert [trip.vehicle for trip in trips[:2]] == ["truck 01", "truck 02"]
    leaves = [trip.earliest_departure for trip in trips]
    assert leaves == sorted(leaves)
    assert {at.date() for at in leaves} == {date(2026, 7, 1)}
    assert trips == draw_trips(italy, 50, seed=1, on=date(2026, 7, 1), flexibility_min=10)
    assert trips != draw_trips(italy, 50, seed=2, on=date(2026, 7, 1), flexibility_min=10)


def test_what_is_written_is_read_back(italy, line, flows, tmp_path):
    mixed = (
        Trip("a", "Roma", (9.123456789, 45.5)),
        Trip("b", Place(osmid=5, label="Yard"), Place("Bologna", label="Shed")),
    )
    for trips in (mixed, draw_trips(line, 9, flows=flows), draw_trips(italy, 9)):
        write_trips(trips, tmp_path / "trips.csv")
        assert tuple(read_trips(tmp_path / "trips.csv")) == trips
    with pytest.raises(PlatoonError, match="is a node of one network"):
        write_trips([Trip("a", 1, 2)], tmp_path / "trips.csv")


def test_the_command(tmp_path, capsys):
    out = tmp_path / "trips.csv"
    given = ["trips", "--network", "italy-motorways", "--number", "12", "--day", "peaked"]
    assert main([*given, "--date", "2026-05-04", "--flexibility", "20", "-o", str(out)]) == 0
    assert "12 trips on italy-motorways" in capsys.readouterr().out
    trips = read_trips(out)
    assert len(trips) == 12
    assert {trip.flexibility_min for trip in trips} == {20.0}
    assert main([*given, "--date", "4.5.", "-o", str(out)]) == 2
    assert "--date '4.5.': give a day such as 2026-03-02" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"number": 0}, "number is 0; give a whole number from 1"),
        ({"day": "sunny"}, "day 'sunny' is unknown; use uniform, peaked"),
        ({"min_km": 500}, "no way is 500 km long, the longest 180 km"),
        ({"flexibility_min": -1}, "flexibility_min is -1"),
        ({"seed": 0.5}, "seed is 0.5"),
        ({"on": "today"}, "on is 'today'; give a date"),
        ({"flows": 7}, "flows are int"),
    ],
)
def test_refused_in_one_line(line, flows, given, said):
    with pytest.raises(PlatoonError, match=re.escape(said)):
        draw_trips(line, **{"flows": flows, **given})


def test_a_map_without_towns_needs_flows(line, flows):
    with pytest.raises(PlatoonError, match="no two towns"):
        draw_trips(line)
    flows.write_text("origin,destination,volume\n1,2,3\n")
    with pytest.raises(PlatoonError, match="no flow has both of its ends"):
        draw_trips(line, flows=flows)
