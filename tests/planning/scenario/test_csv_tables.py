"""Tables of text: headers, delimiters, quotations, places in one column or several."""

from datetime import datetime

import pytest

import platoon_osm as po


def read(folder, text, name="t.csv"):
    (folder / name).write_text(text, encoding="utf-8", newline="")
    return po.read_trips(folder / name)


HEAD = "vehicle,origin,destination\n"


def test_excel_in_europe(tmp_path):
    (trip,) = read(
        tmp_path,
        "Vehicle ;Origin;Destination lon;DESTINATION-LAT;Destination label;Earliest Departure;"
        "Flexibility min;\r\nLkw 7;Torino;13,77;45,65;Hafen;02.03.2026 06:00;30,5;\r\n;;;;;;;\r\n",
    )
    assert trip == po.Trip(
        "Lkw 7", "Torino", po.Place((13.77, 45.65), label="Hafen"), datetime(2026, 3, 2, 6),
        flexibility_min=30.5,
    )  # fmt: skip


def test_excels_own_line_about_delimiters(tmp_path):
    trips = [po.Trip("A", "x", "y")]
    assert read(tmp_path, "sep=;\r\nvehicle;origin;destination\r\nA;x;y\r\n") == trips
    assert read(tmp_path, '"sep=|"\nvehicle|origin|destination\nA|x|y\n') == trips
    with pytest.raises(po.ScenarioError, match=r"t\.csv line 4: destination is empty"):
        read(tmp_path, "sep=;\nvehicle;origin;destination\nA;x;y\nB;x\n")


def test_lines_are_counted_as_an_editor_counts_them(tmp_path):
    text = f'\n{HEAD}"A\nlong name",x,y\n\n , ,\nB,x\n'
    with pytest.raises(po.ScenarioError, match=r"t\.csv line 7: destination is empty"):
        read(tmp_path, text)


def test_blanks_quotations_and_delimiters_in_cells(tmp_path):
    trips = read(tmp_path, f'{HEAD}  A  ,"Novara Est (A4)","9.2, 45.4"\n"B ""the second""",x;z,y\n')
    assert trips == [
        po.Trip("A", "Novara Est (A4)", (9.2, 45.4)), po.Trip('B "the second"', "x;z", "y"),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("A,Torino,Monza\nB,x,y\n", "line 1 is no header ('A, Torino, Monza')"),
        ("vehicle,origin,destination,colour\nA,x,y,red\n", "unknown column 'colour'; known are"),
        ("vehicle,origin,destination,latest arival\nA,x,y,\n", "did you mean 'latest_arrival'?"),
        ("vehicle,origin,Origin ,destination\nA,x,y,z\n", "column 'origin' stands there twice"),
        ("vehicle,origin_label,destination\nA,x,y\n", "has no column origin; add it"),
        (HEAD + "A,9.2, 45.4,y\n", "line 2 has 4 cells, the header 3; a cell that holds the"),
        ("vehicle,origin,destination,\nA,x,y,z\n", "'z' stands in a column without a title"),
        (HEAD + 'A,"x,y\nB,x,y\n', "line 2: cannot be read (unexpected end of data)"),
        (HEAD + 'A,"x"z,y\n', "line 2: cannot be read"),
        (HEAD + "A,x,y\nB,x,y\nA,x,z\n", "line 4: vehicle 'A' has a trip already (t.csv line 2)"),
        (HEAD + f"A,{'x' * 200_000},y\n", "line 2: cannot be read (field larger than"),
        (HEAD + ' ,x,y\n', "line 2: vehicle is empty"),
        (HEAD + 'A,"10,22",y\n', "line 2: origin: place '10,22': may be one number or two"),
        (HEAD + 'A,45.5 N 10.2 E,y\n', "line 2: origin: place '45.5 N 10.2 E': write longitude"),
        ("vehicle,origin_lon,destination\nA,9,y\n", "line 2: origin_lat is empty"),
        ("vehicle,origin_lon,origin_lat,destination\nA,9 E,45,y\n", "origin_lon = '9 E' must be a"),
        ("vehicle,origin_lon,origin_lat,destination\nA,1.234.5,45,y\n", "must be a number of degr"),
        ("vehicle,origin,origin_osmid,destination\nA,x,7,y\n", "origin and origin_osmid both say"),
        ("vehicle,origin_osmid,destination\nA,7.5,y\n", "origin_osmid = '7.5' must be a whole"),
        ("vehicle,origin_osmid,destination\nA,x,y\n", "origin_osmid = 'x' must be a whole number"),
        ("vehicle,origin,destination,flexibility_min\nA,x,y,1:30\n", "must be a number of minutes"),
        ("vehicle,origin,destination,flexibility_min\nA,x,y,30\n", "line 2: trip 'A': flexibility"),
        ("vehicle,origin,destination,latest_arrival\nA,x,y,03/02/2026 6:00\n", "the day or the"),
        (
            "vehicle,origin,destination,latest_arrival\nA,x,y,2026-03-02 06:00Z\n"
            "B,x,y,2026-03-02 06:00\n",
            "give all times of a plan with their zone or none",
        ),
    ],
)  # fmt: skip
def test_each_mistake_in_one_line_with_its_place(tmp_path, text, said):
    with pytest.raises(po.ScenarioError) as error:
        read(tmp_path, text)
    assert said in str(error.value)
    assert "t.csv" in str(error.value)
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 400


@pytest.mark.parametrize(
    "cell",
    ["=cmd|' /C calc'!A0", "<script>alert(1)</script>", "'; DROP TABLE trips; --", "\u202eabc",
     "\U0001f69a", "a" * 5000, "%s%n", "../../etc", "\x1b[31mred", "{0}"],
)  # fmt: skip
def test_hostile_cells_are_names_and_nothing_else(tmp_path, cell):
    rows = f'{HEAD}"{cell}","{cell}",y\n'
    (trip,) = read(tmp_path, rows)
    assert (trip.vehicle, trip.origin) == (cell, cell)


def test_ten_thousand_trips_are_read(tmp_path):
    rows = "".join(
        f"v{k};9,{k:04d};45,5;Monza;02.03.2026 06:{k % 60:02d};30\r\n" for k in range(10_000)
    )
    head = "vehicle;origin_lon;origin_lat;destination;earliest_departure;flexibility_min\r\n"
    trips = read(tmp_path, head + rows)
    assert len(trips) == 10_000
    assert trips[777].origin == (9.0777, 45.5)
