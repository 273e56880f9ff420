"""Files as Windows, PowerShell, Excel and word processors save them, and what is no text at all."""

import io
import os
import threading
import zipfile

import openpyxl
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from trip_files import write_gpkg, write_xlsx

import platoon_osm as po
from platoon_osm.planning.scenario import read_scenario

TABLE = "vehicle,origin,destination\nM\u00fcller,Torino,Forl\u00ec\n"
TRIPS = [po.Trip("M\u00fcller", "Torino", "Forl\u00ec")]
TOML = (
    'network = "n"\n[[trips]]\nvehicle = "M\u00fcller"\norigin = "Torino"\n'
    'destination = "Forl\u00ec"\n'
)


def put(folder, name, data):
    (folder / name).write_bytes(data)
    return folder / name


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32"]
)
@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r"])
def test_unicode_of_every_kind(tmp_path, encoding, ends):
    for mark in ("", "\ufeff") if encoding.endswith(("-le", "-be")) else ("",):
        table = put(tmp_path, "t.csv", (mark + TABLE.replace("\n", ends)).encode(encoding))
        assert po.read_trips(table) == TRIPS
        scenario = put(tmp_path, "s.toml", (mark + TOML.replace("\n", ends)).encode(encoding))
        assert list(read_scenario(scenario).trips) == TRIPS


@pytest.mark.parametrize("encoding", ["cp1252", "latin-1", "cp1250"])
def test_windows_1252_is_named_with_its_line(tmp_path, encoding):
    text = TABLE.replace("\u00ec", "i")
    with pytest.raises(po.ScenarioError) as error:
        po.read_trips(put(tmp_path, "t.csv", text.encode(encoding)))
    said = str(error.value)
    assert said.startswith(f"{tmp_path / 't.csv'}: line 2 is not UTF-8 but, it seems, Windows-1252")
    assert "M\u00fcller" in said
    assert 'save the file as UTF-8 (in Excel as "CSV UTF-8")' in said
    with pytest.raises(po.ScenarioError, match="line 3 is not UTF-8 but, it seems, Windows-1252"):
        read_scenario(put(tmp_path, "s.toml", TOML.replace("\u00ec", "i").encode(encoding)))


def test_bytes_of_no_encoding(tmp_path):
    with pytest.raises(po.ScenarioError, match="line 2 is not UTF-8; save the file as UTF-8"):
        po.read_trips(put(tmp_path, "t.csv", b"vehicle,origin,destination\nA\x81\xfe,x,y\n"))


def test_a_file_that_was_cut_short(tmp_path):
    whole = TABLE.encode()
    cut = whole[: whole.index("\u00ec".encode()) + 1]
    with pytest.raises(po.ScenarioError, match="line 2 ends in the middle of a character"):
        po.read_trips(put(tmp_path, "t.csv", cut))
    with pytest.raises(po.ScenarioError, match="begins as UTF-16 text and breaks off"):
        po.read_trips(put(tmp_path, "t.csv", TABLE.encode("utf-16")[:-1]))


def test_folders_and_files_that_are_not_there(tmp_path):
    for read in (po.read_trips, read_scenario):
        with pytest.raises(po.ScenarioError, match="cannot be read, it is a folder; name a "):
            read(tmp_path)
        with pytest.raises(po.ScenarioError, match=r"none.x: cannot be read \(No such file"):
            read(tmp_path / "none.x")
        for wrong in (None, 3, "", b"x", [], "a\0b"):
            with pytest.raises(po.ScenarioError):
                read(wrong)


@pytest.mark.parametrize("kind", ["csv", "xlsx", "gpkg", "toml"])
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with a name")
def test_what_comes_through_a_pipe_is_read_once(tmp_path, kind):
    rows = [{"vehicle": "M\u00fcller", "origin": "Torino", "destination": "Forl\u00ec"}]
    file = put(tmp_path, "t.csv", TABLE.encode())
    if kind == "toml":
        file = put(tmp_path, "t.toml", TOML.encode())
    elif kind != "csv":
        file = {"xlsx": write_xlsx, "gpkg": write_gpkg}[kind](tmp_path / f"t.{kind}", rows)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_bytes, args=[file.read_bytes()])
    writer.start()
    read = read_scenario(pipe).trips if kind == "toml" else po.read_trips(pipe)
    writer.join(10)
    assert list(read) == TRIPS


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_file_that_may_not_be_read(tmp_path):
    file = put(tmp_path, "t.csv", b"x")
    file.chmod(0)
    with pytest.raises(po.ScenarioError, match="Permission denied"):
        po.read_trips(file)


