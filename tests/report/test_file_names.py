"""Names of GPX files: as the vehicles are called, safe everywhere, no two alike."""

import re

import pytest
from hostile_names import HOSTILE
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.report.exports.file_names import DEVICES, file_stems


@pytest.mark.parametrize(
    ("name", "stem"),
    [
        ("Torino", "torino"), ("Lkw 3, Köln", "lkw-3-köln"), ("東京 1", "東京-1"),
        ("हिन्दी", "हिन्दी"), ("a/b\\c:d", "a-b-c-d"), ("..", "vehicle"), ("../../etc", "etc"),
        ("CON", "vehicle-con"), ("com1", "vehicle-com1"), ("COM¹", "vehicle-com1"),
        ("con.gpx", "con-gpx"), ("truck. ", "truck"), ("  ", "vehicle"), ("🚚", "vehicle"),
        ("-x-", "x"), ("ﬁx", "fix"), ("a\u202eb", "a-b"), ("\ud800", "vehicle"),
        ("NUL", "vehicle-nul"), ("é", "é"), ("e\u0301", "é"),
    ],
)  # fmt: skip
def test_a_name_is_readable_and_safe(name, stem):
    assert file_stems([name]) == [stem]


def test_collisions_are_numbered_past_names_of_others():
    assert file_stems(["Torino", "torino", "TORINO"]) == ["torino", "torino-2", "torino-3"]
    assert file_stems(["torino", "Torino", "Torino 2"]) == ["torino", "torino-3", "torino-2"]
    assert file_stems(["?", "!", "vehicle 2"]) == ["vehicle", "vehicle-3", "vehicle-2"]
    # One file on systems that fold such letters into one.
    assert file_stems(["straße", "strasse"]) == ["straße", "strasse-2"]


def check(names):
    stems = file_stems(names)
    assert len({stem.casefold() for stem in stems}) == len(names)
    for stem in stems:
        assert re.fullmatch(r"[^\W_][^\x00-\x2c./:-@\[-`{-\x9f]*", stem), stem
        assert not stem.endswith(("-", ".", " "))
        assert stem not in DEVICES
        assert len(stem.encode()) < 200
    return stems


def test_hostile_names():
    check(HOSTILE)


@given(st.lists(st.text(max_size=40), max_size=8))
def test_any_names(names):
    stems = check(names)
    # The last one does not change those before it, unless it owns a number they would take.
    for count in range(len(names)):
        if not any(re.search(r"\d", stem) for stem in stems):
            assert file_stems(names[:count]) == stems[:count]
