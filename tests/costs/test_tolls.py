"""Tolls by country: the table, and what is due on edges and routes."""

import datetime

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import ROOT

from platoon_osm.costs.tolls.charges import due_m, route_tolls, toll_per_m
from platoon_osm.costs.tolls.table import ROADS, looked_up, toll_of, tolls
from platoon_osm.errors import NetworkError, ScenarioError
from platoon_osm.network.columns import ROAD_CLASSES
from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.network.preparing.split import split_edges
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.country.law import laws
from platoon_osm.sources.load import load_network
from platoon_osm.vehicles.profile import VEHICLES, Vehicle

WANTED = {
    "AT", "BE", "BG", "CH", "CZ", "DE", "DK", "EE", "ES", "FI", "FR", "GB", "GR", "HR", "HU", "IE",
    "IT", "LT", "LU", "LV", "NL", "NO", "PL", "PT", "RO", "SE", "SI", "SK", "US", "CA",
}  # fmt: skip
TRUCK = VEHICLES["eu-40t"]
VAN = VEHICLES["van-3.5t"]


def test_the_table_has_every_country_and_each_is_consistent():
    table = tolls()
    assert set(table) >= WANTED
    assert looked_up() <= datetime.date.today()
    known_codes = {law.partition("-")[0] for law in laws()}
    for code, toll in table.items():
        assert code == toll.code
        assert code in known_codes or code in {"BA", "MK", "RS"}, code
        assert toll.kind in ("distance", "time", "sections", "none")
        assert toll.roads in ROADS
        assert (toll.roads == "mapped") == (toll.kind in ("sections", "none")), code
        assert toll.source, code
        assert len(toll.currency) == 3, code
        assert toll.currency.isupper()
        # A figure has its year, its place, and the mass it is for; no figure has no year.
        assert toll.rate is None or (toll.kind == "distance" and 0.05 < toll.rate < 500), code
        assert toll.per_day is None or (toll.kind == "time" and 1 < toll.per_day < 100), code
        known = toll.rate is not None or toll.per_day is not None
        assert known == (toll.year is not None), code
        assert not known or (toll.page and toll.rate_over_t >= toll.limit_t), code
        assert not known or toll.priced_for(TRUCK), code
        assert toll.year is None or 2019 <= toll.year <= looked_up().year
        assert toll.kind in ("sections", "none") or toll.page, code
    for roads, classes in ROADS.items():
        assert set(classes) <= set(ROAD_CLASSES), roads
        assert "ferry" not in classes


def row(toll):
    """Return a country as the page on tolls has it."""
    limit = f"{'from' if toll.inclusive else 'over'} {toll.limit_t:g} t" if toll.limit_t else "all"
    figure = ""
    if toll.rate is not None:
        figure = f"{toll.rate:g} {toll.currency}/km ({toll.year})"
    if toll.per_day is not None:
        figure = f"{toll.per_day:g} {toll.currency} a day ({toll.year})"
    source = "; looked up: ".join(filter(None, (toll.source, toll.page)))
    cells = (toll.code, toll.kind, toll.roads, limit, figure, source, toll.note)
    return f"| {' | '.join(cells)} |"


def test_the_page_has_the_table():
    page = (ROOT / "docs" / "tolls.md").read_text("utf-8")
    shown = page[page.index("<!-- tolls:begin -->") : page.index("<!-- tolls:end -->")]
    assert [line for line in shown.splitlines() if line.startswith("| ")][2:] == [
        row(toll) for toll in tolls().values()
    ]


def test_a_state_has_the_toll_of_its_country():
    assert toll_of("us-ca") is toll_of("US")
    assert toll_of("at") is tolls()["AT"]
    assert toll_of("") is None
    assert toll_of("XX") is None


@pytest.mark.parametrize(
    ("country", "rating_t", "due"),
    [("AT", 3.5, False), ("AT", 3.51, True), ("DK", 11.9, False), ("DK", 12, True)],
)
def test_the_limit_of_mass_is_that_of_the_law(country, rating_t, due):
    vehicle = Vehicle("some", mass_t=3, rating_t=rating_t)
    assert toll_of(country).concerns(vehicle) == due


def roads(*rows):
    """Return a network of single edges of a kilometre: (country, class, toll, metres free)."""
    count = len(rows)
    country, kind, toll, free = zip(*rows, strict=True)
    return RoadNetwork.from_edges(
        np.arange(count), np.arange(count) + 1, np.full(count, 1000.0),
        lon=9 + 0.01 * np.arange(count + 1), lat=np.full(count + 1, 45.0), country=list(country),
        road_class=[ROAD_CLASSES.index(name) for name in kind], toll=list(toll),
        toll_free_m=list(free),
    )  # fmt: skip


def test_what_is_due_by_country_and_road():
    net = roads(
        ("AT", "motorway", False, 0), ("AT", "motorway", False, 1000), ("AT", "primary", False, 0),
        ("AT", "trunk", True, 0), ("DE", "primary", False, 0), ("DE", "secondary", False, 0),
        ("IT", "motorway", False, 0), ("IT", "motorway", True, 0), ("FI", "motorway", False, 0),
        ("CH", "other", False, 0), ("CH", "ferry", False, 0), ("", "motorway", True, 0),
        ("LU", "motorway", False, 0), ("US-CA", "motorway", True, 0),
        ("DE", "motorway", False, 250),
    )  # fmt: skip
    assert due_m(net).tolist() == [
        1000, 0, 0, 1000, 1000, 0, 0, 1000, 0, 1000, 0, 1000, 0, 1000, 750,
    ]  # fmt: skip
    # A van pays where everybody does, and nothing that is asked of heavy vehicles.
    assert due_m(net, VAN).tolist() == [0, 0, 0, 0, 0, 0, 0, 1000, 0, 0, 0, 1000, 0, 1000, 0]
    per_m = toll_per_m(net)
    assert per_m[0] == pytest.approx(0.0005317)
    assert per_m[1] == 0
    assert per_m[3] == pytest.approx(0.0005317)
    assert per_m[14] == pytest.approx(0.75 * 0.000348)
    assert np.isnan(per_m[[7, 9, 11, 13]]).all()
    assert per_m[[2, 5, 6, 8, 10, 12]].tolist() == [0] * 6
    assert not toll_per_m(net, VAN)[[0, 3, 4, 9]].any()


