"""The arrays of a road network: made, frozen, validated, and taken into other networks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from operator import attrgetter
from pathlib import Path
from typing import Any, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import NetworkError
from .load_report import LoadReport, Source
from .making import made_columns
from .named_points import NamedPoints
from .texts import TextTable
from .validity import check_values

__all__ = ["NetworkArrays"]

Kept = TypeVar("Kept")
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Ints = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class NetworkArrays:
    """The arrays of a directed road network of n nodes and m edges, and its texts and source.

    Edges are sorted by tail, so those that leave node v are `first_out[v]` to
    `first_out[v + 1]`. Parallel edges stay apart. All arrays are read-only. The table of columns
    is in `platoon_osm.network.columns`.

    Attributes
    ----------
    first_out : ndarray of int32, (n + 1,)
        Where the edges that leave each node begin.
    tail, head : ndarray of int32, (m,)
        Node positions.
    length_m : ndarray of float, (m,)
        Length along the shape [m].
    speed_mps : ndarray of float, (m,)
        Speed that a lone truck drives there [m/s], under the law and its speed limiter.
    posted_mps : ndarray of float, (m,)
        Speed that a vehicle of up to 3.5 t may drive there [m/s], by signs or by law.
    lon, lat : ndarray of float, (n,)
        Degrees, EPSG:4326.
    node_id : ndarray of int64, (n,)
        OpenStreetMap node ids.
    node_name, node_ref : ndarray of int32, (n,)
        Codes in `texts`: junction name and exit number.
    road_class : ndarray of uint8, (m,)
        Positions in `ROAD_CLASSES`.
    ref, name : ndarray of int32, (m,)
        Codes in `texts`: road number and road name.
    toll : ndarray of bool, (m,)
        Whether trucks pay toll.
    inferred : ndarray of bool, (m,)
        Whether the edge is not in the map but was added by the loader.
    restriction : ndarray of int32, (m,)
        Codes in `texts`: what the map restricts there and for whom, in the form of
        `network.restrictions`; empty where nothing is.
    country : ndarray of int32, (m,)
        Codes in `texts`: ISO 3166 code of the country or state, "IT" or "US-CA"; empty if unknown.
    climb_m, descent_m : ndarray of float32, (m,)
        How far the road rises and falls in the direction of travel [m], where that is known; see
        `network.grades`.
    graded_m : ndarray of float32, (m,)
        On how much of its length that is known [m].
    toll_free_m : ndarray of float32, (m,)
        On how much of its length the map says that trucks pay no toll [m].
    way_id : ndarray of int64, (m,)
        OpenStreetMap way an edge (its longest part) came from; 0 if none.
    shape_first : ndarray of int64, (m + 1,)
        Where the edge's points start in `shape_lon`, `shape_lat`; ends included.
    shape_lon, shape_lat : ndarray of float
        Points of all edges [deg], one edge behind the other.
    texts : TextTable
        All names.
    points : NamedPoints
        Service areas, rest areas and other stops for trucks, tunnels, towns.
    source : Source
        Identity of the data.
    load_report : LoadReport
        What the loader did with it.
    """

    first_out: Ints
    tail: Ints
    head: Ints
    length_m: Floats
    speed_mps: Floats
    posted_mps: Floats
    lon: Floats
    lat: Floats
    node_id: NDArray[np.int64]
    node_name: Ints
    node_ref: Ints
    road_class: NDArray[np.uint8]
    ref: Ints
    name: Ints
    toll: NDArray[np.bool_]
    inferred: NDArray[np.bool_]
    restriction: Ints
    country: Ints
    climb_m: Singles
    descent_m: Singles
    graded_m: Singles
    toll_free_m: Singles
    way_id: NDArray[np.int64]
    shape_first: NDArray[np.int64]
    shape_lon: Floats
    shape_lat: Floats
    texts: TextTable
    points: NamedPoints
    source: Source = field(default_factory=Source)
    load_report: LoadReport = field(default_factory=LoadReport)
    _file: Path | None = field(default=None, repr=False)
    _attached: dict[Any, Any] = field(init=False, default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    # -- making one ----------------------------------------------------------------------------

    @classmethod
    def from_edges(
        cls,
        tail: ArrayLike,
        head: ArrayLike,
        length_m: ArrayLike | None = None,
        *,
        lon: ArrayLike,
        lat: ArrayLike,
        texts: TextTable | None = None,
        points: NamedPoints | None = None,
        source: Source | None = None,
        report: LoadReport | None = None,
        **columns: ArrayLike | None,
    ) -> Self:
        """Sort edges by tail, fill in what is not given, validate, and freeze.

        Parameters
        ----------
        tail, head : array_like of int, (m,)
            Node positions.
        length_m : array_like of float, (m,), optional
            Length of each edge [m]; by default that of its shape.
        lon, lat : array_like of float, (n,)
            Degrees.
        texts : TextTable, optional
            What the codes in `node_name`, `node_ref`, `ref`, `name` refer to; without it these
            are plain strings.
        points : NamedPoints, optional
            Places beside the roads; their names are codes in `texts`.
        source : Source, optional
            Identity of the data.
        report : LoadReport, optional
            What the loader did.
        **columns : array_like, or one value for all
            Any other column by name, as `speed_mps` or `toll`; those not given have the default
            of the table. Shapes are given by `shape_first`, `shape_lon` and `shape_lat` together;
            without them edges are straight.

        Returns
        -------
        RoadNetwork
            With arrays of its own.

        Raises
        ------
        NetworkError
            Columns that are unknown or of the wrong size or type, ends that are no node, a
            length, speed or coordinate that is negative, not finite or off the globe.
        """
        for given, kind, what in (
            (texts, TextTable, "texts"), (points, NamedPoints, "points"),
            (source, Source, "source"), (report, LoadReport, "report"),
        ):  # fmt: skip
            if given is not None and not isinstance(given, kind):
                raise NetworkError(
                    f"network: {what} is a {type(given).__name__}; give a {kind.__name__}"
                )
        columns |= {"tail": tail, "head": head, "length_m": length_m, "lon": lon, "lat": lat}
        made, table = made_columns(columns, texts)
        arrays: dict[str, Any] = dict(made)
        net = cls(
            **arrays,
            texts=table,
            points=NamedPoints.empty() if points is None else points,
            source=source or Source(),
            load_report=report or LoadReport(),
        )
        net.validate()
        return net

    def validate(self) -> None:
        """Check values that every algorithm relies on.

        Raises
        ------
        NetworkError
            In one line: what, at which node or edge, and what would be right.
        """
        check_values(lambda name: attrgetter(name)(self), len(self.texts))

    def __reduce__(self) -> tuple[Any, ...]:
        # Made anew: arrays come back read-only, and nothing that was made of them goes along.
        values = {item.name: getattr(self, item.name) for item in fields(self) if item.init}
        return _restored, (type(self), values)

    # -- looking at it -------------------------------------------------------------------------

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.lon)

    @property
    def m(self) -> int:
        """Number of edges."""
        return len(self.tail)

    @property
    def file(self) -> Path | None:
        """The saved network it was opened from, None where it was made in memory."""
        return self._file

    def attached(self, kind: Callable[[Self], Kept]) -> Kept:
        """Return what a class or function makes of this network, made once and kept with it.

        Upper rooms keep here what depends on the network alone: an index of its names, its
        searches. It is neither saved nor pickled, nor handed on to a network of other arrays.

        Parameters
        ----------
        kind : callable
            Makes it of a network; it is found again by this same callable.

        Returns
        -------
        Kept
            What `kind` returned the first time.
        """
        if kind not in self._attached:
            self._attached[kind] = kind(self)
        kept: Kept = self._attached[kind]
        return kept

    def with_report(self, report: LoadReport) -> Self:
        """Return the same network with another load report.

        Parameters
        ----------
        report : LoadReport
            The other one.

        Returns
        -------
        RoadNetwork
            With the same arrays, and all that was made of them.
        """
        other = replace(self, load_report=report)
        # The arrays are the same, so what was made of them holds for both.
        object.__setattr__(other, "_attached", self._attached)
        return other


def _restored(kind: type[Any], values: dict[str, Any]) -> Any:
    """Make a network again from what was pickled or copied.

    Its file is what a hierarchy is found beside, so that worker processes need not make their own;
    where there is no such file, as on another machine, the network is one made in memory.
    """
    file = values["_file"]
    return kind(**{**values, "_file": file if file is not None and file.is_file() else None})