def zipped():
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w") as archive:
        archive.writestr("trips.csv", TABLE)
    return memory.getvalue()


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" * 100, "old Excel, or one with a password"),
        (b"%PDF-1.7\n\x80", "is a PDF document by its content"),
        (b"\x1f\x8b\x08\x00", "is a file packed with gzip by its content"),
        (b'<?xml version="1.0"?><osm/>', "is an XML file, such as a map by its content"),
        (b"\xef\xbb\xbf<!DOCTYPE html><html>", "is a web page by its content"),
        (b"vehicle,origin,destination\nA,\x00,y\n", "line 2 holds binary data"),
        (b"\x7fELF\x02\x01\x01\x00\x00", "holds binary data"),
        (b"PK\x03\x04 and no more", "not a workbook, or damaged"),
        (zipped(), "is a zip archive, no workbook"),
        (b"SQLite format 3\x00 and no more", "not a GeoPackage that can be read"),
    ],
)
def test_what_is_no_table(tmp_path, data, said):
    with pytest.raises(po.ScenarioError) as error:
        po.read_trips(put(tmp_path, "t.csv", data))
    assert said in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("t.toml", "is a scenario, not a table of trips"), ("t.xls", "save it as .xlsx"),
        ("t.ODS", "is an OpenDocument sheet; save it as .xlsx or CSV"),
        ("t.xlsx", "is not a workbook by its content"), ("t.GPKG", "is not a GeoPackage by its"),
    ],
)  # fmt: skip
def test_names_of_other_files(tmp_path, name, said):
    with pytest.raises(po.ScenarioError, match=said):
        po.read_trips(put(tmp_path, name, TABLE.encode()))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("t.csv", "is a table of trips, not a scenario; give it as --trips"),
        ("t.XLSX", "is a table of trips"), ("m.osm.pbf", "is a map, not a scenario"),
        ("m.platoon", "is a map, not a scenario; give it as --network"),
    ],
)  # fmt: skip
def test_what_is_no_scenario_by_its_name(tmp_path, name, said):
    with pytest.raises(po.ScenarioError, match=said):
        read_scenario(put(tmp_path, name, TOML.encode()))


def test_a_workbook_called_toml(tmp_path):
    openpyxl.Workbook().save(tmp_path / "x.xlsx")
    with pytest.raises(po.ScenarioError, match="is a workbook or another zip archive by its"):
        read_scenario((tmp_path / "x.xlsx").rename(tmp_path / "x.toml"))


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (r'network = "C:\Users\u\maps\m.osm"', "a backslash in double quotes begins an escape"),
        (r'network = "C:\new\table.osm"', "a backslash in double quotes begins an escape"),
        (r'network = "C:\temp\"', "a backslash in double quotes begins an escape"),
        (r'network = "maps\x.osm"', "line 1"),
        ("network = \u201cn\u201d", "it has curly quotation marks; write straight ones"),
        ("network = \u201en\u201c", "it has curly quotation marks"),
        ("network = italy", "texts stand in double quotes"),
        ("network: italy", "line 1"),
        ("network = ", "line 1"),
        ("= 3", "line 1"),
        ("a = " + "[" * 5000, "brackets nest too deeply"),
        ("a = " + "9" * 5000, "not a TOML file"),
    ],
)
def test_slips_in_toml_name_line_and_remedy(tmp_path, line, said):
    rest = TOML.split("\n", 1)[1]
    with pytest.raises(po.ScenarioError) as error:
        read_scenario(put(tmp_path, "s.toml", f"{line}\n{rest}".encode()))
    assert said in str(error.value)
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 400


def test_a_path_of_windows_in_single_quotes(tmp_path):
    (tmp_path / "maps").mkdir()
    put(tmp_path / "maps", "m.osm", b"<osm/>")
    put(tmp_path / "maps", "t.csv", TABLE.encode())
    for network in ("'maps\\m.osm'", '"maps\\\\m.osm"', '"maps/m.osm"'):
        text = f"network = {network}\ntrips = 'maps\\t.csv'\n"
        scenario = read_scenario(put(tmp_path, "s.toml", text.encode()))
        assert scenario.network["source"] == str(tmp_path / "maps" / "m.osm")
        assert list(scenario.trips) == TRIPS


LITTLE = settings(
    max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def said_of(read, file):
    """Return what is said of a file; nothing if it is read."""
    try:
        read(file)
    except po.PlatoonError as error:
        return str(error)
    return ""


@LITTLE
@given(st.binary(max_size=200), st.sampled_from(["", TABLE, TOML]), st.integers(0, 100))
def test_whatever_a_file_holds_is_read_or_told_in_one_line(tmp_path, data, text, at):
    good = text.encode()
    file = put(tmp_path, "any", good[:at] + data + good[at:])
    for read in (po.read_trips, read_scenario):
        said = said_of(read, file)
        assert "\n" not in said
        assert len(said) < 500