def test_a_rate_is_that_of_its_vehicle_and_currency():
    net = roads(("DK", "motorway", False, 0), ("AT", "motorway", False, 0))
    assert np.isnan(toll_per_m(net)[0])
    assert toll_per_m(net, exchange={"DKK": 7.46})[0] == pytest.approx(1.10 / 7.46 / 1000)
    lighter = Vehicle("18 t", mass_t=18)
    older = Vehicle("old", emission_class="euro3")
    for vehicle in (lighter, older):
        assert due_m(net, vehicle).tolist() == [1000, 1000]
        assert np.isnan(toll_per_m(net, vehicle, {"DKK": 7.46})).all()


@pytest.mark.parametrize("rate", [0, -1, float("nan"), float("inf"), "7", None])
def test_what_is_no_rate_of_exchange_is_refused(rate):
    with pytest.raises(ScenarioError, match="exchange rate of 'DKK'"):
        toll_per_m(roads(("DK", "motorway", False, 0)), exchange={"DKK": rate})


def test_the_tolls_of_a_route():
    net = roads(
        ("DE", "motorway", False, 0), ("DE", "motorway", False, 1000), ("AT", "motorway", False, 0),
        ("IT", "motorway", True, 0), ("DE", "tertiary", False, 0), ("EE", "primary", False, 0),
    )  # fmt: skip
    de, at, it, ee = route_tolls(net, range(6))
    assert (de.country, de.kind, de.km, de.due_km, de.unknown_km) == ("DE", "distance", 3, 1, 0)
    assert (de.amount, de.currency, de.year) == (pytest.approx(0.348), "EUR", 2024)
    assert (at.country, at.amount) == ("AT", pytest.approx(0.5317))
    assert (it.kind, it.due_km, it.unknown_km, it.amount) == ("sections", 1, 1, 0)
    assert (ee.kind, ee.due_km, ee.per_day) == ("time", 0, 22)
    assert route_tolls(net, [5], VAN)[0].per_day is None
    assert route_tolls(net, []) == ()
    twice = route_tolls(net, [2, 2])
    assert twice[0].amount == pytest.approx(2 * 0.5317)
    with pytest.raises(NetworkError, match="edge 6"):
        route_tolls(net, [6])


kinds = st.sampled_from(["motorway", "trunk", "primary", "other"])
places = st.sampled_from(["AT", "DE", "IT", "DK", "FI", ""])


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(places, kinds, st.booleans(), st.floats(0, 1000)), min_size=1,
                max_size=8), st.data())  # fmt: skip
def test_amounts_add_up_over_edges_however_they_are_cut_and_joined(rows, data):
    net = roads(*rows)
    vehicle = data.draw(st.sampled_from([TRUCK, VAN]))
    exchange = {"DKK": 7.46}

    def total(other):
        told = route_tolls(other, range(other.m), vehicle)
        return [
            (one.country, pytest.approx(one.due_km, abs=1e-3), pytest.approx(one.amount, abs=1e-3))
            for one in sorted(told, key=lambda one: one.country)
        ]

    cut, _ = split_edges(
        net, [data.draw(st.integers(0, net.m - 1))], [data.draw(st.floats(0, 999))]
    )
    assert total(cut) == total(net)
    single = [route_tolls(net, [edge], vehicle)[0] for edge in range(net.m)]
    for one in route_tolls(net, range(net.m), vehicle):
        own = [part for part in single if part.country == one.country]
        assert one.amount == pytest.approx(sum(part.amount for part in own))
        assert one.due_km == pytest.approx(sum(part.due_km for part in own))
    per_m = toll_per_m(net, vehicle, exchange)
    for edge, part in enumerate(single):
        if not np.isnan(per_m[edge]):
            euro = part.amount / exchange.get(part.currency, 1.0)
            assert per_m[edge] * net.length_m[edge] == pytest.approx(euro)
    # Of roads of one class a chain pays what its parts paid.
    alike = net.with_columns(road_class=0)
    assert total(merge_chains(alike)) == total(alike)


@pytest.mark.parametrize(
    ("tags", "due_km"),
    [
        ({}, 0.788), ({"toll": "no"}, 0), ({"toll:hgv": "no"}, 0), ({"toll:N3": "no"}, 0),
        ({"toll": "no", "toll:hgv": "yes"}, 0.788), ({"toll": "yes", "toll:hgv": "no"}, 0),
        ({"toll": "yes"}, 0.788), ({"toll": " No "}, 0),
    ],
)  # fmt: skip
def test_tags_of_toll_stand_over_the_national_charge(tmp_path, tags, due_km):
    tags = {"highway": "motorway", **tags}
    told = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
    (tmp_path / "a.osm").write_text(
        '<osm version="0.6"><node id="1" lon="13.0" lat="47.0"/><node id="2" lon="13.01" '
        f'lat="47.0"/><way id="1"><nd ref="1"/><nd ref="2"/>{told}</way></osm>'
    )
    net = load_network(tmp_path / "a.osm", country="AT")
    assert due_m(net).sum() / 1000 == pytest.approx(due_km * np.cos(np.radians(47)) / np.cos(
        np.radians(45)), abs=2e-3)  # fmt: skip
