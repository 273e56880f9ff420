"""The table of speed limits: whole, plausible, sourced, and the same on the page about it."""

import re
from math import inf

import pytest
from places import ROOT

from platoon_osm.sources.country.law import FREE, KINDS, kmh_of, law_of, laws

TABLE = ROOT / "platoon_osm" / "sources" / "country" / "speed_limits.csv"
PAGE = (ROOT / "docs" / "speeds.md").read_text("utf-8")
EU = "AT BE BG HR CY CZ DK EE FI FR DE GR HU IE IT LV LT LU MT NL PL PT RO SK SI ES SE"
STATES = (
    "AL AK AZ AR CA CO CT DE DC FL GA HI ID IL IN IA KS KY LA ME MD MA MI MN MS MO MT NE NV NH NJ "
    "NM NY NC ND OH OK OR PA RI SC SD TN TX UT VT VA WA WV WI WY"
)
OTHERS = "CH LI NO IS GB AL BA MK RS XK TR UA MD CA-ON CA-QC AU NZ JP BR"


def test_the_countries_are_there():
    words = re.compile(r"\S+")
    asked = {*words.findall(EU), *words.findall(OTHERS)}
    asked |= {f"US-{state}" for state in words.findall(STATES)}
    assert asked <= set(laws())
    assert len([code for code in laws() if code.startswith("CA-")]) == 13


@pytest.mark.parametrize("law", laws().values(), ids=list(laws()))
def test_a_row_is_plausible(law):
    assert all(20 <= value <= 150 or value == inf for value in law.cars.values())
    assert all(30 <= value <= 121 for value in law.trucks.values())
    # Nobody may drive faster in a town than in the country, nor there than on a motorway.
    for limits in (law.cars, law.trucks):
        known = [limits[kind] for kind in reversed(KINDS) if kind in limits]
        assert law.code in {"BE", "JP"} or known == sorted(known)
    for kind, value in law.trucks.items():
        assert value <= law.car_kmh(kind) or law.code in {"BE", "SE", "US-MI"}
    assert law.limiter_kmh in {None, 90, 100, 105, inf}


def test_sources_are_named_once_each_and_used():
    named = re.findall(r"(?m)^#   ([A-Z]+) +\S", TABLE.read_text("utf-8"))
    assert len(set(named)) == len(named)
    used = {initial for law in laws().values() for initial in law.sources.split()}
    assert used == set(named)
    assert all(law.sources for law in laws().values())


def test_the_page_has_the_table_and_its_sources():
    lines = TABLE.read_text("utf-8").splitlines()
    rows = [line.split(",") for line in lines if not line.startswith("#")][1:]
    shown = [
        [cell.strip() for cell in line.strip("|\n").split("|")]
        for line in PAGE.splitlines()
        if re.match(r"\| [A-Z]{2}(-[A-Z]+)? \|", line)
    ]
    assert shown == rows
    for line in lines:
        if found := re.match(r"#   ([A-Z]+) +(\S.*)", line):
            assert f"- **{found[1]}**: {found[2]}" in PAGE


@pytest.mark.parametrize(
    ("text", "kmh"), [("80", 80), ("55 mph", 88.513920), ("none", inf), ("", None), (" ", None)]
)
def test_cells(text, kmh):
    assert kmh_of(text) == (None if kmh is None else pytest.approx(kmh))


def test_a_state_without_a_row_has_its_country_s():
    assert law_of("BE-VLG") is law_of("be") is laws()["BE"]
    assert law_of("US-CA") is laws()["US-CA"]
    assert law_of("US-ZZ") is law_of("ZW") is law_of("") is law_of(None) is FREE
