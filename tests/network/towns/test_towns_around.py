"""Towns around a network: which is nearest, which a name means, and when nobody looks."""

import subprocess
import sys

import numpy as np
import osmnx
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import small_italy

import platoon_osm as po
from platoon_osm.errors import NetworkError
from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.nearest_point import NearestPoint
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.saved.store import open_network
from platoon_osm.network.towns.surroundings import FARTHEST_TOWN_M, GEONAMES_CREDIT, TownsAround
from platoon_osm.network.towns.table import bundled_towns

LON, LAT = st.floats(-180, 180), st.floats(-89.9, 89.9)


def road(*places, **columns):
    """Make a two-way road through some places."""
    n = len(places)
    ends = [(k, k + 1) for k in range(n - 1)] + [(k + 1, k) for k in range(n - 1)]
    lon, lat = zip(*places, strict=True)
    return RoadNetwork.from_edges(
        [a for a, _ in ends], [b for _, b in ends], lon=lon, lat=lat,
        ref=["A 1"] * len(ends), **columns,
    )  # fmt: skip


PO = road((9.0, 45.3), (9.3, 45.3), (10.0, 45.4), (10.9, 45.4))
OHIO = road((-84.5, 39.1), (-83.8, 39.9), (-83.0, 40.0))
ILLINOIS = road((-89.6, 39.8), (-88.2, 40.1), (-84.2, 39.8), (-82.9, 40.0))


def refused(net, place, *said):
    with pytest.raises(NetworkError) as caught:
        net.locate(place)
    message = str(caught.value)
    assert "\n" not in message
    for part in said:
        assert part in message, message


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.tuples(LON, LAT), max_size=30), LON, LAT, st.sampled_from([1e4, 5e4, 1e6, 3e7])
)  # fmt: skip
def test_the_nearest_of_many_points_is_that_of_brute_force(points, lon, lat, reach):
    lons, lats = (np.array([point[k] for point in points], float) for k in (0, 1))
    away = [float(distance_m(a, b, lon, lat)) for a, b in points]
    found = NearestPoint(lons, lats, reach).to(lon, lat)
    if not away or min(away) > reach:
        assert found is None
    else:
        assert found == away.index(min(away))


@settings(max_examples=60, deadline=None)
@given(st.floats(-170, 170), st.floats(-60, 70), st.floats(0, 3), st.floats(0, 3))
def test_the_nearest_town_is_that_of_the_whole_table(lon, lat, east, north):
    net = road((lon, lat), (min(lon + east, 180.0), lat + north))
    table, around = bundled_towns(), net.attached(TownsAround)
    for node in (0, 1):
        at = float(net.lon[node]), float(net.lat[node])
        away = distance_m(table.lon, table.lat, *at)
        town = around.nearest(*at)
        if away.min() > FARTHEST_TOWN_M:
            assert town is None
        else:
            assert (town.name, town.source) == (table.names()[int(away.argmin())], "GeoNames")


@pytest.mark.parametrize("edge", [179.9, -179.9])
def test_beyond_the_date_line_there_are_towns_too(edge):
    # Labasa and Savusavu on Fiji lie near it; the strip of a network there reaches round the globe.
    table = bundled_towns()
    net = road((edge, -16.5), (edge - 0.05 * np.sign(edge), -16.6))
    away = distance_m(table.lon, table.lat, net.lon[0], net.lat[0])
    town = net.attached(TownsAround).nearest(float(net.lon[0]), float(net.lat[0]))
    assert (town is None) == bool(away.min() > FARTHEST_TOWN_M)


@pytest.mark.parametrize(
    "text",
    ["Milan", "Milano", "Mailand", "milano", "MILÁN", "Милан", "Milan, Italy", "Milano (Italy)",
     "Mailand, IT", "Milano, ITA", "  Milão "],
)  # fmt: skip
def test_one_town_of_many_names(text):
    found = PO.locate(text)
    assert (found.name, found.from_geonames) == ("Milan", True)
    assert (found.lon, found.lat) == (pytest.approx(9.19, abs=0.02), pytest.approx(45.46, abs=0.02))
    own = " ".join(text.split())
    assert found.note == f"{own!r} is taken for Milan, Italy (45.464 N 9.190 E), from GeoNames"
    assert found.candidates


def test_towns_of_one_name_are_listed_with_their_regions():
    refused(
        ILLINOIS, "Springfield", "is ambiguous", "Springfield, Illinois, United States (39.802 N",
        "Springfield, Ohio, United States", "add region or country",
    )  # fmt: skip
    assert ILLINOIS.locate("Springfield, Illinois").lon == pytest.approx(-89.64, abs=0.01)
    assert ILLINOIS.locate("Springfield, OH").lon == pytest.approx(-83.81, abs=0.01)
    assert ILLINOIS.locate("springfield (ohio)").lon == pytest.approx(-83.81, abs=0.01)
    assert ILLINOIS.locate("Springfield, OH, USA").lon == pytest.approx(-83.81, abs=0.01)
    assert OHIO.locate("Springfield").lon == pytest.approx(-83.81, abs=0.01)
    refused(OHIO, "Springfield, Texas", "no such town there, but Springfield, Ohio")


