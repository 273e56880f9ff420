"""What must hold in a saved network before its arrays are trusted as positions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..columns import columns_per

__all__ = ["check_arrays"]

Arrays = Mapping[str, NDArray[Any]]

DTYPES = {column.name: column.dtype for column in columns_per("offset")}
DTYPES |= {"texts.offsets": "i8", "texts.blob": "u1"}


def check_arrays(arrays: Arrays) -> None:
    """Check types and sizes, and that everything used as a position points somewhere.

    Only arrays of positions are read, with one or two passes each; lengths, speeds and
    coordinates stay on disk.

    Parameters
    ----------
    arrays : mapping of str to ndarray
        By the names of the table of columns, with "texts.offsets" and "texts.blob".

    Raises
    ------
    ValueError
        In a few words: which array is wrong.
    KeyError
        An array is missing.
    """
    n, m = len(arrays["lon"]), len(arrays["tail"])
    texts = max(len(arrays["texts.offsets"]) - 1, 1)
    sizes = {"node": n, "edge": m}
    sizes |= {"shape point": len(arrays["shape_lon"]), "named point": len(arrays["points.lon"])}
    counts = {"nodes": n, "texts": texts}
    for column in columns_per("node", "edge", "shape point", "named point"):
        _typed(arrays, column.name, column.dtype, sizes[column.per])
    for name, last, step, rows in (
        ("first_out", m, 0, n), ("shape_first", sizes["shape point"], 2, m),
        ("texts.offsets", len(arrays["texts.blob"]), 0, texts),
    ):  # fmt: skip
        _typed(arrays, name, DTYPES[name], rows + 1)
        _rising(arrays, name, last, step)
    _typed(arrays, "texts.blob", DTYPES["texts.blob"], len(arrays["texts.blob"]))
    leaving = np.diff(arrays["first_out"])
    if not np.array_equal(arrays["tail"], np.repeat(np.arange(n, dtype=np.int32), leaving)):
        raise ValueError("tail does not fit first_out")
    for column in columns_per("node", "edge", "named point"):
        # That tails are nodes follows from first_out.
        if column.codes and column.name != "tail":
            codes = column.codes
            count = counts[codes] if isinstance(codes, str) else len(codes)
            _within(arrays, column.name, count)
        # A byte other than 0 and 1 would be neither true nor false.
        if column.dtype == "b1" and (arrays[column.name].view(np.uint8) > 1).any():
            raise ValueError(f"{column.name} holds values that are no truth values")


def _typed(arrays: Arrays, name: str, dtype: str, size: int) -> None:
    array = arrays[name]
    if array.dtype != np.dtype(dtype).newbyteorder("<") or array.shape != (size,):
        raise ValueError(f"{name} is {array.dtype} of shape {array.shape}, not {dtype} ({size},)")


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
