"""Rules that drawings share: colours, letters, ticks, signs, how long is worth telling."""

from __future__ import annotations

import re

import pytest
from places import ROOT

from platoon_osm.plans.clock import MENTIONED_S, duration, late_by, whole_minutes
from platoon_osm.report.drawing import palette
from platoon_osm.report.drawing.ticks import round_below, round_step
from platoon_osm.report.drawing.vehicle_styles import letter_size
from platoon_osm.report.markup.fragments import asset
from platoon_osm.report.markup.quantities import clock_span, gain_or_loss, true_minus

REPORT = ROOT / "platoon_osm" / "report"

HEX = re.compile(r"#[0-9a-fA-F]{6}\b|#[0-9a-fA-F]{3}\b")


def test_colours_stand_in_the_palette_alone() -> None:
    for path in REPORT.rglob("*.py"):
        # A style for QGIS is a page of another program, written as that program has it.
        if path.name not in ("palette.py", "qgis_styles.py", "qgis_symbols.py"):
            assert HEX.findall(path.read_text(encoding="utf-8")) == [], path


@pytest.mark.parametrize(
    ("colour", "assets"),
    [
        (palette.INK, ["theme.css", "panel.html", "charts.html", "schedule.html", "map.svg.html"]),
        (palette.MUTED, ["charts.html", "schedule.html", "map.svg.html", "theme.css"]),
        (palette.PLATOON, ["schedule.html", "map.svg.html", "routes.js"]),
        (palette.PLATOON_CASING, ["schedule.html", "map.svg.html", "routes.js"]),
        (palette.FRAME, ["map.svg.html"]),
        (palette.LATE, ["theme.css", "time_distance.html", "marks.js"]),
        (palette.CASING, ["map.svg.html", "theme.css"]),
        (palette.CROWD, ["marks.js"]),
    ],
)
def test_style_sheets_and_scripts_share_them(colour: str, assets: list[str]) -> None:
    for name in assets:
        assert colour in HEX.findall(asset(name)), name


@pytest.mark.parametrize(
    ("seconds", "minutes"), [(0, 0), (29.9, 0), (30, 1), (90, 2), (150, 3), (210, 4), (3570, 60)]
)
def test_one_rule_rounds_all_durations(seconds: float, minutes: int) -> None:
    assert whole_minutes(seconds) == minutes
    if minutes < 60:
        assert duration(seconds) == clock_span(seconds) == f"{minutes} min"
    else:
        assert (duration(seconds), clock_span(seconds)) == ("1 h 00 min", "1:00 h")


def test_what_is_worth_telling_is_not_told_as_nothing() -> None:
    assert duration(MENTIONED_S) == "1 min"
    assert duration(MENTIONED_S - 0.01) == "0 min"
    assert late_by(MENTIONED_S) == "1 min"
    assert late_by(MENTIONED_S - 0.01) == "less than a minute"


@pytest.mark.parametrize(
    ("number", "step", "below"),
    [
        (1, 1, 1),
        (1.01, 2, 1),
        (3, 5, 2),
        (5, 5, 5),
        (7, 10, 5),
        (0.03, 0.05, 0.02),
        (1e4, 1e4, 1e4),
    ],
)
def test_steps_are_round(number: float, step: float, below: float) -> None:
    assert round_step(number) == pytest.approx(step)
    assert round_below(number) == pytest.approx(below)


def test_letters_fit_their_disc() -> None:
    assert [letter_size(text) for text in ("A", "AA", "12\u00d7", "AAAA")] == [11, 9, 8, 8]


def test_a_saving_is_gain_loss_or_neither() -> None:
    assert [gain_or_loss(saved) for saved in (1e-9, 0.0, -1e-9)] == ["gain", "even", "loss"]
    assert true_minus("-1,5") == "\u22121,5"


def test_browsers_are_asked_functions_when_tests_wait() -> None:
    # The page's own policy forbids what waiting on an expression evaluates: it is refused as soon
    # as the first look does not find it true, so such a test passes or fails by the clock.
    waits = re.compile(r"wait_for_function\(\s*f?(\"[^\"]*\"|'[^']*')")
    for path in (ROOT / "tests").rglob("*.py"):
        for asked in waits.findall(path.read_text(encoding="utf-8")):
            assert "=>" in asked, (path, asked)
