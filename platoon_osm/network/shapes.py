"""Ragged arrays of points: the shapes of many edges, one behind the other."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .geodesy import distance_m

__all__ = ["ragged_order", "shape_lengths_m"]


def ragged_order(
    first: NDArray[np.int64], rows: NDArray[Any], backwards: bool = False
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return which points to take, to put the rows of a ragged array in another order.

    Parameters
    ----------
    first : ndarray of int64, (m + 1,)
        Where each row begins.
    rows : ndarray, (k,)
        Rows to take, in order.
    backwards : bool
        Take each row's points from its end.

    Returns
    -------
    points : ndarray of int64
        Positions in the old flat array.
    new_first : ndarray of int64, (k + 1,)
        Where each taken row begins.
    """
    size = np.diff(first)[rows]
    new_first = np.zeros(len(rows) + 1, np.int64)
    np.cumsum(size, out=new_first[1:])
    step = np.arange(new_first[-1]) - np.repeat(new_first[:-1], size)
    if backwards:
        return np.repeat(first[1:][rows] - 1, size) - step, new_first
    return np.repeat(first[:-1][rows], size) + step, new_first


def shape_lengths_m(
    first: NDArray[np.int64], lon: NDArray[Any], lat: NDArray[Any]
) -> NDArray[np.float64]:
    """Return the length [m] of each row of a ragged array of points.

    Parameters
    ----------
    first : ndarray of int64
        Where each row begins.
    lon : ndarray
        Degrees.
    lat : ndarray
        Degrees.

    Returns
    -------
    ndarray of float
        Metres, (m,).
    """
    if len(lon) < 2:
        return np.zeros(len(first) - 1)
    step = distance_m(lon[:-1], lat[:-1], lon[1:], lat[1:])
    step[first[1:-1] - 1] = 0.0
    result: NDArray[np.float64] = np.add.reduceat(np.append(step, 0.0), first[:-1])
    return result
