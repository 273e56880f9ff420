"""Coasts and borders of the world: a file of compressed columns, read when a map is first drawn.

Made by `maps/build_ground.py` from Natural Earth; `maps/README.md` says what of it is kept.
"""

from __future__ import annotations

import json
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...atomic_file import whole_file
from ...errors import NetworkError

__all__ = ["FILE", "STEPS", "GroundTable", "bundled_ground"]

FILE = Path(__file__).parent / "ground.npz"
"""The table that comes with the package."""

STEPS = 1_000
"""Steps to a degree in which the file keeps positions: 56 m or less from where they are."""

SEAM = 0.02
"""How far land that is cut at the date line reaches over it [deg], so that no seam shows."""

COLUMNS = ("land_lon", "land_lat", "land_size", "border_lon", "border_lat", "border_size", "about")

Floats = NDArray[np.float64]


class GroundTable:
    """Rings of land and lines of borders.

    Parameters
    ----------
    columns : mapping of str to ndarray
        As the file has them: steps from point to point, points to a line, and a text in UTF-8.

    Attributes
    ----------
    land : tuple of ndarray of float, (k, 2)
        Rings around land, clockwise, and around water in it, the other way; longitude and latitude
        [deg], the last point as the first; read-only. Land on both sides of the date line is
        cut there, and reaches a little over it.
    borders : tuple of ndarray of float, (k, 2)
        Lines between countries, as land; read-only.
    land_boxes, border_boxes : ndarray of float, (n, 4)
        West, south, east and north of each line [deg].
    about : dict
        Where the table is from.
    """

    def __init__(self, columns: Mapping[str, NDArray[Any]]) -> None:
        self._columns = {name: columns[name] for name in COLUMNS}
        self.land = _lines(self._columns, "land")
        self.borders = _lines(self._columns, "border")
        self.land_boxes, self.border_boxes = _boxes(self.land), _boxes(self.borders)
        self.about: dict[str, Any] = json.loads(self._columns["about"].tobytes().decode())

    @classmethod
    def of(
        cls, land: Sequence[ArrayLike], borders: Sequence[ArrayLike], about: Mapping[str, str]
    ) -> GroundTable:
        """Make a table of lines.

        Parameters
        ----------
        land, borders : sequence of array_like of float, (k, 2)
            Longitude and latitude in degrees, as the attributes.
        about : mapping of str to str
            Where they are from.

        Returns
        -------
        GroundTable
            Of these, rounded.
        """
        text = json.dumps(about, ensure_ascii=False)
        return cls(
            {
                **_columns(land, "land"),
                **_columns(borders, "border"),
                "about": np.frombuffer(text.encode(), np.uint8),
            }
        )

    @classmethod
    def read(cls, path: Path) -> GroundTable:
        """Read a table.

        Parameters
        ----------
        path : Path
            A file that `write` wrote.

        Returns
        -------
        GroundTable
            The table.

        Raises
        ------
        NetworkError
            The file is not there, or damaged.
        """
        try:
            with path.open("rb") as file, np.load(file, allow_pickle=False) as columns:
                return cls(columns)
        except (OSError, ValueError, KeyError, IndexError, EOFError, TypeError, zlib.error,
                zipfile.BadZipFile) as error:  # fmt: skip
            raise NetworkError(
                f"{path.name}: the table of coasts cannot be read; install platoon_osm again"
            ) from error

    def write(self, path: Path) -> None:
        """Write the table.

        Parameters
        ----------
        path : Path
            The file.
        """
        with whole_file(path) as draft:
            np.savez_compressed(draft, allow_pickle=False, **self._columns)


def _columns(lines: Sequence[ArrayLike], name: str) -> dict[str, NDArray[Any]]:
    rounded = [np.rint(np.multiply(line, STEPS)).astype(np.int32).reshape(-1, 2) for line in lines]
    flat = np.concatenate([*rounded, np.zeros((0, 2), np.int32)])
    steps = np.diff(flat, axis=0, prepend=np.zeros((1, 2), np.int32))
    return {
        f"{name}_lon": steps[:, 0],
        f"{name}_lat": steps[:, 1],
        f"{name}_size": np.array([len(line) for line in rounded], np.int32),
    }


def _lines(columns: Mapping[str, NDArray[Any]], name: str) -> tuple[Floats, ...]:
    lon, lat = (np.cumsum(columns[f"{name}_{axis}"], dtype=np.int64) for axis in ("lon", "lat"))
    size = columns[f"{name}_size"].astype(np.int64)
    if len(lon) != len(lat) or len(lon) != size.sum() or (size < 2).any():
        raise ValueError
    flat = np.column_stack([lon, lat]) / STEPS
    if len(flat) and (abs(flat) > (540, 90)).any():
        raise ValueError
    flat[:, 0] += SEAM * np.sign(flat[:, 0]) * (abs(flat[:, 0]) == 180.0)
    flat.flags.writeable = False
    return tuple(np.split(flat, np.cumsum(size)[:-1])) if len(size) else ()


def _boxes(lines: Sequence[Floats]) -> Floats:
    boxes = np.array([(*line.min(axis=0), *line.max(axis=0)) for line in lines]).reshape(-1, 4)
    boxes.flags.writeable = False
    return boxes


@cache
def bundled_ground() -> GroundTable:
    """Return the table that comes with the package, read once.

    Returns
    -------
    GroundTable
        The table.

    Raises
    ------
    NetworkError
        The file is not there, or damaged.
    """
    return GroundTable.read(FILE)
