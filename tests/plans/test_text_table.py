"""Names in text: columns stay straight, lines stay lines, and nothing runs on for ever."""

import unicodedata

import pytest
from hostile_names import HOSTILE
from hypothesis import given
from hypothesis import strategies as st
from random_networks import network

import platoon_osm as po
from platoon_osm.plans.text_table import listed, named, table_lines, width_of


def test_widths():
    assert width_of("Köln") == 4
    assert width_of("東京") == 4
    assert width_of("e\u0301\u200b") == 1
    assert named("a\nb\tc") == "a b c"
    assert "\x1b" not in named("\x1b[31m")
    assert "\u202e" not in named("a\u202eb")
    assert width_of(named("W" * 3000)) <= 40


def test_lists():
    names = [f"v{k}" for k in range(507)]
    assert listed(names[:1]) == "v0"
    assert listed(names[:3]) == "v0, v1 and v2"
    assert listed(names) == "v0, v1, v2, v3, v4, v5, v6, v7 and 499 more"


@given(st.lists(st.tuples(st.text(max_size=60), st.text(max_size=9)), min_size=1, max_size=6))
def test_any_cells_stand_below_each_other(cells):
    rows = [(named(left), named(right)) for left, right in cells]
    lines = table_lines(rows, {1})
    assert all(line.splitlines() in ([line], []) for line in lines)
    widest = max(map(width_of, lines))
    assert all(width_of(line) == widest for line, row in zip(lines, rows, strict=True) if row[1])


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 5))
def test_hostile_names_in_a_summary(start):
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    names = [name for name in HOSTILE[start : start + 5] if name.strip()]
    trips = [po.Trip(f"{k}{name}", 0, 3) for k, name in enumerate(names)]
    text = po.plan_joint(net, po.paper_weights(net), trips, "C").summary()
    # Joiners and marks of direction take no room; emoji and Arabic need them.
    kinds = {unicodedata.category(c) for c in text if c != "\n" and not c.isprintable()}
    assert kinds <= {"Cf", "Co", "Cn"}
    lines = text.splitlines()
    rules = [at for at, line in enumerate(lines) if line and set(line) == {"-"}]
    assert len(rules) == 2
    assert rules[1] - rules[0] == len(names) + 1
    table = [*lines[rules[0] + 1 : rules[1]], lines[rules[1] + 1]]
    assert {width_of(line) for line in table} == {len(lines[rules[0]])}


def test_hundreds_of_vehicles_are_a_page():
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    trips = [po.Trip(f"truck {k}", 0 if k % 2 else 4, 3) for k in range(504)]
    text = po.plan_joint(net, po.paper_weights(net), trips, "C", master="truck 1").summary()
    assert len(text) < 8000
    assert "and 492 more" in text
    assert "more such lines" in text
