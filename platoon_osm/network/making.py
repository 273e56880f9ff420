"""From what a caller gives to the columns of a network: converted, filled in, sorted by tail."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import NetworkError
from .columns import COLUMNS, Column, columns_per
from .shapes import ragged_order, shape_lengths_m
from .texts import TextTable, encode_texts

__all__ = ["checked_edges", "in_its_type", "made_columns"]

Columns = dict[str, NDArray[Any]]

KINDS = {"f": "numbers", "i": "whole numbers", "u": "whole numbers", "b": "True or False"}
"""What to give for a column, by the kind of its numpy type."""


def made_columns(given: Mapping[str, Any], texts: TextTable | None) -> tuple[Columns, TextTable]:
    """Return all columns of a network but those of its named points.

    Parameters
    ----------
    given : mapping of str to array_like
        Columns by name, edges in any order; None stands for one that is not given.
    texts : TextTable or None
        What codes of texts refer to; None if these columns hold the texts themselves.

    Returns
    -------
    columns : dict of str to ndarray
        Of the types in the table, edges sorted by tail.
    texts : TextTable
        The given one, or one made of the texts.

    Raises
    ------
    NetworkError
        A column that is unknown, missing, of the wrong size or type, or ends that are no nodes.
    """
    _check_names(given)
    for name in ("tail", "head", "lon", "lat"):
        if given.get(name) is None:
            raise NetworkError(f"network: {name} is missing; give one for each {_owner(name)}")
    n, _, m, _ = (_size(name, given[name]) for name in ("lon", "lat", "tail", "head"))
    sizes = {"node": n, "edge": m, "offset": m + 1}
    columns: Columns = {}
    own = columns_per("node", "edge")
    wanted = [column for column in own if given.get(column.name) is not None]
    for column in wanted:
        if texts is None and column.codes == "texts":
            columns[column.name] = _texts(column, given[column.name], n, m, sizes[column.per])
        else:
            columns[column.name] = _values(column, given[column.name], n, m, sizes[column.per])
    if texts is None:
        names = [column.name for column in wanted if column.codes == "texts"]
        texts, codes = encode_texts(*(columns[name].tolist() for name in names))
        columns |= zip(names, codes, strict=True)
    tail, head = columns["tail"], columns["head"]
    _check_ends(tail, head, n)
    first, lon, lat = _shapes(given, columns, n, m)
    if "length_m" not in columns:
        with np.errstate(invalid="ignore"):  # points off the globe are refused later, by name
            columns["length_m"] = shape_lengths_m(first, lon, lat)
    if "posted_mps" not in columns and "speed_mps" in columns:
        columns["posted_mps"] = columns["speed_mps"]  # no truck is slower there than others
    if "node_id" not in columns:
        columns["node_id"] = np.arange(n, dtype=np.int64)
    order = np.argsort(tail, kind="stable")
    points, shape_first = ragged_order(first, order)
    first_out = np.zeros(n + 1, np.int32)
    np.cumsum(np.bincount(tail, minlength=n), out=first_out[1:])
    made: Columns = {"first_out": first_out, "shape_first": shape_first}
    made |= {"shape_lon": lon[points], "shape_lat": lat[points]}
    for column in own:
        values = columns.get(column.name)
        if values is None:
            made[column.name] = column.filled(sizes[column.per])
        else:
            # Always a copy: the caller's array stays the caller's own.
            made[column.name] = values[order] if column.per == "edge" else values.copy()
    return made, texts


def checked_edges(edges: ArrayLike, m: int) -> NDArray[np.int64]:
    """Return edge ids as an array.

    Parameters
    ----------
    edges : array_like of int, (k,)
        Edge ids.
    m : int
        Number of edges there are.

    Returns
    -------
    ndarray of int64, (k,)
        The same ids.

    Raises
    ------
    NetworkError
        No flat list of whole numbers, or an edge that is none.
    """
    given = _array("edges", edges)
    if given.ndim != 1 or (len(given) and given.dtype.kind not in "iu"):
        raise NetworkError(f"network: edges {_shown(edges)}: give a flat list of edge ids")
    wrong = (given < 0) | (given >= m) if len(given) else np.zeros(0, bool)
    if wrong.any():
        raise NetworkError(
            f"network: edge {given[np.argmax(wrong)]}: the network has edges 0 to {m - 1}"
        )
    return given.astype(np.int64)


def _check_names(given: Mapping[str, Any]) -> None:
    known = [column.name for column in COLUMNS if column.per != "named point"]
    known.remove("first_out")
    for name in given:
        if name == "first_out":
            raise NetworkError("network: first_out follows from tail; leave it out")
        if name not in known:
            near = difflib.get_close_matches(name, known, 1, 0.6)
            hint = f"did you mean {near[0]}?" if near else f"use {', '.join(sorted(known))}"
            raise NetworkError(f"network: no column is called {name!r}; {hint}")


def _owner(name: str) -> str:
    return next(column.per for column in COLUMNS if column.name == name)


def _size(name: str, value: Any) -> int:
    """Return how many nodes or edges there are, by the column that says so."""
    array = _array(name, value)
    if array.ndim != 1:
        raise NetworkError(
            f"network: {name} has shape {array.shape}; give a list, one for each {_owner(name)}"
        )
    return len(array)


def _array(name: str, value: Any) -> NDArray[Any]:
    try:
        return np.asarray(value)
    except (TypeError, ValueError) as error:
        raise NetworkError(
            f"network: {name} holds {_shown(value)}, which is no array; give a flat list"
        ) from error


def _shown(value: Any) -> str:
    return " ".join(repr(value).split())[:60]


def _fitted(column: Column, array: NDArray[Any], n: int, m: int, size: int) -> NDArray[Any]:
    if array.ndim and array.shape != (size,):
        raise NetworkError(
            f"network: {column.name} has shape {array.shape}; {n} nodes and {m} edges "
            f"need ({size},)"
        )
    return np.broadcast_to(array, (size,))


def _texts(column: Column, value: Any, n: int, m: int, size: int) -> NDArray[Any]:
    # As objects: numpy's own text type drops what follows a null character.
    try:
        array = np.asarray(value, object)
    except (TypeError, ValueError) as error:
        raise NetworkError(f"network: {column.name} holds {_shown(value)}; give texts") from error
    texts = np.empty(size, object)
    texts[:] = [str(text) for text in _fitted(column, array, n, m, size)]
    return texts


def _values(column: Column, value: Any, n: int, m: int, size: int) -> NDArray[Any]:
    """Return a column in its type; a value that would change on the way is refused."""
    return _fitted(column, in_its_type(column, value), n, m, size)


def in_its_type(column: Column, value: Any) -> NDArray[Any]:
    """Return values in the type of their column.

    Parameters
    ----------
    column : Column
        What they are.
    value : array_like
        Of any type; a value that would change on the way is refused.

    Returns
    -------
    ndarray
        The same array where it has the type.

    Raises
    ------
    NetworkError
        With the value that does not fit, and what would.
    """
    array, dtype = _array(column.name, value), np.dtype(column.dtype)
    if array.dtype == dtype:
        return array
    wrong: Any = array if array.ndim == 0 else array[:3]
    if array.dtype.kind in "biufO":
        try:
            if array.dtype.kind == "O" and any(isinstance(item, str) for item in array.flat):
                raise TypeError
            with np.errstate(all="ignore"):
                cast = array.astype(dtype)
            if dtype.kind == "f":
                return cast
            changed = np.asarray(cast != array)
            if not changed.any():
                return cast
            wrong = array[changed][0] if array.ndim else array
        except (TypeError, ValueError, OverflowError):
            pass
    what = "codes of texts" if column.codes == "texts" else KINDS[dtype.kind]
    unit = f" [{column.unit}]" if dtype.kind == "f" else ""
    raise NetworkError(
        f"network: {column.name} holds {_shown(np.asarray(wrong).tolist())}; give {what}{unit}"
    )


def _check_ends(tail: NDArray[Any], head: NDArray[Any], n: int) -> None:
    bad = (tail < 0) | (tail >= n) | (head < 0) | (head >= n)
    if bad.any():
        raise NetworkError(
            f"network: {int(bad.sum())} of {len(tail)} edges end at no node (first: edge "
            f"{int(np.argmax(bad))}); node positions run from 0 to {n - 1}"
        )


def _shapes(
    given: Mapping[str, Any], columns: Columns, n: int, m: int
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return where each edge's points begin, and their coordinates; straight if none are given."""
    names = ("shape_first", "shape_lon", "shape_lat")
    missing = [name for name in names if given.get(name) is None]
    if len(missing) == len(names):
        ends = np.column_stack([columns["tail"], columns["head"]]).ravel()
        first = 2 * np.arange(m + 1, dtype=np.int64)
        return first, columns["lon"][ends], columns["lat"][ends]
    if missing:
        raise NetworkError(
            f"network: {', '.join(missing)} missing; give shape_first, shape_lon and shape_lat, "
            "or none of them for straight edges"
        )
    by_name = {column.name: column for column in columns_per("offset", "shape point")}
    first = _values(by_name["shape_first"], given["shape_first"], n, m, m + 1)
    lon, lat = (in_its_type(by_name[name], given[name]) for name in ("shape_lon", "shape_lat"))
    if lon.shape != (first[-1],) or lat.shape != (first[-1],) or first[0] != 0:
        raise NetworkError(
            f"network: shapes have {lon.size} lon and {lat.size} lat for points "
            f"{first[0]} to {first[-1]}; shape_first must run from 0 to their number"
        )
    if (np.diff(first) < 2).any():
        raise NetworkError("network: every edge needs a shape of two points or more")
    return first, lon, lat
