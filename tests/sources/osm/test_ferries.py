"""Ferries: which are taken, how long they take, and that they are no roads."""

from math import isnan

import numpy as np
import pytest
from osm_files import write

from platoon_osm.errors import MapDataError
from platoon_osm.network.restrictions import decode
from platoon_osm.network.road_network import ROAD_CLASSES
from platoon_osm.sources.load import load_network
from platoon_osm.sources.osm.ferries import crossing_mps, duration_s, read_ferry
from platoon_osm.sources.truck import TruckRules

FERRY = ROAD_CLASSES.index("ferry")
ROAD = {"highway": "primary", "maxspeed": "60"}
CARRIES = {"route": "ferry", "hgv": "yes", "name": "Strait"}
# Two roads of 8 km, and 8 km of water between them.
NODES = {node: (15.0 + node / 10, 38.0, {}) for node in (1, 2, 3, 4)}


def made(folder, **tags):
    ways = {
        1: ([1, 2], ROAD),
        2: ([2, 3], {key.replace("__", ":"): value for key, value in tags.items()}),
        3: ([3, 4], ROAD),
    }
    return write(folder, NODES, ways)


def loaded(folder, **tags):
    return load_network(made(folder, **tags), ("primary",))


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("00:20", 1200), ("20", 1200), ("1:05", 3900), ("26:00", 93_600), ("00:20:30", 1230),
        ("PT20M", 1200), ("pt1h20m", 4800), ("P1DT2H", 93_600), ("PT45S", 45), (" 00:20 ", 1200),
    ],
)  # fmt: skip
def test_durations_that_are_read(text, seconds):
    assert duration_s(text) == seconds


@pytest.mark.parametrize("text", ["", "0", "00:00", "P", "PT", "20 min", "1:75", "-5", "²", "x"])
def test_durations_that_are_none(text):
    assert isnan(duration_s(text))


@pytest.mark.parametrize(("duration", "hours"), [("00:30", 0.5), ("PT2H", 2.0)])
def test_a_crossing_takes_its_duration_both_ways(tmp_path, duration, hours):
    net = loaded(tmp_path, **CARRIES, duration=duration)
    ferry = net.road_class == FERRY
    assert ferry.sum() == 2
    assert (net.length_m / net.speed_mps)[ferry] == pytest.approx(hours * 3600)
    assert net.connected_share() == 1.0
    assert net.report()["ferries taken"] == 1


def test_without_a_duration_the_speed_is_a_default_and_counted(tmp_path):
    net = loaded(tmp_path, **CARRIES)
    assert np.unique(net.speed_mps[net.road_class == FERRY] * 3.6) == pytest.approx([15.0])
    assert net.report()["speed of a ferry defaulted (no duration that can be read)"] == 1


@pytest.mark.parametrize(
    ("tags", "taken"),
    [
        ({"hgv": "yes"}, True), ({"motor_vehicle": "yes"}, True), ({"hgv": "designated"}, True),
        ({}, False), ({"foot": "yes"}, False), ({"hgv": "no", "motor_vehicle": "yes"}, True),
        ({"motor_vehicle": "no"}, False), ({"hgv": "no"}, False), ({"motorcar": "yes"}, False),
    ],
)  # fmt: skip
def test_only_ferries_that_carry_trucks_are_taken(tmp_path, tags, taken):
    net = loaded(tmp_path, route="ferry", duration="00:20", **tags)
    assert (net.road_class == FERRY).any() == taken
    dropped = [name for name in net.load_report.counts if "dropped: closed to all by" in name]
    assert len(dropped) == (0 if taken else 1)


def test_whom_a_ferry_does_not_carry_is_kept_like_a_road_s_restriction(tmp_path):
    net = loaded(tmp_path, route="ferry", motor_vehicle="yes", hgv="no", maxheight="3.2")
    (texts,) = {net.texts[code] for code in net.restriction[net.road_class == FERRY]}
    (layer,) = decode(texts)
    assert (layer["hgv"], layer["maxheight"]) == ("no", "3.2")


def test_one_way_ferries_and_roads_that_bear_a_route(tmp_path):
    net = loaded(tmp_path, **CARRIES, oneway="yes", duration="00:20")
    assert (net.road_class == FERRY).sum() == 1
    # A pier that is a road is a road, whatever route leads over it.
    (tmp_path / "pier").mkdir()
    pier = loaded(tmp_path / "pier", **CARRIES, **ROAD)
    assert not (pier.road_class == FERRY).any()
    assert pier.speed_mps * 3.6 == pytest.approx(60)


def test_a_slip_in_a_duration_makes_no_ferry_fly():
    assert crossing_mps(100e3, 60) * 3.6 == pytest.approx(80)
    assert crossing_mps(100, 86_400) * 3.6 == pytest.approx(1)
    assert read_ferry({"route": "ferry", "hgv": "yes"}, TruckRules()).toll is False


def test_no_trip_starts_on_the_water(tmp_path):
    net = loaded(tmp_path, **CARRIES, duration="00:20")
    place = net.locate((15.25 - 0.03, 38.0), "origin")
    assert net.lon[place.node] == pytest.approx(15.2)


def test_no_connector_is_inferred_between_a_bridge_and_the_ferry_below(tmp_path):
    nodes = {**NODES, 5: (15.25, 37.9, {}), 6: (15.25, 38.1, {})}
    ways = {
        1: ([1, 2], ROAD), 2: ([2, 3], {**CARRIES, "duration": "00:20"}), 3: ([3, 4], ROAD),
        4: ([5, 6], ROAD),
    }  # fmt: skip
    path = write(tmp_path, nodes, ways)
    assert not load_network(path, ("primary",), infer_links=True).inferred.any()
    ways[2] = ([2, 3], ROAD)
    bridge = write(tmp_path, nodes, ways, name="bridge")
    assert load_network(bridge, ("primary",), infer_links=True).inferred.any()


def test_a_ferry_alone_is_no_road(tmp_path):
    path = write(tmp_path, NODES, {1: ([1, 2], CARRIES)})
    with pytest.raises(
        MapDataError, match=r"no road of class primary for goods vehicles .it has no such"
    ):
        load_network(path, ("primary",))
