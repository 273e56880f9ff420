"""Random trips, as TOML, CSV in many dialects, workbooks and GeoPackages, are read back equal."""

from datetime import datetime, timedelta, timezone

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from trip_files import as_csv, as_toml, rows_of, write_gpkg, write_xlsx

import platoon_osm as po
from platoon_osm.driving.state import DriverState
from platoon_osm.errors import NetworkError
from platoon_osm.network.coordinate_text import coordinates_in
from platoon_osm.network.location import Place
from platoon_osm.planning.scenario import read_scenario

OFTEN = settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)

# Letters, digits, marks and blanks of all scripts; control characters are tried elsewhere.
LETTERS = st.characters(categories=("L", "Nd", "P", "S"), codec="utf-8")
WORDS = st.text(st.one_of(LETTERS, st.sampled_from(" ,;\"'|=+-@")), min_size=1, max_size=12)


def is_name(text):
    try:
        return coordinates_in(text) is None
    except NetworkError:
        return False


TEXTS = WORDS.map(str.strip).filter(lambda text: text and "_x" not in text)
NAMES = TEXTS.filter(is_name)
DEGREES = st.tuples(
    st.floats(-180, 180).map(lambda x: round(x, 6)), st.floats(-90, 90).map(lambda x: round(x, 6))
)
PLACES = st.one_of(
    NAMES,
    DEGREES,
    st.builds(Place, st.one_of(NAMES, DEGREES), label=TEXTS),
    st.builds(lambda osmid: Place(osmid=osmid), st.integers(1, 2**53)),
    st.builds(lambda osmid, label: Place(osmid=osmid, label=label), st.integers(1, 2**53), TEXTS),
)
FIRST = datetime(2026, 3, 2)
ZONED = st.booleans()
SECONDS = st.integers(0, 7 * 86_400)


QUARTERS = st.integers(0, 20)


@st.composite
def drivers(draw):
    """Return what a driver has behind it, in quarters of an hour."""
    if draw(st.booleans()):
        return DriverState()
    since, today, duty, *weeks = (900.0 * draw(QUARTERS) for _ in range(6))
    return DriverState(
        driven_since_break_s=since, driven_today_s=since + today, duty_s=since + today + duty,
        first_part_taken=draw(st.booleans()), driven_this_week_s=weeks[0],
        driven_last_week_s=weeks[1], since_weekly_rest_s=weeks[2],
        long_days_used=draw(st.integers(0, 2)), reduced_rests_used=draw(st.integers(0, 3)),
        drivers=draw(st.integers(1, 2)),
    )  # fmt: skip


@st.composite
def trips(draw):
    """Return trips with or without times; all times have a zone or none has."""
    zone = timezone(timedelta(minutes=30 * draw(st.integers(-24, 24)))) if draw(ZONED) else None
    found = []
    for vehicle in draw(st.lists(TEXTS, min_size=1, max_size=4, unique=True)):
        begin = draw(SECONDS)
        early = (FIRST + timedelta(seconds=begin)).replace(tzinfo=zone)
        later = [early + timedelta(seconds=1 + draw(SECONDS)) for _ in range(2)]
        times = {}
        if draw(st.booleans()):
            times["latest_departure"] = later[0]
        kind = draw(st.sampled_from(["none", "early", "arrival", "both", "flexible"]))
        if kind in ("early", "both", "flexible"):
            times["earliest_departure"] = early
        if kind in ("arrival", "both"):
            times["latest_arrival"] = later[1]
        if kind == "flexible":
            times["flexibility_min"] = draw(st.floats(0, 1e5).map(lambda x: round(x, 3)))
        ends = draw(PLACES), draw(PLACES)
        found.append(po.Trip(vehicle, *ends, **times, driver=draw(drivers())))
    return found


@OFTEN
@given(trips())
def test_toml(tmp_path, asked):
    file = tmp_path / "s.toml"
    file.write_text(as_toml(asked), encoding="utf-8")
    assert list(read_scenario(file).trips) == asked


ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32")


@OFTEN
@given(
    trips(),
    st.sampled_from(",;\t|"),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from(ENCODINGS),
    st.booleans(),
    st.booleans(),
    st.booleans(),
)
def test_csv_in_many_dialects(tmp_path, asked, delimiter, ends, encoding, comma, titled, blank):
    def number(value):
        return repr(value).replace(".", ",") if comma else repr(value)

    def german(at):
        return f"{at:%d.%m.%Y %H:%M:%S}"

    has_zone = any(at.tzinfo for trip in asked for at in trip.times.values())
    moment = german if comma and not has_zone else datetime.isoformat
    title = (lambda text: f" {text.replace('_', ' ').title()} ") if titled else str
    text = as_csv(rows_of(asked, number, moment), delimiter, ends, title)
    if blank:
        head, _, rest = text.partition(ends)
        # What spreadsheets leave of rows whose cells were emptied.
        text = head + ends + delimiter * 2 + ends + " " + ends + rest + delimiter + ends
    file = tmp_path / "t.csv"
    file.write_bytes(text.encode(encoding))
    assert po.read_trips(file) == asked


@OFTEN
@given(trips(), st.booleans())
def test_workbooks(tmp_path, asked, as_dates):
    has_zone = any(at.tzinfo for trip in asked for at in trip.times.values())
    # Dates of a spreadsheet have no zone; with one they are text.
    moment = (lambda at: at) if as_dates and not has_zone else datetime.isoformat
    file = write_xlsx(tmp_path / "t.xlsx", rows_of(asked, lambda value: value, moment))
    assert po.read_trips(file) == asked


@settings(OFTEN, max_examples=25)
@given(trips())
def test_geopackages(tmp_path, asked):
    has_zone = any(at.tzinfo for trip in asked for at in trip.times.values())
    rows = rows_of(asked, lambda value: value, datetime.isoformat if has_zone else lambda at: at)
    # A column of a layer has one kind; ids of nodes beside blanks would be read as fractions.
    assume(all(isinstance(row.get("vehicle"), str) for row in rows))
    file = tmp_path / "t.gpkg"
    file.unlink(missing_ok=True)
    write_gpkg(file, rows)
    assert po.read_trips(file) == asked


@pytest.mark.parametrize("suffix", [".CSV", ".Xlsx", ".GPKG", ".TSV", ".txt", ""])
def test_suffixes_in_any_case_and_by_content(tmp_path, suffix):
    asked = [po.Trip("A", "Torino", "Monza"), po.Trip("B", (9.0, 45.0), "Belluno")]
    file = tmp_path / f"T{suffix}"
    if suffix == ".Xlsx":
        write_xlsx(tmp_path / "t.xlsx", rows_of(asked)).rename(file)
    elif suffix == ".GPKG":
        write_gpkg(tmp_path / "t.gpkg", rows_of(asked)).rename(file)
    else:
        file.write_text(as_csv(rows_of(asked)))
    assert po.read_trips(file) == asked


def test_what_is_named_csv_and_is_a_workbook_is_read(tmp_path):
    asked = [po.Trip("A", "Torino", "Monza")]
    write_xlsx(tmp_path / "t.xlsx", rows_of(asked)).rename(tmp_path / "t.csv")
    assert po.read_trips(tmp_path / "t.csv") == asked
    write_gpkg(tmp_path / "u.gpkg", rows_of(asked)).rename(tmp_path / "u.csv")
    assert po.read_trips(tmp_path / "u.csv") == asked
