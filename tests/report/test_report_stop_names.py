"""Places given by coordinates are told by the nearest town; a crowd's title counts the others."""

from __future__ import annotations

from pathlib import Path

import pytest
from plan_kinds import plan_kind

from platoon_osm.report import report_document, write_html
from platoon_osm.report.document.stop_names import brief_name


@pytest.mark.parametrize(
    ("name", "brief"),
    [
        ("near Oakland (37.800 N 122.270 W)", "near Oakland"),
        ("37.800 N 122.270 W", "37.800 N 122.270 W"),
        ("near Oakland (37.801 N 122.270 W)", "near Oakland (37.801 N 122.270 W)"),
        ("Depot (north)", "Depot (north)"),
        (" (37.800 N 122.270 W)", " (37.800 N 122.270 W)"),
        ("", ""),
    ],
)
def test_only_a_stops_own_coordinates_are_left_out(name: str, brief: str) -> None:
    assert brief_name(name, -122.27, 37.8) == brief


def test_a_table_tells_both_ends_of_a_trip_between_coordinates(tmp_path: Path) -> None:
    plan, net = plan_kind("real california")
    document = report_document(plan, net)
    assert document["vehicles"][0]["origin"]["name"] == "near San Francisco (37.775 N 122.410 W)"
    write_html(plan, net, tmp_path / "plan.html")
    text = (tmp_path / "plan.html").read_text("utf-8")
    assert "<bdi>near San Francisco</bdi>" in text
    assert "<bdi>near Los Angeles</bdi>" in text
    assert document["title"] == "Platoon plan, near San Francisco \u2013 near Los Angeles"


def test_the_title_of_a_crowd_counts_the_others() -> None:
    title = report_document(*plan_kind("fifty vehicles"))["title"]
    assert title == "Platoon plan, Brennero \u2013 Ferrara and 49 more"
