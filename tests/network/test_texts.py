"""The table of names."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.network.texts import TextTable, encode_texts

TEXTS = st.text(st.characters(exclude_categories=["Cs"]), max_size=8)


@given(st.lists(TEXTS))
def test_strings_come_back(strings):
    table = TextTable.from_strings(strings)
    assert len(table) == len(strings)
    assert list(table) == strings
    assert [table[i] for i in range(len(strings))] == strings
    assert table[:] == strings
    assert table[1::2] == strings[1::2]


@given(st.lists(TEXTS, max_size=6), st.lists(TEXTS, max_size=6))
def test_columns_share_codes(one, other):
    table, (a, b) = encode_texts(one, other)
    assert table[0] == ""
    assert [table[code] for code in a] == one
    assert [table[code] for code in b] == other
    assert len(set(table)) == len(table) == len({"", *one, *other})
    assert a.dtype == b.dtype == np.int32


def test_positions_count_from_both_ends_and_no_further():
    table = TextTable.from_strings(["a", "bé", "😀"])
    assert (table[-1], table[-3], table[np.int32(1)]) == ("😀", "a", "bé")
    for outside in (3, -4):
        with pytest.raises(IndexError):
            table[outside]


def test_broken_input_is_replaced_instead_of_an_error():
    assert list(TextTable.from_strings(["a\udcffb"])) == ["a\ufffdb"]
    assert TextTable(np.array([0, 2]), np.array([65, 255], np.uint8))[0] == "A�"


def test_equal_tables_are_equal_and_hash_alike():
    one, other = (TextTable.from_strings(["a", "b"]) for _ in range(2))
    assert one == other
    assert hash(one) == hash(other)
    assert one != TextTable.from_strings(["ab", ""])
    assert one != ["a", "b"]


def test_read_only():
    table = TextTable.from_strings(["a", "b"])
    with pytest.raises(ValueError, match="read-only"):
        table.offsets[0] = 1
    with pytest.raises(ValueError, match="read-only"):
        table.blob[0] = 1
