"""Road networks from plain lines: GeoPackage, GeoJSON, GeoParquet, shapefiles and their like.

A point that two lines share is a junction, as in OpenStreetMap; lines that cross without sharing
one, at a bridge, do not meet.
"""

from __future__ import annotations

import os
import warnings
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from ...network.load_report import Source
from ...network.road_network import RoadNetwork
from ..file_identity import file_digest, osm_source
from ..osm.extract import network_of
from ..osm.tables import MapNode, MapWay, raw_map
from ..truck import TruckRules
from .columns import holds_roads, id_of, tags_of

if TYPE_CHECKING:
    import geopandas

__all__ = ["layers_of", "read_lines"]

KINDS = {
    ".gpkg": "GeoPackage", ".geojson": "GeoJSON file", ".parquet": "GeoParquet file",
    ".geoparquet": "GeoParquet file", ".shp": "shapefile", ".fgb": "FlatGeobuf file",
}  # fmt: skip
PARQUET = (".parquet", ".geoparquet")
STEPS = 1e7
"""Steps of a degree: places are rounded to them, for OpenStreetMap knows none in between."""
LINES = frozenset({"LineString", "MultiLineString"})
POINTS = frozenset({"Point", "MultiPoint"})
REMEDY = "save the lines again with a column highway, as ogr2ogr makes it of an OSM file"

Row = dict[str, Any]


