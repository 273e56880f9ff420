"""Trips as a table that `read_trips` reads back."""

from __future__ import annotations

import os
from collections.abc import Sequence

from ...csv_tables import write_table
from ...errors import ScenarioError
from ...network.location import Place, PlaceLike
from ...plans.trip import TIMES, Trip

__all__ = ["write_trips"]

ENDS = ("origin", "destination")
DIGITS = 10
"""Enough of degrees for a millimetre."""

Cell = str | float | int | None


def write_trips(trips: Sequence[Trip], path: str | os.PathLike[str]) -> None:
    """Write trips as CSV: vehicle, places, times and flexibility.

    Parameters
    ----------
    trips : sequence of Trip
        Places are names, coordinates, or OpenStreetMap ids with or without a label.
    path : path-like
        Of the file.

    Raises
    ------
    ScenarioError
        A place of another kind, or a file that cannot be written.
    """
    rows = [_row(trip) for trip in trips]
    columns = [
        column
        for column in (
            "vehicle",
            *(f"{end}{part}" for end in ENDS for part in ("", "_lon", "_lat", "_osmid", "_label")),
            *TIMES,
            "flexibility_min",
        )
        if any(row.get(column) is not None for row in rows)
    ]
    write_table(path, columns, ([row.get(column) for column in columns] for row in rows), DIGITS)


def _row(trip: Trip) -> dict[str, Cell]:
    row: dict[str, Cell] = {"vehicle": trip.vehicle}
    for end in ENDS:
        row |= _place(trip, end, getattr(trip, end))
    row |= {name: at.isoformat() for name, at in trip.times.items()}
    row["flexibility_min"] = trip.flexibility_min
    return row


def _place(trip: Trip, end: str, place: PlaceLike) -> dict[str, Cell]:
    if isinstance(place, Place):
        known: dict[str, Cell] = {f"{end}_label": place.label}
        if place.osmid is not None:
            return {f"{end}_osmid": place.osmid, **known}
        assert place.at is not None
        return _place(trip, end, place.at) | known
    if isinstance(place, str):
        return {end: place}
    if isinstance(place, tuple):
        return {f"{end}_lon": float(place[0]), f"{end}_lat": float(place[1])}
    raise ScenarioError(
        f"trip {trip.vehicle!r}: {end} is a node of one network; a table takes names, (lon, lat) "
        "and OpenStreetMap ids"
    )
