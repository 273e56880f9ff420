"""Records as plain JSON types, and groups of linked vehicles, against slower ways to the same."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.plans.plain import plain
from platoon_osm.plans.stretches import linked


@dataclass(frozen=True, slots=True)
class _Inner:
    name: str
    values: tuple[float | None, ...]


@dataclass(frozen=True)
class _Outer:
    inner: tuple[_Inner, ...]
    params: dict[Any, Any]
    anything: Any = None


LEAVES = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(allow_nan=False),
    st.text(st.characters(codec=None, exclude_categories=())),
)  # fmt: skip
INNER = st.builds(_Inner, st.text(), st.lists(st.one_of(st.none(), st.floats(allow_nan=False))
                                              ).map(tuple))  # fmt: skip
TREES = st.recursive(
    st.one_of(LEAVES, INNER),
    lambda own: st.one_of(
        st.lists(own), st.lists(own).map(tuple), st.dictionaries(st.text(), own),
        st.dictionaries(st.integers(), own),
    ),
    max_leaves=12,
)  # fmt: skip


@given(st.builds(_Outer, st.lists(INNER).map(tuple), st.dictionaries(st.text(), TREES), TREES))
def test_records_are_what_json_reads_back(record: _Outer) -> None:
    told = plain(record)
    slow = json.loads(json.dumps(asdict(record)))
    assert told == slow
    assert json.dumps(told) == json.dumps(slow)


def test_halves_of_a_character_become_one_as_in_json() -> None:
    halves = "\ud83d" + "\ude00"
    assert plain([halves, {halves: 1}]) == ["\U0001f600", {"\U0001f600": 1}]


def test_numbers_of_numpy_become_numbers_of_python() -> None:
    told = plain(_Inner("x", (np.float64(1.5), math.inf)))
    assert type(told["values"][0]) is float
    assert told["values"] == [1.5, math.inf]


def test_nothing_is_shared_with_the_record() -> None:
    record = _Outer((), {"a": [1, [2]]})
    plain(record)["params"]["a"][1].append(3)
    assert record.params == {"a": [1, [2]]}


def test_what_json_has_no_type_for_is_refused() -> None:
    with pytest.raises(TypeError):
        plain(_Outer((), {}, {1, 2}))


@given(st.integers(1, 12).flatmap(
    lambda n: st.tuples(st.just(n), st.lists(st.lists(st.integers(0, n - 1), min_size=1)))
))  # fmt: skip
def test_groups_are_those_that_sets_grow_to(drawn: tuple[int, list[list[int]]]) -> None:
    vehicles, companies = drawn
    groups = [{index} for index in range(vehicles)]
    grown = True
    while grown:
        grown = False
        for company in companies:
            for group in groups:
                if group & set(company) and not group >= set(company):
                    group |= set(company)
                    grown = True
    assert linked(companies, vehicles) == tuple(sorted({tuple(sorted(one)) for one in groups}))
