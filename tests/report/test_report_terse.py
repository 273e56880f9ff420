"""What makes pages light changes nothing that is seen, and nothing that is known."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind

from platoon_osm.report import write_html
from platoon_osm.report.markup.fragments import Piece, written
from platoon_osm.report.markup.style_classes import with_style_classes
from platoon_osm.report.pages import page_parts
from platoon_osm.report.pages.packing import packed

Visit = Callable[..., Any]

LOOKS = """() => [...document.querySelectorAll('body svg:not(.leaflet-zoom-animated) *')]
  .filter((e) => !e.closest('.folium-map'))
  .map((e) => {
    const style = getComputedStyle(e);
    const box = e.getBoundingClientRect();
    return [
      e.tagName, style.fill, style.stroke, style.strokeWidth, style.strokeDasharray,
      style.strokeLinecap, style.strokeLinejoin, style.strokeOpacity, style.fillOpacity,
      style.fontSize, style.fontWeight, style.textAnchor, style.display, style.opacity,
      ...[box.x, box.y, box.width, box.height].map((x) => x.toFixed(1)),
    ].join(' ');
  })"""


@pytest.mark.browser
def test_drawings_look_the_same_without_their_classes(
    visit: Visit, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan, net = plan_kind("eight vehicles")
    terse, whole = tmp_path / "terse.html", tmp_path / "whole.html"
    write_html(plan, net, terse)
    monkeypatch.setattr(page_parts, "with_style_classes", lambda markup, style: (markup, style))
    write_html(plan, net, whole)
    assert terse.stat().st_size < whole.stat().st_size - 10_000
    pages = [visit(path, 1440, 900).page for path in (terse, whole)]
    for media in ({"color_scheme": "light"}, {"color_scheme": "dark"}, {"media": "print"}):
        seen = []
        for page in pages:
            page.emulate_media(**media)
            seen.append(page.evaluate(LOOKS))
        assert len(seen[0]) == len(seen[1]) > 500
        assert [pair for pair in zip(*seen, strict=True) if pair[0] != pair[1]][:5] == []


def test_names_are_no_attributes() -> None:
    """What others have named something keeps its letters, whatever it looks like."""
    name = '<text x="1.0" fill="#fff"> x="2.0" '
    drawn = written(tuple(Piece("about-row", {"label": name, "text": name}) for _ in range(40)))
    body, style = with_style_classes(drawn, '[fill="#fff"]{fill:red}')
    assert body == drawn
    assert style == '[fill="#fff"]{fill:red}'


def read(value: Any) -> Any:
    """Put back what was packed, as the script of a page does."""
    if isinstance(value, list):
        return [read(item) for item in value]
    if not isinstance(value, dict):
        return value
    if "*" in value:
        return [read(value["*"])] * value["n"]
    if "|" in value:
        few = read(value["|"])
        return [few[place] for place in value["i"]]
    if "#" in value:
        every = iter(read(value["of"]))
        return [[next(every) for _ in range(size)] for size in read(value["#"])]
    if "=" in value:
        columns = {name: read(column) for name, column in value["="].items()}
        count = len(next(iter(columns.values())))
        return [{name: column[k] for name, column in columns.items()} for k in range(count)]
    return {name: read(item) for name, item in value.items()}


@pytest.mark.parametrize(
    "value",
    [
        [], {}, None, 1.0, [{}], [{}, {}], [{"a": 1}], [{"a": 1}, {"b": 1}],
        [{"a": []}, {"a": []}], [{"a": [{"b": 1}, {"b": 2}]}, {"a": []}],
        [{"a": [{"b": 1}]}, {"a": [{"b": 1.5}, {"b": None}]}],
        [{"a": [1, [2]]}, {"a": [[3], {"c": 4}]}], [{"a": None}, {"a": [1]}],
        [{"a": k % 2, "b": "long text" * (k % 3), "c": [k, k], "d": {"e": k}} for k in range(30)],
        {"x": [{"a": True}, {"a": 1}], "columns": [{"n": 1, "of": 2}, {"n": 3, "of": 4}]},
    ],
)  # fmt: skip
def test_what_is_packed_comes_back(value: Any) -> None:
    again = read(json.loads(json.dumps(packed(value))))
    assert again == value
    assert re.sub(r"\.0\b", "", json.dumps(again)) == re.sub(r"\.0\b", "", json.dumps(value))
