"""Columns of whole numbers, read from what anybody may have written."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError, brief
from ...kinds import is_whole, kind_of

__all__ = ["MOST", "as_column", "column", "flag", "part", "starts_of", "whole"]

Ints = NDArray[np.int64]

MOST = 2**50
"""Instants and costs lie within this, so that sums of some hundred stay whole numbers."""


def part(told: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """Return an object inside another.

    Parameters
    ----------
    told : mapping
        The outer one.
    name : str
        Of the inner one.

    Returns
    -------
    mapping
        The inner one.

    Raises
    ------
    ScenarioError
        There is none.
    """
    inner = _value(told, name)
    if not isinstance(inner, dict):
        raise _wrong(name, inner, "an object")
    return inner


def whole(told: Mapping[str, Any], name: str, low: int = -MOST, high: int = MOST) -> int:
    """Return a whole number.

    Parameters
    ----------
    told : mapping
        Where it stands.
    name : str
        Its name.
    low, high : int
        Least and greatest that is allowed.

    Returns
    -------
    int
        The number.

    Raises
    ------
    ScenarioError
        It is missing, no whole number, or out of range.
    """
    value = _value(told, name)
    if not is_whole(value) or not low <= value <= high:
        raise _wrong(name, value, f"a whole number from {low} to {high}")
    return value


def flag(told: Mapping[str, Any], name: str) -> bool:
    """Return true or false.

    Parameters
    ----------
    told : mapping
        Where it stands.
    name : str
        Its name.

    Returns
    -------
    bool
        The value.

    Raises
    ------
    ScenarioError
        It is missing, or neither.
    """
    value = _value(told, name)
    if not isinstance(value, bool):
        raise _wrong(name, value, "true or false")
    return value


def column(
    told: Mapping[str, Any],
    name: str,
    size: int | None = None,
    low: int = -MOST,
    high: int = MOST,
) -> Ints:
    """Return a list of whole numbers.

    Parameters
    ----------
    told : mapping
        Where it stands.
    name : str
        Its name.
    size : int, optional
        How many there must be.
    low, high : int
        Least and greatest that is allowed.

    Returns
    -------
    ndarray of int64
        The numbers.

    Raises
    ------
    ScenarioError
        It is missing, no list of whole numbers, of another size, or one is out of range.
    """
    return as_column(_value(told, name), name, size, low, high)


def as_column(value: object, name: str, size: int | None, low: int, high: int) -> Ints:
    """Return a list of whole numbers that stands by itself.

    Parameters
    ----------
    value : object
        The list.
    name : str
        What messages call it.
    size : int or None
        How many there must be.
    low, high : int
        Least and greatest that is allowed.

    Returns
    -------
    ndarray of int64
        The numbers.

    Raises
    ------
    ScenarioError
        As `column` says.
    """
    if not isinstance(value, list) or set(map(type, value)) - {int}:
        raise _wrong(name, value, "a list of whole numbers")
    if size is not None and len(value) != size:
        raise ScenarioError(
            f"certificate: {name} has {len(value):,} entries; it must have {size:,}"
        )
    if value and not (low <= min(value) and max(value) <= high):
        bad = next(one for one in value if not low <= one <= high)
        raise ScenarioError(
            f"certificate: {name} holds {brief(bad)}; it must be from {low} to {high}"
        )
    return np.array(value, np.int64)


def starts_of(told: Mapping[str, Any], name: str, rows: int, size: int) -> Ints:
    """Return where the entries of each row begin in another list.

    Parameters
    ----------
    told : mapping
        Where it stands.
    name : str
        Its name.
    rows : int
        How many rows there are.
    size : int
        How many entries the other list has.

    Returns
    -------
    ndarray of int64, (rows + 1,)
        From 0 to `size`, never falling.

    Raises
    ------
    ScenarioError
        It is anything else.
    """
    first = column(told, name, rows + 1, 0, size)
    if first[0] != 0 or first[-1] != size or (np.diff(first) < 0).any():
        raise ScenarioError(f"certificate: {name} must rise from 0 to {size:,}, and never fall")
    return first


def _value(told: Mapping[str, Any], name: str) -> Any:
    if name not in told:
        raise ScenarioError(f"certificate: {name} is missing; write the file anew")
    return told[name]


def _wrong(name: str, value: object, wanted: str) -> ScenarioError:
    kind = "null" if value is None else f"{kind_of(value)} {brief(value, 30)}"
    return ScenarioError(f"certificate: {name} is a {kind}; it must be {wanted}")
