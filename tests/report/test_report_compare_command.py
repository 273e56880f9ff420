"""The verb `compare`, as a user meets it."""

from __future__ import annotations

from pathlib import Path

import pytest

import platoon_osm
from platoon_osm.cli import main

CORRIDOR = """
title = "A small corridor"
network = "italy-motorways"
case = "C"

[costs]
xi = {xi}

[[trips]]
vehicle = "A"
origin = "Torino"
destination = "Trieste"

[[trips]]
vehicle = "B"
origin = "Genova"
destination = "Belluno"
"""


@pytest.fixture(autouse=True)
def scenarios(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, xi in (("low", 0.1), ("high", 0.3)):
        Path(f"{name}.toml").write_text(CORRIDOR.format(xi=xi))


def test_cases_side_by_side(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", "low.toml", "--cases", "A,C,D", "-o", "compare.html"]) == 0
    out = capsys.readouterr().out
    assert "A small corridor, case D" in out
    assert out.endswith("Written: compare.html\n")
    text = Path("compare.html").read_text()
    assert text.count('class="card"') == 3
    assert Path("compare.html").stat().st_size < 400_000


def test_other_parameters_side_by_side(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", "low.toml", "high.toml", "-o", "compare.html"]) == 0
    assert "other cost parameters" in Path("compare.html").read_text()


def test_what_is_wrong_is_said_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    other = Path("low.toml").read_text().replace("italy-motorways", "elsewhere.osm")
    Path("other.toml").write_text(other)
    for arguments, said in (
        (["low.toml", "other.toml", "-o", "c.html"], "names another network"),
        (["low.toml", "--cases", "A,Q", "-o", "c.html"], "'Q'"),
        (["low.toml", "-o", "low.toml/c.html"], "low.toml is no folder"),
    ):
        assert main(["compare", *arguments]) == 2
        err = capsys.readouterr().err
        assert said in err
        assert err.count("\n") == 1
    assert not Path("c.html").exists()


def test_the_front_door_names_them() -> None:
    for name in (
        "explore", "write_comparison", "write_csv", "write_figures", "write_flows", "write_gpx",
    ):  # fmt: skip
        assert callable(getattr(platoon_osm, name))
        assert name in platoon_osm.__all__