def read_lines(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read lines with OpenStreetMap's tags in their columns.

    Parameters
    ----------
    path : path-like
        The file.
    classes : sequence of str
        Values of `highway` to keep.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    RoadNetwork
        The network. It claims to be from OpenStreetMap only if the lines have its ids.

    Raises
    ------
    MapDataError
        Not a file of this kind, no column for the class of roads, coordinates that are none or in
        an unknown system, or no road of these classes.
    """
    file = Path(path)
    digest = file_digest(file)
    notes: list[str] = []
    with warnings.catch_warnings(record=True) as noticed:
        warnings.simplefilter("always")
        tables = [_in_degrees(file, table, notes) for table in _tables(file)]
    notes += dict.fromkeys(
        f"reading the file: {' '.join(str(item.message).split())[:200]}" for item in noticed
    )
    counts: Counter[str] = Counter()
    lines = _Lines(file, counts)
    for table in tables:
        for row, shape in _rows(table):
            lines.add(row, shape)
    raw = raw_map(
        str(file), lines.source(file.name, digest), lines.ways, lines.nodes(),
        classes=classes, left_out=counts,
    )  # fmt: skip
    net = network_of(raw, str(file), classes, rules)
    notes.append("turn restrictions are not in this kind of file")
    return net.with_report(net.load_report.extended({}, *notes[:10]))


class _Lines:
    """Ways and nodes, as they are gathered from the rows of tables."""

    def __init__(self, file: Path, counts: Counter[str]) -> None:
        self.ways: list[MapWay] = []
        self._file, self._counts = file, counts
        self._number: dict[tuple[int, int], int] = {}
        self._tags: dict[int, dict[str, str]] = {}
        self._of_osm = False

    def add(self, row: Row, shape: Any) -> None:
        """Take a row in: a line as ways, a point as a node with tags."""
        kind = getattr(shape, "geom_type", "")
        if kind not in LINES | POINTS or shape.is_empty:
            self._counts["rows left out: neither line nor point"] += 1
            return
        tags, own = tags_of(row), id_of(row)
        self._of_osm |= bool(own)
        for part in getattr(shape, "geoms", [shape]):
            places = self._places(np.array(part.coords)[:, :2], row)
            if kind in LINES:
                self.ways.append(MapWay(own or -1 - len(self.ways), places, tags))
                if part.has_z:
                    self._note_heights(places, np.array(part.coords)[:, 2])
            elif tags:
                self._tags.setdefault(places[0], {}).update(tags)

    def _places(self, coordinates: NDArray[np.float64], row: Row) -> list[int]:
        if not (np.abs(coordinates) <= (180, 90)).all():
            lon, lat = coordinates[~(np.abs(coordinates) <= (180, 90)).all(axis=1)][0]
            raise MapDataError(
                f"{self._file}: row {row['row']} has a point at lon {lon:g}, lat {lat:g}, which is "
                "no place on earth; correct it, or tell the file's coordinate system"
            )
        steps = np.rint(coordinates * STEPS).astype(np.int64)
        known = self._number
        return [known.setdefault((lon, lat), -1 - len(known)) for lon, lat in steps.tolist()]

    def _note_heights(self, places: list[int], heights: NDArray[np.float64]) -> None:
        """Keep the heights of a line's points as those of nodes, which `ele` is."""
        # A line that was only made three-dimensional lies at nought.
        if not heights.any():
            return
        for place, height in zip(places, heights.tolist(), strict=True):
            if np.isfinite(height):
                self._tags.setdefault(place, {}).setdefault("ele", f"{height:.2f}")

    def nodes(self) -> dict[int, MapNode]:
        """Return all nodes by their numbers, which are negative, for the file gives none."""
        return {
            number: MapNode(lon / STEPS, lat / STEPS, self._tags.get(number, {}))
            for (lon, lat), number in self._number.items()
        }

    def source(self, name: str, digest: str) -> Source:
        return osm_source(name, digest) if self._of_osm else Source(name, digest)


def layers_of(file: Path) -> list[str]:
    """Return the names of a file's layers.

    Parameters
    ----------
    file : Path
        A file that GDAL reads.

    Returns
    -------
    list of str
        In their order.

    Raises
    ------
    MapDataError
        It is no such file.
    """
    import pyogrio

    try:
        with warnings.catch_warnings():
            # What GDAL warns of here it says again when a layer is read.
            warnings.simplefilter("ignore")
            return [str(name) for name in pyogrio.list_layers(file)[:, 0]]
    except (RuntimeError, ValueError, OSError) as error:
        raise MapDataError(
            f"{file}: not a {_kind(file)}, or damaged ({_one_line(error)}); {REMEDY}"
        ) from error


def _tables(file: Path) -> list[geopandas.GeoDataFrame]:
    """Return the layers that may hold roads, with column names in lower case."""
    import geopandas
    import pyogrio

    seen: dict[str, list[str]] = {}
    tables = []
    try:
        if file.suffix.lower() in PARQUET:
            table = geopandas.read_parquet(file)
            if table.geometry.name != "geometry":
                table = table.rename_geometry("geometry")
            seen[file.name] = [str(name) for name in table.columns]
            tables = [table] if holds_roads(seen[file.name]) else []
        else:
            for layer in layers_of(file):
                seen[layer] = pyogrio.read_info(file, layer=layer)["fields"].tolist()
                if holds_roads(seen[layer]):
                    tables.append(geopandas.read_file(file, layer=layer))
    except (RuntimeError, ValueError, OSError, LookupError, TypeError) as error:
        raise MapDataError(
            f"{file}: not a {_kind(file)}, or damaged ({_one_line(error)}); {REMEDY}"
        ) from error
    if not tables:
        told = "; ".join(f"{name}: {', '.join(fields[:12])}" for name, fields in seen.items())
        raise MapDataError(
            f"{file}: no layer has a column highway, fclass, tags or other_tags, which tells what "
            f"roads its lines are ({told or 'no layer at all'}); {REMEDY}"
        )
    return [
        table.rename(columns={name: str(name).lower() for name in table if name != "geometry"})
        for table in tables
        if isinstance(table, geopandas.GeoDataFrame)
    ]


def _in_degrees(
    file: Path, table: geopandas.GeoDataFrame, notes: list[str]
) -> geopandas.GeoDataFrame:
    if table.crs is not None:
        return table.to_crs(4326)
    bounds = table.total_bounds
    if len(table) and not (np.abs(bounds) <= (180, 90, 180, 90)).all():
        raise MapDataError(
            f"{file}: does not tell its coordinate system, and its coordinates are no degrees; "
            "save it again with its system, or in EPSG:4326"
        )
    notes.append("the file does not tell its coordinate system; degrees were taken")
    return table


def _rows(table: geopandas.GeoDataFrame) -> Iterator[tuple[Row, Any]]:
    shapes = table.geometry.to_numpy()
    columns = table.drop(columns="geometry")
    for number, (row, shape) in enumerate(zip(columns.to_dict("records"), shapes, strict=True), 1):
        yield {**row, "row": number}, shape


def _kind(file: Path) -> str:
    return KINDS.get(file.suffix.lower(), "file of lines")


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())[:150]
