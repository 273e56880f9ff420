"""The segments of a file of Overture's: GeoParquet, GeoJSON, or GeoJSON line by line."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from ...network.geodesy import distance_m
from ..file_identity import read_bytes

__all__ = ["REMEDY", "Segment", "is_overture", "segments_of"]

PARQUET = (".parquet", ".geoparquet")
SIGNS_OF_IT = ("connectors", "subtype")
"""Columns that no other table of lines has."""
NEEDED = ("id", "geometry", "subtype", "class", "connectors")
WANTED = (
    *NEEDED, "subclass", "subclass_rules", "road_flags", "names", "routes", "speed_limits",
    "access_restrictions", "prohibited_transitions", "sources",
)  # fmt: skip
ROAD = "road"
REMEDY = "download segments of the theme transportation again"
HEAD = 1 << 16
ROUNDED = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Segment:
    """One segment, with its places measured from 0 to 1 along it.

    Attributes
    ----------
    name : str
        Its id.
    points : ndarray of float, (k, 2)
        Longitude and latitude [deg].
    share : ndarray of float, (k,)
        Where each point lies, 0 at its beginning to 1 at its end.
    connectors : tuple of (float, str)
        Where other segments may be reached, and the connectors' ids, rising.
    about : mapping
        All else that the file says of it.
    """

    name: str
    points: NDArray[np.float64]
    share: NDArray[np.float64]
    connectors: tuple[tuple[float, str], ...]
    about: Mapping[str, Any] = field(default_factory=dict)

    def rules(self, kind: str, low: float, high: float) -> list[Mapping[str, Any]]:
        """Return the rules of a kind that hold on a part.

        Parameters
        ----------
        kind : str
            Name of a list of rules, such as "speed_limits".
        low, high : float
            Where the part begins and ends, 0 to 1; no rule begins or ends in between.

        Returns
        -------
        list of mapping
            In their order.
        """
        middle = (low + high) / 2
        return [rule for rule in self.about.get(kind) or () if _holds(rule, middle)]

    def breaks(self, kinds: Sequence[str]) -> list[float]:
        """Return where connectors are and rules of some kinds begin or end.

        Parameters
        ----------
        kinds : sequence of str
            Names of lists of rules.

        Returns
        -------
        list of float
            From 0 to 1, rising.
        """
        found = {0.0, 1.0, *(at for at, _ in self.connectors)}
        for kind in kinds:
            for rule in self.about.get(kind) or ():
                found.update(float(at) for at in rule.get("between") or () if 0 < at < 1)
        return sorted(found)


def _holds(rule: Mapping[str, Any], at: float) -> bool:
    between = rule.get("between")
    return not between or between[0] <= at <= between[1]


def is_overture(path: Path) -> bool:
    """Tell whether a file of lines has Overture's columns.

    Parameters
    ----------
    path : Path
        GeoParquet or GeoJSON.

    Returns
    -------
    bool
        False also if it cannot be read: whoever reads it then says why.
    """
    try:
        if path.suffix.lower() in PARQUET:
            import pyarrow.parquet

            return {*SIGNS_OF_IT} <= {*pyarrow.parquet.read_schema(path).names}
        with path.open("rb") as handle:
            head = handle.read(HEAD)
    except (OSError, ValueError):
        return False
    return all(f'"{name}"'.encode() in head for name in SIGNS_OF_IT)


def segments_of(file: Path, kinds: Collection[str]) -> tuple[list[Segment], Counter[str]]:
    """Return the road segments of some classes.

    Parameters
    ----------
    file : Path
        GeoParquet or GeoJSON.
    kinds : collection of str
        Values of `class`. Only such segments are read whole: a file of all roads of a country holds
        many times as many paths.

    Returns
    -------
    list of Segment
        In the order of the file.
    Counter of str
        How many other roads the file holds, by class.

    Raises
    ------
    MapDataError
        A segment that is no line on the earth. What else is wrong with a file shows in errors of
        the libraries that read it, or of keys and types.
    """
    others: Counter[str] = Counter()
    is_parquet = file.suffix.lower() in PARQUET
    rows = _parquet_rows(file, kinds, others) if is_parquet else _json_rows(read_bytes(file)[0])
    found = []
    for row in rows:
        if row.get("subtype") != ROAD:
            continue
        if row["class"] in kinds:
            found.append(_segment(file, row))
        else:
            others[str(row["class"])] += 1
    return found, others


def _parquet_rows(
    file: Path, kinds: Collection[str], others: Counter[str]
) -> Iterator[dict[str, Any]]:
    import pyarrow.parquet
    import shapely

    names = pyarrow.parquet.read_schema(file).names
    classes = pyarrow.parquet.read_table(file, columns=["class"], filters=[("subtype", "=", ROAD)])
    for kind in classes["class"].value_counts().to_pylist():
        if kind["values"] not in kinds:
            others[str(kind["values"])] += kind["counts"]
    table = pyarrow.parquet.read_table(
        file,
        columns=[name for name in WANTED if name in names],
        filters=[("subtype", "=", ROAD), ("class", "in", list(kinds))],
    )
    for row in table.to_pylist():
        row["geometry"] = shapely.from_wkb(row["geometry"])
        yield row


def _json_rows(content: bytes) -> Iterator[dict[str, Any]]:
    import shapely.geometry

    text = content.decode("utf-8-sig")
    try:
        features = json.loads(text)["features"]
    except ValueError:
        # One feature a line, perhaps each behind a record separator.
        lines = [line.strip("\x1e \r") for line in text.split("\n")]
        features = [json.loads(line) for line in lines if line]
    for feature in features:
        geometry = feature["geometry"] and shapely.geometry.shape(feature["geometry"])
        own = {"id": feature["id"]} if feature.get("id") else {}
        yield {**own, **feature["properties"], "geometry": geometry}


def _segment(file: Path, row: dict[str, Any]) -> Segment:
    name, shape = str(row["id"]), row["geometry"]
    if getattr(shape, "geom_type", "") != "LineString" or shape.is_empty:
        raise MapDataError(f"{file}: segment {name} is no line; {REMEDY}")
    points = np.array(shape.coords, np.float64)[:, :2]
    if not (np.abs(points) <= (180, 90)).all():
        raise MapDataError(f"{file}: segment {name} has a point that is off the earth; {REMEDY}")
    steps = distance_m(points[:-1, 0], points[:-1, 1], points[1:, 0], points[1:, 1])
    along = np.concatenate([[0.0], np.cumsum(steps)])
    share = along / along[-1] if along[-1] > 0 else np.linspace(0.0, 1.0, len(points))
    told = [(float(one["at"]), str(one["connector_id"])) for one in row["connectors"]]
    connectors = sorted((min(max(at, 0.0), 1.0), own) for at, own in told)
    if any(not -ROUNDED <= at <= 1 + ROUNDED for at, _ in told):
        raise MapDataError(f"{file}: segment {name} has a connector off its line; {REMEDY}")
    return Segment(name, points, share, tuple(connectors), row)
