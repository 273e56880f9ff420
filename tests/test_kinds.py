"""Numbers as people mean them, and what other values are called."""

from __future__ import annotations

import numpy as np
import pytest

from platoon_osm.kinds import is_number, is_whole, kind_of


@pytest.mark.parametrize(
    ("value", "number", "whole"),
    [(1, True, True), (1.0, True, False), (float("nan"), True, False), (True, False, False),
     ("1", False, False), (None, False, False), (np.array([1]), False, False)],
)  # fmt: skip
def test_true_and_false_are_no_numbers(value, number, whole):
    assert is_number(value) is number
    assert is_whole(value) is whole


def test_a_class_is_called_a_class():
    assert kind_of(list) == "class"
    assert kind_of([]) == "list"
