"""A layer of a GeoPackage: points where trips start, or lines from origin to destination.

Programs for maps store single points and lines as multi-points and multi-lines too; those of one
part, or of parts that follow each other, are read as what they are.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from datetime import datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import ScenarioError, brief
from .cells import column_named
from .rows import Row, rows_under

__all__ = ["read_geopackage"]

WGS84 = "EPSG:4326"
NO_TRIPS = {"nodes", "edges"}
"""Layers of a network as OSMnx saves it."""


def read_geopackage(file: Path, layer: str | None, content: bytes | None) -> list[Row]:
    """Read a layer of a GeoPackage.

    Parameters
    ----------
    file : Path
        The GeoPackage.
    layer : str or None
        Name of the layer; by default the only one, or the one called "trips".
    content : bytes or None
        What it holds, if that was read before.

    Returns
    -------
    list of Row
        Its rows; places of its geometry as (lon, lat) in degrees of WGS 84.

    Raises
    ------
    ScenarioError
        No GeoPackage, no such layer, a geometry of another kind, or none of the places given.
    """
    import pyogrio

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a name in upper case, and of what no column is
        try:
            # GDAL goes by the name where there is one, so a file of another name comes without.
            data: Any = content
            if content is None:
                data = file if file.suffix.lower() == ".gpkg" else file.read_bytes()
            layers = [str(name) for name in pyogrio.list_layers(data)[:, 0]]
            name = _chosen(file, layers, layer)
            table = pyogrio.read_dataframe(data, layer=name)
        except ScenarioError:
            raise
        except Exception as error:  # GDAL's kinds of error are many
            raise ScenarioError(
                f"{file}: not a GeoPackage that can be read ({brief(str(error))}); save it again"
            ) from error
    places = _places(file, name, table)
    columns = [str(column) for column in table.columns if column != _geometry_of(table)]
    for end in places:
        told = [column for column in columns if column_named(column) == end]
        if told:
            raise ScenarioError(
                f"{file}: layer {brief(name)} tells the {end} by its geometry and in a column; "
                f"call the column {end}_label, or remove it"
            )
    header = [*columns, *places]
    cells = [table[column].tolist() for column in columns]
    lines = (
        (f"{file.name} feature {number}", [_plain(cell) for cell in row])
        for number, row in enumerate(_transposed([*cells, *places.values()], len(table)), 1)
    )
    return rows_under(header, lines, f"{file.name} layer {brief(name)}")


def _chosen(file: Path, layers: list[str], layer: str | None) -> str:
    if layer is None:
        if len(layers) == 1:
            return layers[0]
        if "trips" in layers:
            return "trips"
        why = "is a network, not trips" if set(layers) >= NO_TRIPS else "has several layers"
        if layers:
            raise ScenarioError(f"{file}: {why} ({', '.join(layers)}); name one as sheet")
    elif layer in layers:
        return layer
    raise ScenarioError(
        f"{file}: has no layer {brief(layer)}; layers are {', '.join(layers) or '(none)'}"
    )


def _geometry_of(table: Any) -> str:
    """Return the name of the column of geometries; empty if there is none."""
    return str(getattr(table, "_geometry_column_name", None) or "")


def _places(file: Path, layer: str, table: Any) -> dict[str, list[Any]]:
    """Return the columns that the geometries stand for, with None where there is none."""
    if not _geometry_of(table) or table.geometry.isna().all():
        return {}
    if table.crs is None:
        raise ScenarioError(
            f"{file}: layer {brief(layer)} has no coordinate system; give it one, such as {WGS84}"
        )
    try:
        geometries = list(table.geometry.to_crs(WGS84))
    except Exception as error:  # of pyproj, which has its own
        raise ScenarioError(
            f"{file}: layer {brief(layer)} cannot be brought into {WGS84} ({brief(str(error))}); "
            "save it in that"
        ) from error
    ends = [
        _told_ends(f"{file.name} feature {number}", geometry)
        for number, geometry in enumerate(geometries, 1)
    ]
    found = {"origin": [start for start, _ in ends], "destination": [end for _, end in ends]}
    return {key: places for key, places in found.items() if any(places)}


def _told_ends(where: str, geometry: Any) -> tuple[Any, Any]:
    """Return where a trip starts and ends; an error if its geometry tells no such places."""
    try:
        return _ends(where, geometry)
    except ScenarioError as error:
        return error, None


def _ends(where: str, geometry: Any) -> tuple[Any, Any]:
    """Return where a trip starts and ends by its geometry, each as (lon, lat) or None."""
    if geometry is None or geometry.is_empty:
        return None, None
    kind = geometry.geom_type
    parts = list(getattr(geometry, "geoms", [geometry]))
    if kind.endswith("Point") and len(parts) == 1:
        return _position(where, parts[0].coords[0]), None
    if kind.endswith("LineString"):
        coordinates = [list(part.coords) for part in parts]
        follows = all(before[-1] == after[0] for before, after in pairwise(coordinates))
        if follows:
            start, end = coordinates[0][0], coordinates[-1][-1]
            return _position(where, start), _position(where, end)
    raise ScenarioError(
        f"{where}: its geometry is a {kind} of {len(parts)} parts; give a point where the trip "
        "starts, or a line from origin to destination"
    )


def _position(where: str, coordinates: Any) -> tuple[float, float]:
    lon, lat = (float(value) for value in coordinates[:2])
    if not (abs(lon) <= 180 and abs(lat) <= 90):
        raise ScenarioError(
            f"{where}: its geometry lies at ({lon:g}, {lat:g}), no place on earth; correct the "
            "coordinate system of the layer"
        )
    return lon, lat


def _transposed(columns: list[list[Any]], count: int) -> Iterator[list[Any]]:
    return ([column[k] for column in columns] for k in range(count))


def _plain(cell: Any) -> Any:
    """Return a cell as Python's own; what pandas calls missing is blank."""
    if isinstance(cell, tuple):
        return cell
    if cell is None or cell != cell:  # NaN and NaT equal nothing, themselves included
        return None
    if isinstance(cell, datetime):
        return getattr(cell, "to_pydatetime", lambda: cell)()  # pandas has its own kind
    return cell.item() if isinstance(cell, np.generic) else cell