def test_brackets_that_belong_to_a_town():
    net = road((8.6, 50.1), (11.0, 51.0), (14.5, 52.3))
    assert net.locate("Frankfurt (Oder)").lon == pytest.approx(14.55, abs=0.01)
    assert net.locate("Frankfurt am Main").lon == pytest.approx(8.68, abs=0.01)
    refused(net, "Frankfurt", "ambiguous", "Frankfurt (Oder), Germany", "Frankfurt am Main, Ger")
    assert road((8.6, 50.1), (8.7, 50.2)).locate("Frankfurt").name == "Frankfurt am Main"


def test_a_town_that_is_elsewhere_or_misspelt():
    refused(PO, "Napoli", "Naples, Italy (40.852 N 14.268 E) is not within reach of its roads")
    refused(PO, "Milanno", "did you mean Milan?")
    refused(PO, "Xqzzy", "give (lon, lat) instead")


def test_the_map_comes_first():
    net = small_italy()
    found = net.locate("milano")
    assert (found.name, found.note, found.from_geonames) == ("Milano", "", False)
    assert not net.locate("brescia").from_geonames
    assert net.locate("brescia").note.startswith("'brescia' is taken for Bréscia Ovest (A 22")


def test_a_junction_of_that_name_comes_first():
    net = road((9.0, 45.3), (9.2, 45.4), node_name=["Milano", ""])
    assert (net.locate("Milano").node, net.locate("Milano").from_geonames) == (0, False)
    assert net.locate("Mailand").from_geonames


def test_saved_and_foreign_networks_know_towns_too(tmp_path):
    PO.save(tmp_path / "po.platoon")
    graph = PO.to_networkx()
    frames = osmnx.graph_from_gdfs(*osmnx.graph_to_gdfs(graph))
    saved = open_network(tmp_path / "po.platoon")
    for net in (saved, po.load_network(graph), po.load_network(frames)):
        assert net.locate("Mailand").name == "Milan"
        assert net.place_name(0) == PO.place_name(0)


def test_plans_say_what_names_were_taken_for_and_credit_geonames(tmp_path):
    plan = po.plan_joint(PO, po.paper_weights(PO), [po.Trip("A", "Mailand", "Verona")])
    notes = [text for text in plan.remarks if "is taken for" in text]
    assert len(notes) == 2
    assert plan.credits == (GEONAMES_CREDIT,)
    assert plan.summary().count(GEONAMES_CREDIT) == 1
    assert po.Plan.from_dict(plan.to_dict()).credits == (GEONAMES_CREDIT,)
    po.write_html(plan, PO, tmp_path / "page.html")
    assert GEONAMES_CREDIT in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_a_plan_without_a_town_of_the_table_does_not_name_geonames():
    net = po.load_network("italy-motorways")
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    plan = po.plan_joint(net, po.paper_weights(net), trips)
    assert plan.credits == ()
    assert "GeoNames" not in plan.summary()
    # The ends alone are named by it here.
    assert po.plan_joint(OHIO, po.paper_weights(OHIO), [po.Trip("A", 0, 2)]).credits != ()


def test_many_names_are_not_all_explained():
    towns = ["Milan", "Pavia", "Lodi", "Crema", "Bergamo", "Brescia", "Verona", "Monza", "Cremona",
             "Piacenza", "Mantova", "Legnano"]  # fmt: skip
    trips = [po.Trip(f"{k}", one, two) for k, (one, two) in
             enumerate(zip(towns, towns[5:] + towns[:5], strict=True))]  # fmt: skip
    usable = []
    for trip in trips:
        try:
            po.plan_joint(PO, po.paper_weights(PO), [trip])
            usable.append(trip)
        except po.PlatoonError:
            continue
    assert len(usable) > 5
    plan = po.plan_joint(PO, po.paper_weights(PO), usable)
    assert sum("is taken for" in text for text in plan.remarks) == 8
    assert any("more names of places were taken for others" in text for text in plan.remarks)


def test_the_table_is_not_read_where_the_map_has_towns():
    code = (
        "import platoon_osm as po\n"
        "net = po.load_network('italy-motorways')\n"
        "trips = [po.Trip('A', 'Torino', 'Trieste'), po.Trip('B', 'Genova', 'Belluno')]\n"
        "po.plan_joint(net, po.paper_weights(net), trips).summary()\n"
        "from platoon_osm.network.towns.table import bundled_towns\n"
        "print(bundled_towns.cache_info().currsize)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "0"
