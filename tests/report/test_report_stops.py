"""Stops for trucks on the map of a plan: those on the way, with what there is, in each language."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hostile_names import HOSTILE
from osm_files import MOTORWAY, row, write

import platoon_osm as po
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import Plan
from platoon_osm.report.document.document import report_document
from platoon_osm.sources.osm.extract import read_osm

FUEL = {"amenity": "fuel", "fuel:diesel": "yes", "fuel:lng": "yes", "fuel:adblue": "yes"}


def on_the_way(folder: Path, name: str = "Autohof") -> tuple[Plan, RoadNetwork]:
    """Return a plan east along a road with a truck stop, chargers, and a stop on the other side."""
    nodes = row(4) | {
        10: (11.005, 44.9994, {"amenity": "parking", "hgv": "designated", "capacity": "1200",
                               "name": name}),
        11: (11.006, 44.9994, FUEL),
        20: (11.015, 44.9994, {"amenity": "charging_station", "hgv": "yes",
                               "socket:mcs:output": "1 MW"}),
        30: (11.005, 45.0009, {"highway": "rest_area", "name": "Opposite"}),
        40: (11.025, 44.9994, {"highway": "services", "name": "Beyond"}),
    }  # fmt: skip
    back = {k + 100: (lon, 45.0003, {}) for k, (lon, _, _) in row(4).items()}
    ways = {1: ([1, 2, 3, 4], MOTORWAY), 2: ([104, 103, 102, 101], MOTORWAY)}
    net = read_osm(write(folder, nodes | back, ways))
    ids = net.node_id.tolist()
    trip = po.Trip("A", ids.index(1), ids.index(4), profile="eu-40t")
    return po.plan_joint(net, po.paper_weights(net), [trip]), net


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", ["truck parking, truck spaces: 1,200, AdBlue, diesel, LNG",
                "charging, charging up to 1,000 kW", "service area"]),
        ("de", ["Lkw-Parkplatz, Lkw-Stellplätze: 1.200, AdBlue, Diesel, LNG",
                "Ladestation, Laden bis 1.000 kW", "Raststätte"]),
        ("it", ["parcheggio per camion, posti camion: 1.200, AdBlue, gasolio, LNG",
                "ricarica, ricarica fino a 1.000 kW", "area di servizio"]),
    ],
)  # fmt: skip
def test_the_stops_on_the_way_with_what_there_is(
    language: str, told: list[str], tmp_path: Path
) -> None:
    plan, net = on_the_way(tmp_path)
    stops = report_document(plan, net, language=language)["stops"]
    assert [stop[3] for stop in stops] == told
    assert stops[0][:3] == [110050, 449994, "Autohof"]
    assert stops[1][2] == told[1].split(",")[0]  # it has no name
    assert stops[2][2] == "Beyond"


@pytest.mark.parametrize("name", HOSTILE[:1])
def test_names_of_stops_are_text(name: str, tmp_path: Path) -> None:
    plan, net = on_the_way(tmp_path, "plain")
    texts = [*net.texts]
    at = texts.index("plain")
    from dataclasses import replace

    from platoon_osm.network.texts import TextTable

    net = replace(net, texts=TextTable.from_strings([*texts[:at], name, *texts[at + 1 :]]))
    po.write_html(plan, net, tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    (data,) = re.findall(r'id="plan-data">(.*?)</script>', page, re.S)
    stops = json.loads(data)["stops"]
    # A line for each, whatever is in the name, and nothing that could end the element.
    assert len(stops["names"].split("\n")) == len(stops["told"].split("\n")) == 3
    assert "<" not in data
    assert 'data-layer="stops"' in page


def test_without_stops_there_is_no_layer_for_them(tmp_path: Path) -> None:
    net = read_osm(write(tmp_path, row(3), {1: ([1, 2, 3], MOTORWAY)}))
    plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", 0, 1)])
    po.write_html(plan, net, tmp_path / "page.html")
    assert 'data-layer="stops"' not in (tmp_path / "page.html").read_text("utf-8")


@pytest.mark.browser
def test_close_up_dots_tell_what_there_is(visit: Callable[..., Any], tmp_path: Path) -> None:
    plan, net = on_the_way(tmp_path)
    po.write_html(plan, net, tmp_path / "page.html")
    opened = visit(tmp_path / "page.html", reduced_motion="reduce")
    tips = """(zoom) => {
      map_plan.setView([44.9994, 11.005], zoom);
      const found = [];
      map_plan.eachLayer((layer) => {
        const tip = layer.getTooltip?.()?.getContent();
        if (tip instanceof Element) found.push(tip.textContent);
      });
      return found.filter((text) => text.includes("truck"));
    }"""
    assert opened.page.evaluate(tips, 6) == []
    (tip,) = opened.page.evaluate(tips, 12)
    assert "Autohof" in tip
    assert "truck spaces: 1,200" in tip
    opened.page.locator('[data-layer="stops"]').uncheck()
    assert opened.page.evaluate(tips, 12) == []
