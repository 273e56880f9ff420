"""Tables and curves of docs/fleets.md: what is measured once stays, and is told as it was."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from places import ROOT
from soak import SOAK, soaked

from benchmarks import fleet_tables
from benchmarks.fleet_cells import CURVES, TABLE, Cell
from benchmarks.fleet_tables import Figures, curves_of, read_cells, table_of, write_all
from benchmarks.fleets import figures_of, measured

SOME = [Cell(trucks=trucks, seed=seed) for trucks in (100, 200) for seed in (1, 2, 3)]


def figures(cell: Cell) -> Figures:
    """Return figures that no other cell has."""
    number = cell.trucks + 7 * cell.seed**2
    return Figures(number / 100, number / 90, number / 1000, number / 3, number * 2.0, "time")


def test_what_is_measured_is_not_measured_again(tmp_path, capsys):
    path, asked = tmp_path / "deep" / "fleets.csv", []

    def measure(cell):
        asked.append(cell)
        if cell == SOME[2] and len(asked) < 5:
            raise RuntimeError("it was killed")
        return figures(cell)

    failed = measured(SOME[:4], path, measure)
    assert asked == SOME[:4]
    assert [SOME[2].key[-1], "it was killed"] == [failed[0][-16], failed[0][-13:]]
    assert list(read_cells(path)) == [SOME[0], SOME[1], SOME[3]]
    assert measured(SOME, path, measure) == []
    assert asked[4:] == [SOME[2], *SOME[4:]]
    assert read_cells(path) == {
        cell: replace(one, **{
            name: float(f"{getattr(one, name):.6g}")
            for name in ("saving_pct", "bound_pct", "gap_pct", "seconds", "peak_mb")
        })
        for cell in SOME for one in [figures(cell)]
    }  # fmt: skip
    measured(SOME, path, measure)
    assert len(asked) == 7
    # It says how long the rest may take: its limits of a minute, and what is beside.
    told = capsys.readouterr().out.splitlines()
    assert told[0] == "0 cells are measured; 4 more take at most 0 h 5 min"
    assert told[-1] == "6 cells are measured; 0 more take at most 0 h 0 min"


def test_a_row_has_the_medians_of_its_draws_and_the_largest_gap():
    known = {cell: figures(cell) for cell in SOME}
    *_, first, second = table_of(known, SOME).splitlines()
    # Numbers 107, 128 and 163 of 100 trucks.
    assert [part.strip() for part in first.strip("|").split("|")] == [
        "Germany", "100", "free", "any", "uniform", "30", "60", "3", "1.2800", "1.4222", "0.1280",
        "0.1630", "43", "326",
    ]  # fmt: skip
    del known[SOME[5]]
    assert " | 2 | 2.1750 | " in table_of(known, SOME)
    assert second != table_of(known, SOME).splitlines()[-1]


def test_all_that_is_asked_is_measured():
    for cells in (TABLE, CURVES):
        assert len(set(cells)) == len(cells)
        assert [Cell.of_key(cell.key) for cell in cells] == list(cells)
    for place, draws in (("DE", 10), ("IT", 10), ("map", 3)):
        free = [cell for cell in TABLE if cell == Cell(place, seed=cell.seed)]
        assert len(free) == draws
    assert {cell.trucks for cell in CURVES} >= {100, 1000, 20_000}


def test_tables_are_made_of_the_file(tmp_path, monkeypatch):
    monkeypatch.setattr(fleet_tables, "draw", lambda *_: None)
    (tmp_path / "fleets.md").write_text("# Fleets\n\n<!-- fleets:begin -->\nold\n"
                                        "<!-- fleets:end -->\n\nafter\n")  # fmt: skip
    measured([*SOME, *TABLE[:3], *CURVES[:9]], tmp_path / "fleets.csv", figures)
    write_all(tmp_path)
    page, known = (tmp_path / "fleets.md").read_text(), read_cells(tmp_path / "fleets.csv")
    assert blocks(page)["fleets"] == table_of(known)
    assert blocks(page)["fleet-curves"].endswith(curves_of(known))
    assert "old" not in page
    assert "\nafter\n" in page


@soaked
@pytest.mark.skipif(not SOAK, reason="drawing takes seconds")
def test_the_figure_is_the_same_each_time(tmp_path):
    pytest.importorskip("matplotlib")
    known = {cell: figures(cell) for cell in CURVES[::2]}
    fleet_tables.draw(known, tmp_path / "images" / "one.svg")
    fleet_tables.draw(known, tmp_path / "images" / "two.svg")
    one, two = (tmp_path / "images" / f"{name}.svg" for name in ("one", "two"))
    assert b"<svg" in one.read_bytes() == two.read_bytes()


def blocks(page: str) -> dict[str, str]:
    """Return what stands between the markers of a page."""
    found = re.findall(r"(?s)<!-- ([\w-]+):begin -->\n(.*?)\n<!-- \1:end -->", page)
    return dict(found)


def test_the_page_says_what_the_file_says():
    file: Path = ROOT / "docs" / "fleets.csv"
    if not file.is_file():
        pytest.skip("docs/fleets.csv is not measured")
    known, page = read_cells(file), blocks((ROOT / "docs" / "fleets.md").read_text())
    assert set(known) <= {*TABLE, *CURVES}
    if set(known) & set(TABLE):
        assert page["fleets"] == table_of(known)
    if set(known) & set(CURVES):
        assert page["fleet-curves"].endswith(curves_of(known))


def test_one_fleet_is_planned():
    found = Figures(**figures_of(Cell("map", 12, limit_s=20.0)))
    assert 0 <= found.saving_pct <= found.bound_pct < 10
    assert found.gap_pct == pytest.approx(
        100 * (found.bound_pct - found.saving_pct) / found.bound_pct if found.bound_pct else 0
    )
    assert found.ended == "proved"
