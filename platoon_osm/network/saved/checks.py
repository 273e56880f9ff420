"""What must hold in a saved network before its arrays are trusted as positions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..road_network import POINT_KINDS, ROAD_CLASSES

__all__ = ["check_arrays"]

Arrays = Mapping[str, NDArray[Any]]

PER_NODE = {"lon": "f8", "lat": "f8", "node_id": "i8", "node_name": "i4", "node_ref": "i4"}
PER_EDGE = {
    "tail": "i4", "head": "i4", "length_m": "f8", "speed_mps": "f8", "road_class": "u1",
    "ref": "i4", "name": "i4", "toll": "b1", "inferred": "b1", "way_id": "i8",
}  # fmt: skip
PER_POINT = {
    "points.lon": "f8", "points.lat": "f8", "points.kind": "u1", "points.name": "i4",
    "points.population": "i8",
}  # fmt: skip
PER_SHAPE_POINT = {"shape_lon": "f8", "shape_lat": "f8"}


def check_arrays(arrays: Arrays) -> None:
    """Check types and sizes, and that everything used as a position points somewhere.

    Only arrays of positions are read, with one or two passes each; lengths, speeds and
    coordinates stay on disk.

    Raises
    ------
    ValueError
        In a few words: which array is wrong.
    KeyError
        An array is missing.
    """
    n, m = len(arrays["lon"]), len(arrays["tail"])
    _typed(arrays, PER_NODE, n)
    _typed(arrays, PER_EDGE, m)
    _typed(arrays, PER_POINT, len(arrays["points.lon"]))
    _typed(arrays, PER_SHAPE_POINT, len(arrays["shape_lon"]))
    _typed(arrays, {"first_out": "i4"}, n + 1)
    _typed(arrays, {"shape_first": "i8"}, m + 1)
    _typed(arrays, {"texts.offsets": "i8"}, max(len(arrays["texts.offsets"]), 2))
    _typed(arrays, {"texts.blob": "u1"}, len(arrays["texts.blob"]))
    _rising(arrays, "first_out", m, step=0)
    _rising(arrays, "shape_first", len(arrays["shape_lon"]), step=2)
    _rising(arrays, "texts.offsets", len(arrays["texts.blob"]), step=0)
    _within(arrays, "head", n)
    leaving = np.diff(arrays["first_out"])
    if not np.array_equal(arrays["tail"], np.repeat(np.arange(n, dtype=np.int32), leaving)):
        raise ValueError("tail does not fit first_out")
    texts = len(arrays["texts.offsets"]) - 1
    for name in ("node_name", "node_ref", "ref", "name", "points.name"):
        _within(arrays, name, texts)
    _within(arrays, "road_class", len(ROAD_CLASSES))
    _within(arrays, "points.kind", len(POINT_KINDS))
    for name in ("toll", "inferred"):
        # A byte other than 0 and 1 would be neither true nor false.
        if (arrays[name].view(np.uint8) > 1).any():
            raise ValueError(f"{name} holds values that are no truth values")


def _typed(arrays: Arrays, types: Mapping[str, str], size: int) -> None:
    for name, dtype in types.items():
        array = arrays[name]
        if array.dtype != np.dtype(dtype).newbyteorder("<") or array.shape != (size,):
            raise ValueError(
                f"{name} is {array.dtype} of shape {array.shape}, not {dtype} ({size},)"
            )


def _rising(arrays: Arrays, name: str, last: int, step: int) -> None:
    values = arrays[name]
    # Compared, not subtracted: a difference of damaged numbers might wrap round.
    steady = (values[1:] >= values[:-1]).all() and values[0] == 0 and values[-1] == last
    if not steady or (step and (np.diff(values) < step).any()):
        raise ValueError(f"{name} does not rise from 0 to {last}")


def _within(arrays: Arrays, name: str, count: int) -> None:
    values = arrays[name]
    if len(values) and not (values.min() >= 0 and values.max() < count):
        raise ValueError(f"{name} points beyond its {count} entries")
