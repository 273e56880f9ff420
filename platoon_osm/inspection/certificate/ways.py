"""Whether all drive as they may: on connected lanes of their kind, within their windows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .faults import FaultError
from .told import Told

__all__ = ["alone_costs", "check_schedules"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]


def alone_costs(told: Told) -> Ints:
    """Return what the ways alone cost, once it is checked that they are in time.

    Parameters
    ----------
    told : Told
        What the file says.

    Returns
    -------
    ndarray of int64, (N,)
        Costs [grains].

    Raises
    ------
    FaultError
        A way that is none, or is late though its truck leaves at once.
    """
    late_start = told.latest_departure < told.earliest
    _refuse(told, late_start, "must leave before it may")
    _check_connected(told, told.first_route, told.route, "its way alone")
    drive = _sums(told.drive[told.route], told.first_route)
    _refuse(told, told.earliest + drive > told.latest, "is late even alone")
    return _sums(told.alone[told.route], told.first_route)


def check_schedules(told: Told) -> None:
    """Check that each truck's schedule is one that it may drive.

    Parameters
    ----------
    told : Told
        What the file says.

    Raises
    ------
    FaultError
        Some schedule is not.
    """
    _check_connected(told, told.first, told.lane, "its schedule")
    first, lane, depart = told.first, told.lane, told.depart
    begins, ends = first[:-1], first[1:] - 1
    driven = begins <= ends
    some = np.flatnonzero(driven)
    starts, arrives = depart[begins[some]], depart[ends[some]] + told.drive[lane[ends[some]]]
    _refuse(told, _of(told, some, starts < told.earliest[some]), "leaves before it may")
    _refuse(told, _of(told, some, starts > told.latest_departure[some]), "leaves after it may")
    _refuse(told, _of(told, some, arrives > told.latest[some]), "arrives after it may")
    early = depart[1:] < depart[:-1] + told.drive[lane[:-1]]
    _refuse(told, _rows(told, first, early), "enters a lane before it is there")
    if told.given:
        differs = np.diff(first) != np.diff(told.first_route)
        if not differs.any():
            truck = np.repeat(np.arange(told.trucks), np.diff(first))
            differs[truck[lane != told.route]] = True
        _refuse(told, differs, "leaves its given route")


def _check_connected(told: Told, first: Ints, lane: Ints, what: str) -> None:
    """Check that the lanes of each truck lead from its origin to its destination."""
    some = np.flatnonzero(np.diff(first) > 0)
    empty = np.diff(first) == 0
    _refuse(told, empty & (told.origin != told.destination), f"goes nowhere; {what} has no lanes")
    begins = told.tail[lane[first[some]]] != told.origin[some]
    ends = told.head[lane[first[some + 1] - 1]] != told.destination[some]
    _refuse(told, _of(told, some, begins), f"starts elsewhere on {what}")
    _refuse(told, _of(told, some, ends), f"ends elsewhere on {what}")
    gaps = told.head[lane[:-1]] != told.tail[lane[1:]]
    _refuse(told, _rows(told, first, gaps), f"jumps on {what}")
    truck = np.repeat(np.arange(told.trucks), np.diff(first))
    other = np.zeros(told.trucks, bool)
    other[truck[told.lane_kind[lane] != told.kind[truck]]] = True
    _refuse(told, other, f"is on a lane of another kind on {what}")


def _rows(told: Told, first: Ints, between: Marks) -> Marks:
    """Mark the trucks of which two neighbouring entries are marked; not from one to the next."""
    truck = np.repeat(np.arange(told.trucks), np.diff(first))
    found = np.zeros(told.trucks, bool)
    found[truck[1:][between & (truck[1:] == truck[:-1])]] = True
    return found


def _of(told: Told, some: Ints, marked: Marks) -> Marks:
    found = np.zeros(told.trucks, bool)
    found[some[marked]] = True
    return found


def _sums(values: Ints, first: Ints) -> Ints:
    sums = np.concatenate([[0], np.cumsum(values)])
    found: Ints = sums[first[1:]] - sums[first[:-1]]
    return found


def _refuse(told: Told, marked: Marks, what: str) -> None:
    if marked.any():
        raise FaultError(f"vehicle {told.vehicles[int(np.flatnonzero(marked)[0])]!r} {what}")
