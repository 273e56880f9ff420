"""Workbooks: dates as spreadsheets keep them, sheets by name, formulas, errors, damage."""

import builtins
import random
import zipfile
from datetime import date, datetime, time

import openpyxl
import pytest
from openpyxl.utils.datetime import CALENDAR_MAC_1904
from trip_files import write_xlsx

import platoon_osm as po

HEAD = ["vehicle", "origin", "destination", "earliest_departure", "flexibility_min"]
SIX = datetime(2026, 3, 2, 6)


def book_of(folder, *rows, name="t.xlsx", sheet="Trips", epoch=None):
    book = openpyxl.Workbook()
    if epoch:
        book.epoch = epoch
    book.active.title = sheet
    for row in rows:
        book.active.append(list(row))
    book.save(folder / name)
    return folder / name


@pytest.mark.parametrize("cell", [SIX, 46083.25, "2026-03-02 06:00", "02.03.2026 06:00"])
def test_moments_of_every_kind(tmp_path, cell):
    (trip,) = po.read_trips(book_of(tmp_path, HEAD, ["A", "x", "y", cell, 30]))
    assert trip == po.Trip("A", "x", "y", SIX, flexibility_min=30)


def test_bare_days_count_from_the_epoch_of_the_workbook(tmp_path):
    cells = ["A", "x", "y", 46083.25 - 1462, None]
    (trip,) = po.read_trips(book_of(tmp_path, HEAD, cells, epoch=CALENDAR_MAC_1904))
    assert trip.earliest_departure == SIX


def test_every_minute_of_a_day_is_read_to_the_second(tmp_path):
    rows = [[f"v{k}", "x", "y", 46083 + k / 1440, None] for k in range(1440)]
    trips = po.read_trips(book_of(tmp_path, HEAD, *rows))
    for k, trip in enumerate(trips):
        assert trip.earliest_departure == datetime(2026, 3, 2, k // 60, k % 60)


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        (date(2026, 3, 2), "t.xlsx row 2: earliest_departure = 2026-03-02 must be a day"),
        (time(6), "earliest_departure = 06:00:00 must be a day and a time"),
        (0.25, "0.25 is no day of a spreadsheet"), (-5, "-5 is no day of a spreadsheet"),
        (1e9, "is no day of a spreadsheet"), (True, "must be a day and a time"),
        ("03/02/2026 06:00", "may put the day or the month first"),
        ("=A1", "cell D2: is a formula without its value"),
    ],
)  # fmt: skip
def test_what_is_no_moment(tmp_path, cell, said):
    with pytest.raises(po.ScenarioError) as error:
        po.read_trips(book_of(tmp_path, HEAD, ["A", "x", "y", cell, None]))
    assert said in str(error.value)


def test_numbers_are_shown_as_spreadsheets_show_them(tmp_path):
    trips = po.read_trips(
        book_of(tmp_path, HEAD[:3], [12, "x", "y"], [13.0, "x", "y"], [1.5, 2, 3])
    )
    assert [trip.vehicle for trip in trips] == ["12", "13", "1.5"]
    assert (trips[2].origin, trips[2].destination) == ("2", "3")


@pytest.mark.parametrize("cell", [True, SIX, date(2026, 3, 4)])
def test_a_name_that_the_spreadsheet_made_something_else(tmp_path, cell):
    with pytest.raises(po.ScenarioError, match="format the column as text in the spreadsheet"):
        po.read_trips(book_of(tmp_path, HEAD[:3], [cell, "x", "y"]))


def test_blank_rows_before_between_and_behind(tmp_path):
    rows = [
        [],
        [None, " "],
        HEAD[:3],
        [None] * 3,
        ["A", "x", "y"],
        ["", " ", "\u00a0"],
        ["B", "x", "y"],
    ]
    file = book_of(tmp_path, *rows)
    assert [trip.vehicle for trip in po.read_trips(file)] == ["A", "B"]
    with pytest.raises(po.ScenarioError, match="row 8: destination is empty"):
        po.read_trips(book_of(tmp_path, *rows, ["C", "x"]))


def test_the_first_sheet_or_a_named_one(tmp_path):
    file = book_of(tmp_path, HEAD[:3], ["A", "x", "y"], sheet="Monday")
    book = openpyxl.load_workbook(file)
    for row in (HEAD[:3], ["B", "x", "y"]):
        book.create_sheet("Tuesday") if "Tuesday" not in book.sheetnames else None
        book["Tuesday"].append(row)
    book.create_sheet("Empty")
    book.save(file)
    assert [trip.vehicle for trip in po.read_trips(file)] == ["A"]
    assert [trip.vehicle for trip in po.read_trips(file, "Tuesday")] == ["B"]
    with pytest.raises(po.ScenarioError, match="no sheet 'Sunday'; sheets are Monday, Tuesday, E"):
        po.read_trips(file, "Sunday")
    with pytest.raises(
        po.ScenarioError, match="'Empty' has no rows under its header; name another"
    ):
        po.read_trips(file, "Empty")
    scenario = tmp_path / "s.toml"
    scenario.write_text('network = "n"\ntrips = {file = "t.xlsx", sheet = "Tuesday"}\n')
    from platoon_osm.planning.scenario import read_scenario

    assert [trip.vehicle for trip in read_scenario(scenario).trips] == ["B"]


