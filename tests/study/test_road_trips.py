"""The same study on a real network, with trips drawn by distance and by flows."""

import numpy as np
import pytest
from bundled import italy as italy_map

from platoon_osm.cli import main
from platoon_osm.errors import MapDataError, ScenarioError
from platoon_osm.network.geodesy import distance_m
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.study.monte_carlo import run_study
from platoon_osm.study.road_trips import RoadTrips, read_flows
from platoon_osm.study.settings import Study


@pytest.fixture(scope="module")
def italy():
    return italy_map()


@pytest.fixture
def flows_file(tmp_path):
    # Torino, Milano, Bologna, Napoli, as the ETISplus files name places.
    (tmp_path / "segments.csv").write_text(
        "source,target,position_x,position_y,capacity,travel_speed,segment_length\n"
        "1,2,7.68,45.07,1,1,1\n2,3,9.19,45.46,1,1,1\n3,4,11.34,44.49,1,1,1\n4,1,14.27,40.85,1,1,1\n"
    )
    path = tmp_path / "traffic.csv"
    path.write_text("origin,destination,volume\n1,4,1000\n2,4,10\n1,2,99999\n9,1,5\n3,3,7\n")
    return path


def test_trips_by_distance(italy):
    trips = RoadTrips(italy, vehicles=6, spawn_diameter_m=3e5, min_route_m=3e5)
    draw = trips.draw(np.random.default_rng(0))
    away = ReferenceEngine(italy, italy.length_m).distances(draw.origins)
    assert (away[np.arange(6), draw.destinations] >= 3e5).all()
    centre = draw.origins[0]
    circle = distance_m(
        italy.lon[draw.origins], italy.lat[draw.origins], italy.lon[centre], italy.lat[centre]
    )
    assert (circle <= 1.5e5).all()


def test_trips_by_flows_are_drawn_by_volume(italy, flows_file):
    flows = read_flows(flows_file, italy)
    assert len(flows.volume) == 3  # of unknown places, and of places to themselves, none
    trips = RoadTrips(italy, vehicles=3, spawn_diameter_m=1e3, min_route_m=3e5, flows=flows)
    draws = [trips.draw(np.random.default_rng(seed)) for seed in range(20)]
    # Torino to Milano is too near, so nearly all go from Torino to Napoli.
    firsts = [int(draw.origins[0]) for draw in draws]
    assert firsts.count(int(flows.origin[0])) > 15
    assert all((draw.destinations == flows.destination[0]).all() for draw in draws)
    assert sum(draw.impossible for draw in draws) > 0


def test_flows_that_a_spreadsheet_saved(italy, flows_file):
    plain = read_flows(flows_file, italy)
    for file in (flows_file, flows_file.with_name("segments.csv")):
        file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes().replace(b"\n", b"\r\n"))
    np.testing.assert_array_equal(read_flows(flows_file, italy).volume, plain.volume)


def test_flows_of_places_far_away_are_left_out_and_counted(italy, flows_file):
    segments = flows_file.with_name("segments.csv")
    segments.write_text(segments.read_text() + "5,1,13.40,52.52,1,1,1\n6,5,8.68,50.11,1,1,1\n")
    flows_file.write_text(flows_file.read_text() + "5,1,300\n4,6,40\n6,5,2\n")
    flows = read_flows(flows_file, italy)
    assert len(flows.volume) == 3
    assert flows.left_out == 300 + 40 + 2 + 5 + 7
    trips = RoadTrips(italy, flows=flows)
    assert trips.to_dict()["flow_volume_left_out"] == 354
    flows_file.write_text("origin,destination,volume\n5,6,300\n")
    with pytest.raises(MapDataError, match="within 50 km of italy-motorways; give flows of its"):
        read_flows(flows_file, italy)


def test_places_off_the_globe_are_refused(italy, flows_file):
    segments = flows_file.with_name("segments.csv")
    segments.write_text(segments.read_text() + "5,1,1340,52.52,1,1,1\n")
    with pytest.raises(MapDataError, match=r"segments.csv: line 6: 1340, 52.52 is no longitude"):
        read_flows(flows_file, italy)


def test_the_study_runs_on_it_and_repeats(italy):
    study = Study(
        network=RoadTrips(italy, vehicles=4, min_route_m=3e5), runs=2, tau=(0.0, 1.0), xi=(0.18,)
    )
    one, two = run_study(study, 1), run_study(study, 1)
    assert (one.joint_cost == two.joint_cost).all()
    assert study.to_dict()["network"]["identity"] == italy.identity()


def test_the_command_on_a_real_network(tmp_path, flows_file, capsys):
    status = main([
        "study", "--network", "italy-motorways", "--flows", str(flows_file), "--runs", "2",
        "--vehicles", "3", "--grid", "2", "--method", "dijkstra", "--min-route-km", "300",
        "--workers", "1", "-o", str(tmp_path / "out"),
    ])  # fmt: skip
    assert status == 0
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "italy-motorways, 200 km, by flows" in page
    assert "Roads: map: platoon_osm, compiled by hand from public facts, MIT." in page
    assert "report.html" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("origin,volume\n1,2\n", "destination"),
        ("origin,destination,volume\n1,4,many\n", "many"),
        ("origin,destination,volume\n1,4,-3\n", "below 0"),
        ("origin,destination,volume\n8,9,3\n", "no flow"),
        ("origin,destination,volume\n1,4,1000\n2,4", "line 3 has another number of fields"),
        ("origin,destination,volume\n1,4,1000,5\n", "line 2 has another number of fields"),
        ("", "no column"),
    ],
)
def test_bad_flows_are_refused_in_one_line(italy, flows_file, text, word):
    flows_file.write_text(text)
    with pytest.raises(MapDataError, match=word) as caught:
        read_flows(flows_file, italy)
    assert "\n" not in str(caught.value)


def test_flows_without_their_places_are_refused(italy, flows_file):
    flows_file.with_name("segments.csv").unlink()
    with pytest.raises(MapDataError, match="no such file"):
        read_flows(flows_file, italy)


@pytest.mark.parametrize(
    "options",
    [{"vehicles": 1}, {"min_route_m": float("nan")}, {"spawn_diameter_m": -1.0},
     {"max_redraws": -1}],
)  # fmt: skip
def test_bad_parameters_are_refused(italy, options):
    with pytest.raises(ScenarioError):
        RoadTrips(italy, **options)


def test_routes_that_no_trip_reaches_are_refused(italy):
    trips = RoadTrips(italy, min_route_m=9e6, max_redraws=2)
    with pytest.raises(ScenarioError, match="none of 3 draws"):
        trips.draw(np.random.default_rng(0))
