"""Nonsense given to the door of all maps ends in one line that says what is wrong."""

import math

import numpy as np
import pytest

from platoon_osm import load_network
from platoon_osm.errors import PlatoonError
from platoon_osm.sources.truck import TruckRules

NONSENSE = {
    "text": "x", "number": 3.5, "minus one": -1, "huge": 10**30, "NaN": math.nan, "dict": {"a": 1},
    "object": object(), "list": [1, "a", None], "set": {9.0, 45.0}, "complex": 1j,
    "bytes": b"italy-motorways", "date": np.datetime64("NaT"), "matrix": np.zeros((2, 2)),
    "function": len, "lines": "a\nb", "infinite": math.inf, "empty": "", "nul": "a\0b",
    "long": "x" * 5_000, "texts": ["a", "b"], "folder": "/", "90 as text": "90",
}  # fmt: skip
ALL = pytest.mark.parametrize("value", NONSENSE.values(), ids=NONSENSE)


def refused(call, *arguments, **options):
    with pytest.raises(PlatoonError) as caught:
        call(*arguments, **options)
    message = str(caught.value)
    assert message
    assert "\n" not in message


@ALL
def test_sources(value):
    refused(load_network, value)


@pytest.mark.parametrize("option", ["country", "limiter_kmh", "infer_links", "classes"])
@ALL
def test_options(option, value):
    if option == "limiter_kmh" and value is NONSENSE["number"]:
        pytest.skip("slow, but a speed")
    refused(load_network, "italy-motorways", **{option: value})


@pytest.mark.parametrize("value", [True, False, (), 0, 3, -90.0, math.nan])
def test_limiters_that_are_none(value):
    if value != 3:
        refused(TruckRules, None, value)


@pytest.mark.parametrize("value", [np.float64(85), np.float32(85), np.int64(85), 85])
def test_numbers_of_numpy_are_numbers(value):
    assert TruckRules("IT", value) == TruckRules("IT", 85.0)
    assert load_network("italy-motorways", limiter_kmh=value).speed_mps.max() * 3.6 < 80.1


def test_a_text_of_numpy_is_a_text():
    assert load_network(np.str_("italy-motorways"), country=np.str_("FR")).m > 0
