"""Tables of vehicles that must not drive together."""

import re

import pytest

from platoon_osm.errors import PlatoonError
from platoon_osm.fleets.apart_table import read_apart


@pytest.mark.parametrize(
    "text",
    ["a,b\nc,d\n", "vehicle,apart_from\na,b\n\nc,d\n", "a;b\nc;d\n", 'Vehicle\tx\n"a"\tb\nc\td\n'],
)
def test_two_columns_of_names(tmp_path, text):
    path = tmp_path / "apart.csv"
    path.write_text(text)
    assert read_apart(path) == (("a", "b"), ("c", "d"))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a,b\nc\n", "apart.csv line 2: 'c' is no pair; give two vehicles a row"),
        ("a,b,c\n", "line 1: 'a, b, c' is no pair"),
    ],
)
def test_refused_in_one_line(tmp_path, text, said):
    path = tmp_path / "apart.csv"
    path.write_text(text)
    with pytest.raises(PlatoonError, match=re.escape(said)):
        read_apart(path)
