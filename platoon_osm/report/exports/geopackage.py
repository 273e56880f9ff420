"""GeoPackages that are whole: the same bytes each time, and checked before anybody gets them.

GDAL tells of a full disk at some moments and is silent at others, so what it wrote is opened again
and counted.
"""

from __future__ import annotations

import logging
import os
import sqlite3
import threading
import warnings
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from ...shown_text import shortened

__all__ = ["Layer", "changed_at", "write_layers"]

LONGEST = 120
"""Characters of what GDAL and SQLite say."""

COUNTING = ("insert", "delete")
"""What changes the count of rows that GDAL keeps, each by a trigger."""
INDEXING = ("insert", "delete", "update")
"""What changes a spatial index, each by one trigger or more."""

FIRST_MOMENT = datetime(1970, 1, 1, tzinfo=UTC)

_one_at_a_time = threading.Lock()
"""What GDAL takes for the hour is one setting of the whole process."""


@dataclass(frozen=True, slots=True)
class Layer:
    """A layer of a GeoPackage.

    Attributes
    ----------
    name : str
        What it is called.
    frame : DataFrame or GeoDataFrame
        Its rows.
    geometry : str or None
        "Point", "LineString" or "MultiLineString"; None for a table without shapes.
    key : str
        What its column of row numbers is called.
    """

    name: str
    frame: Any
    geometry: str | None
    key: str = "fid"


def write_layers(draft: Path, layers: Sequence[Layer], data_of: str) -> None:
    """Write layers as a GeoPackage, and make sure that it holds them.

    A GeoPackage says when each layer was last changed. So that the same plan gives the same bytes,
    that is the moment of `SOURCE_DATE_EPOCH`, if the environment has it; else that of the map's
    data; else the beginning of 1970.

    Parameters
    ----------
    draft : Path
        Where to write; no file yet.
    layers : sequence of Layer
        In the order in which they are written.
    data_of : str
        When the data was cut from the map, ISO 8601, or empty.

    Raises
    ------
    OSError
        It cannot be written, or what was written is not whole.
    """
    import pyogrio

    errors = (pyogrio.errors.DataSourceError, pyogrio.errors.DataLayerError)
    with _one_at_a_time, _quiet_gdal(), _dated(changed_at(data_of)):
        for layer in layers:
            try:
                pyogrio.write_dataframe(
                    layer.frame, draft, layer=layer.name, driver="GPKG", append=draft.exists(),
                    geometry_type=layer.geometry, FID=layer.key,
                )  # fmt: skip
            except (*errors, pyogrio.errors.FeatureError, RuntimeError) as error:
                # As an OSError it is told like any other failure to write.
                raise OSError(f"layer {layer.name}: {_said(error)}") from error
            except UnicodeEncodeError as error:  # of the folder it lies in
                raise OSError("GDAL opens no path that is no UTF-8") from error
    _check(draft, layers)


def changed_at(data_of: str) -> datetime:
    """Return the moment that a GeoPackage says it was changed at.

    Parameters
    ----------
    data_of : str
        When the data was cut from the map, ISO 8601, or empty.

    Returns
    -------
    datetime
        In UTC.
    """
    try:
        return datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), UTC)
    except (KeyError, ValueError, OverflowError, OSError):
        pass
    try:
        moment = datetime.fromisoformat(data_of)
        return moment.replace(tzinfo=UTC) if moment.tzinfo is None else moment.astimezone(UTC)
    except (ValueError, OverflowError):
        return FIRST_MOMENT


@contextmanager
def _dated(moment: datetime) -> Iterator[None]:
    import pyogrio

    text = f"{moment:%Y-%m-%dT%H:%M:%S}.000Z"
    pyogrio.set_gdal_config_options({"OGR_CURRENT_DATE": text})
    try:
        yield
    finally:
        pyogrio.set_gdal_config_options({"OGR_CURRENT_DATE": None})


@contextmanager
def _quiet_gdal() -> Iterator[None]:
    """Keep GDAL's own words about what fails off the terminal; what matters is raised or found."""
    log = logging.getLogger("pyogrio")
    before = log.level
    log.setLevel(logging.CRITICAL + 1)
    try:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", category=RuntimeWarning, module="pyogrio")
            yield
    finally:
        log.setLevel(before)


def _said(error: BaseException) -> str:
    """Return why GDAL failed, without the statements of SQL that it quotes."""
    told = (str(error).splitlines() or [type(error).__name__])[0]
    return shortened(told.rpartition("failed: ")[2], LONGEST)


def _check(draft: Path, layers: Sequence[Layer]) -> None:
    try:
        with closing(sqlite3.connect(f"{draft.absolute().as_uri()}?mode=ro", uri=True)) as file:
            said = [row[0] for row in file.execute("PRAGMA integrity_check")]
            if said != ["ok"]:
                raise OSError(f"it came out damaged: {shortened(said[0], LONGEST)}")
            for layer in layers:
                if missing := _missing(file, layer):
                    raise OSError(f"layer {layer.name} came out without {missing}")
    except sqlite3.Error as error:
        raise OSError(f"it came out incomplete, as on a full disk: {error}") from error


def _missing(file: sqlite3.Connection, layer: Layer) -> str:
    """Return what a layer lacks; GDAL adds spatial index and triggers last, and may fail silently.

    Returns
    -------
    str
        In words; empty if it is whole.
    """
    rows, name = len(layer.frame), layer.name

    def number(question: str) -> int:
        found = file.execute(question, {"layer": name}).fetchone()
        return int(found[0]) if found and found[0] is not None else -1

    triggers = "SELECT COUNT(*) FROM sqlite_master WHERE type = 'trigger' AND tbl_name = :layer"
    if number(f'SELECT COUNT(*) FROM "{name}"') != rows:
        return "some of its rows"
    if number("SELECT feature_count FROM gpkg_ogr_contents WHERE table_name = :layer") != rows:
        return "the count of its rows"
    if layer.geometry is None:
        return "" if number(triggers) >= len(COUNTING) else "its triggers"
    if number(f'SELECT COUNT(*) FROM "rtree_{name}_geom"') != rows:
        return "its spatial index"
    if rows and number("SELECT max_y IS NOT NULL FROM gpkg_contents WHERE table_name = :layer") < 1:
        return "its extent"
    if number("SELECT COUNT(*) FROM gpkg_extensions WHERE table_name = :layer") < 1:
        return "the entry of its spatial index"
    return "" if number(triggers) >= len(COUNTING) + len(INDEXING) else "its triggers"
