"""CSV: no text becomes a formula, however the file is parted; numbers stay numbers."""

import csv
import io
import re
import subprocess
import sys

import pytest
from places import ROOT

from platoon_osm.csv_tables import SIGNS, UNSEEN, safe_cell, write_table

FORMULAS = ("=1+1", "+1", "-1", "@SUM(1)", "\uff1dA1", "\uff0b1", "\uff0d1", "\uff20A", "\ufe661")
UNSEEN_BEFORE = (
    "", " ", "   ", "\u00a0", "\u200b", "\u200e", "\u202e", "\u2066", "\ufeff", "\u00ad", "\u2060",
    "\u3164", "\u2800", "\u3000", "\u180e", "\ufe0f", "\x00", "\x1b", '"', '""', ' " \u200d',
    "\U000e0020",
)  # fmt: skip
PARTED = ("a;", "a\t", "a|", "a\n", "a\r", ";", "\t", ";;", "a; ;", "a;b;")


@pytest.mark.parametrize("formula", FORMULAS)
def test_a_formula_is_told_behind_whatever_a_program_drops(formula):
    for before in UNSEEN_BEFORE:
        assert safe_cell(before + formula) == "'" + before + formula
        for parted in PARTED:
            assert is_harmless(safe_cell(parted + before + formula)), (parted, before)


def is_harmless(text):
    """Whether no part of a text begins a formula, by whatever sign it is parted."""
    dropped = re.compile(f"^[{UNSEEN}]+")
    cells = re.split("[;|\t\n\r]", text)
    return not any(re.match(f"[{SIGNS}]", dropped.sub("", cell)) for cell in cells)


@pytest.mark.parametrize(
    "text",
    ["", "Torino", "A4; A21", "Bolzano-Bozen", "a+b=c", "A1, A4", "x @ y", "5 - 3", "'=1", "a;'=1",
     "R\u00f6dental", "\u5927\u962a", "ok\u200b", "ends with ;", '"quoted"'],
)  # fmt: skip
def test_other_texts_stay(text):
    assert safe_cell(text) == text


def test_numbers_are_no_texts_and_halves_of_characters_are_told(tmp_path):
    path = tmp_path / "table.csv"
    rows = [("a;=1", -1.5, -3, None, True), ("b\ud800", 1 / 3, 0, "", False)]
    write_table(path, ["name", "x", "n", "gone", "is"], iter(rows), 4)
    text = path.read_bytes().decode("utf-8")
    assert text == "name,x,n,gone,is\na;'=1,-1.5,-3,,True\nb\ufffd,0.3333,0,,False\n"


def test_every_separator_reads_no_formula(tmp_path):
    path = tmp_path / "table.csv"
    names = [parted + before + f for f in FORMULAS for before in UNSEEN_BEFORE for parted in PARTED]
    write_table(path, ["first", "name", "last"], [("x", name, "y") for name in names], 6)
    text = path.read_bytes().decode("utf-8")
    dropped = re.compile(f"^[{UNSEEN}]+")
    for separator in ",;\t|":
        for row in csv.reader(io.StringIO(text, newline=""), delimiter=separator):
            for cell in row:
                assert not re.match(f"[{SIGNS}]", dropped.sub("", cell)), (separator, row)


def test_all_tables_of_the_package_are_written_here():
    """One rule for formulas: no other module opens a writer of CSV."""
    found = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "platoon_osm").rglob("*.py")
        if re.search(r"csv\.(Dict)?[Ww]riter|\.to_csv\(", path.read_text(encoding="utf-8"))
    }
    assert found == {"platoon_osm/csv_tables.py"}


def test_it_costs_little_to_import():
    code = "import sys, platoon_osm.csv_tables; print('numpy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT,
        timeout=60,
    )  # fmt: skip
    assert done.stdout.strip() == "False"