@pytest.mark.parametrize("sheet", ["", 3, "x"])
def test_a_sheet_of_what_has_none(tmp_path, sheet):
    (tmp_path / "t.csv").write_text("vehicle,origin,destination\nA,x,y\n")
    with pytest.raises(po.ScenarioError, match="sheet"):
        po.read_trips(tmp_path / "t.csv", sheet)


def test_errors_and_formulas_are_told_by_their_cell(tmp_path):
    file = book_of(tmp_path, HEAD[:3], ["A", "x", "y"], ["B", "#N/A", "y"])
    with pytest.raises(po.ScenarioError, match=r"t\.xlsx cell B3: is the error #N/A"):
        po.read_trips(file)
    file = book_of(tmp_path, HEAD[:3], ["A", "x", "y"], ["=A2", "=B2", "=C2"])
    with pytest.raises(po.ScenarioError, match=r"t\.xlsx cell A3: is a formula without its value"):
        po.read_trips(file)


def test_a_formula_with_its_value_counts_as_that(tmp_path):
    """Spreadsheet programs save both; openpyxl writes the formula alone, so it is put in here."""
    file = book_of(tmp_path, HEAD[:3], ["A", "x", "=B9"])
    with zipfile.ZipFile(file) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    page = "xl/worksheets/sheet1.xml"
    before = parts[page]
    parts[page] = before.replace(
        b'<c r="C2"><f>B9</f><v /></c>', b'<c r="C2" t="str"><f>B9</f><v>Monza</v></c>'
    ).replace(b'<c r="C2"><f>B9</f><v/></c>', b'<c r="C2" t="str"><f>B9</f><v>Monza</v></c>')
    assert parts[page] != before
    with zipfile.ZipFile(file, "w") as archive:
        for name, data in parts.items():
            archive.writestr(name, data)
    assert po.read_trips(file) == [po.Trip("A", "x", "Monza")]


def test_without_openpyxl_the_remedy_is_named(tmp_path, monkeypatch):
    file = book_of(tmp_path, HEAD[:3], ["A", "x", "y"])
    true_import = builtins.__import__

    def without(name, *rest, **more):
        if name.split(".")[0] == "openpyxl":
            raise ImportError(name)
        return true_import(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(po.ScenarioError, match=r"install it \(pip install openpyxl\), or save the"):
        po.read_trips(file)


def test_a_workbook_that_unpacks_to_more_than_memory(tmp_path, monkeypatch):
    from platoon_osm.planning.scenario import xlsx_table

    file = book_of(tmp_path, HEAD[:3], ["A", "x", "y"])
    monkeypatch.setattr(xlsx_table, "MOST_UNPACKED_BYTES", 1000)
    with pytest.raises(po.ScenarioError, match=r"unpacks to 0\.0 GB; split it"):
        po.read_trips(file)


def test_damaged_workbooks_are_read_or_told_in_one_line(tmp_path):
    good = book_of(tmp_path, HEAD, ["A", "x", "y", SIX, 30]).read_bytes()
    rng = random.Random(7)
    told = 0
    for _ in range(150):
        data = bytearray(good)
        for _ in range(rng.randint(1, 6)):
            data[rng.randrange(len(data))] = rng.randrange(256)
        file = tmp_path / "damaged.xlsx"
        file.write_bytes(bytes(data[: rng.choice([len(data), rng.randrange(len(data))])]))
        try:
            po.read_trips(file)
        except po.PlatoonError as error:
            told += 1
            text = str(error)
            assert "\n" not in text and len(text) < 400, text  # noqa: PT018 (one claim: a line that can be read)
    assert told > 50


def test_ten_thousand_trips(tmp_path):
    rows = [
        {"vehicle": f"v{k}", "origin": "Torino", "destination": "9.0, 45.0", HEAD[3]: SIX}
        for k in range(10_000)
    ]
    trips = po.read_trips(write_xlsx(tmp_path / "t.xlsx", rows))
    assert len(trips) == 10_000
    assert trips[-1] == po.Trip("v9999", "Torino", (9.0, 45.0), SIX)
