"""Files of truck volumes, and of where their places are.

Volumes are rows `origin,destination,volume`. Where places are ids, their coordinates may stand in
`segments.csv` beside the file (`source`, `position_x`, `position_y`), as in the ETISplus sets.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

from ...errors import MapDataError

__all__ = ["SEGMENTS", "positions_in", "volumes_in"]

SEGMENTS = "segments.csv"
"""What a file of places is called."""


def volumes_in(path: Path) -> list[tuple[str, str, float]]:
    """Read truck volumes.

    Parameters
    ----------
    path : Path
        CSV with `origin`, `destination`, `volume`.

    Returns
    -------
    list of (str, str, float)
        Places as they are written, and trucks in any one time.

    Raises
    ------
    MapDataError
        No such file, other columns, or a volume that is none.
    """
    found = []
    for line, row in _rows(path, ("origin", "destination", "volume")):
        volume = _number(path, line, row["volume"])
        if volume < 0:
            raise MapDataError(
                f"{path.name}: line {line}: volume {volume:g} is below 0; correct it"
            )
        found.append((row["origin"].strip(), row["destination"].strip(), volume))
    return found


def positions_in(path: Path) -> dict[str, tuple[float, float]]:
    """Read where places are.

    Parameters
    ----------
    path : Path
        CSV with `source`, `position_x`, `position_y`.

    Returns
    -------
    dict
        Longitude and latitude [deg] by id.

    Raises
    ------
    MapDataError
        No such file, other columns, or coordinates that are none.
    """
    places: dict[str, tuple[float, float]] = {}
    for line, row in _rows(path, ("source", "position_x", "position_y")):
        key = row["source"].strip()
        if key in places:
            continue
        lon, lat = (_number(path, line, row[column]) for column in ("position_x", "position_y"))
        if not (abs(lon) <= 180 and abs(lat) <= 90):
            raise MapDataError(
                f"{path.name}: line {line}: {lon:g}, {lat:g} is no longitude and latitude; "
                "give degrees"
            )
        places[key] = lon, lat
    return places


def _rows(path: Path, columns: tuple[str, ...]) -> list[tuple[int, dict[str, str]]]:
    if not path.is_file():
        raise MapDataError(
            f"{path}: no such file; flows need two: volumes, and {SEGMENTS} beside it"
        )
    try:
        with path.open(encoding="utf-8-sig", newline="") as handle:
            reader = csv.DictReader(handle)
            missing = set(columns) - set(reader.fieldnames or ())
            if missing:
                raise MapDataError(
                    f"{path}: no column {sorted(missing)[0]!r}; begin the file with "
                    f"{','.join(columns)}"
                )
            rows = []
            for row in reader:
                if None in row or None in row.values():
                    raise MapDataError(
                        f"{path}: line {reader.line_num} has another number of fields than the "
                        "first; the file may be cut short: fetch it again"
                    )
                rows.append((reader.line_num, row))
            return rows
    except OSError as error:
        raise MapDataError(f"{path}: cannot be read ({error.strerror}); check its rights") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise MapDataError(f"{path}: not a CSV text file ({error}); save it as UTF-8") from None


def _number(path: Path, line: int, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise MapDataError(f"{path.name}: line {line}: {text!r:.40} is no number; correct it")
    return value
