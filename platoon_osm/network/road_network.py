"""The road network: a directed graph as read-only arrays, with shapes, names and its source."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import NetworkError
from ..offers import offered
from .geodesy import distance_m
from .load_report import LoadReport, Source
from .location import Location, Role
from .shapes import ragged_order, shape_lengths_m
from .texts import TextTable, encode_texts

if TYPE_CHECKING:
    import geopandas
    import networkx

__all__ = ["POINT_KINDS", "ROAD_CLASSES", "NamedPoints", "RoadNetwork"]

ROAD_CLASSES = (
    "motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link",
    "secondary", "secondary_link", "tertiary", "tertiary_link", "other",
)  # fmt: skip
POINT_KINDS = ("services", "rest_area", "city", "town", "village")

Kept = TypeVar("Kept")
Floats = NDArray[np.float64]
Ints = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class NamedPoints:
    """Places beside the roads: service and rest areas, and the towns that give orientation.

    Attributes
    ----------
    lon, lat : (p,) degrees.
    kind : (p,) position in `POINT_KINDS`.
    name : (p,) code in the network's texts.
    population : (p,) inhabitants, 0 where not known.
    """

    lon: Floats
    lat: Floats
    kind: NDArray[np.uint8]
    name: Ints
    population: NDArray[np.int64]

    @classmethod
    def empty(cls) -> NamedPoints:
        """No places at all."""
        return cls(
            np.zeros(0), np.zeros(0), np.zeros(0, np.uint8), np.zeros(0, np.int32),
            np.zeros(0, np.int64),
        )  # fmt: skip

    def __len__(self) -> int:
        return len(self.lon)


@dataclass(frozen=True, slots=True, eq=False)
class RoadNetwork:
    """A directed road network of n nodes and m edges; an edge's id is its array position.

    Edges are sorted by tail, so those that leave node v are `first_out[v]` to
    `first_out[v + 1]`. Parallel edges stay apart. All arrays are read-only.

    Attributes
    ----------
    first_out : (n + 1,) int32
    tail, head : (m,) int32 node positions.
    length_m, speed_mps : (m,) length along the shape, and the speed a lone truck drives there.
    lon, lat : (n,) degrees, EPSG:4326.
    node_id : (n,) int64 OpenStreetMap node ids.
    node_name, node_ref : (n,) codes in `texts`: junction name and exit number.
    road_class : (m,) uint8 positions in `ROAD_CLASSES`.
    ref, name : (m,) codes in `texts`.
    toll, inferred : (m,) bool; inferred edges are not in the map but were added by the loader.
    way_id : (m,) int64 OpenStreetMap way an edge (its longest part) came from; 0 if none.
    shape_first : (m + 1,) int64 where the edge's points start in `shape_lon`, `shape_lat`; ends
        included.
    texts : all names.
    points : service areas, rest areas, towns.
    source, load_report : identity of the data, and what the loader did with it.
    """

    first_out: Ints
    tail: Ints
    head: Ints
    length_m: Floats
    speed_mps: Floats
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
    way_id: NDArray[np.int64]
    shape_first: NDArray[np.int64]
    shape_lon: Floats
    shape_lat: Floats
    texts: TextTable
    points: NamedPoints
    source: Source = field(default_factory=Source)
    load_report: LoadReport = field(default_factory=LoadReport)
    _kept: dict[str, Any] = field(default_factory=dict, repr=False)
    _file: Path | None = field(default=None, repr=False)
    _attached: dict[Any, Any] = field(init=False, default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        for owner in (self, self.points):
            for item in fields(owner):
                value = getattr(owner, item.name)
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
        speed_mps: ArrayLike | float = 80 / 3.6,
        node_id: ArrayLike | None = None,
        node_name: ArrayLike | None = None,
        node_ref: ArrayLike | None = None,
        road_class: ArrayLike | None = None,
        ref: ArrayLike | None = None,
        name: ArrayLike | None = None,
        toll: ArrayLike | None = None,
        inferred: ArrayLike | None = None,
        way_id: ArrayLike | None = None,
        shape_first: ArrayLike | None = None,
        shape_lon: ArrayLike | None = None,
        shape_lat: ArrayLike | None = None,
        texts: TextTable | None = None,
        points: NamedPoints | None = None,
        source: Source | None = None,
        report: LoadReport | None = None,
    ) -> RoadNetwork:
        """Sort edges by tail, fill in what is not given, validate, and freeze.

        Parameters
        ----------
        tail, head : (m,) node positions.
        length_m : (m,) metres; by default the length of the edge's shape.
        lon, lat : (n,) degrees.
        node_name, node_ref, ref, name : codes in `texts`; with no `texts`, plain strings.

        Raises
        ------
        NetworkError
            Sizes that differ, ends that are no node, a length, speed or coordinate that is
            negative, not finite or off the globe.
        """
        tails = np.ascontiguousarray(tail, np.int32)
        heads = np.ascontiguousarray(head, np.int32)
        lons, lats = np.array(lon, np.float64), np.array(lat, np.float64)
        n, m = len(lons), len(tails)
        if texts is None:
            columns: list[list[str]] = [
                [""] * size if column is None else [str(text) for text in np.asarray(column)]
                for column, size in ((node_name, n), (node_ref, n), (ref, m), (name, m))
            ]
            texts, (node_name, node_ref, ref, name) = encode_texts(*columns)
        for label, values, size in (
            ("head", heads, m), ("length_m", length_m, m), ("speed_mps", speed_mps, m),
            ("lat", lats, n), ("node_id", node_id, n), ("node_name", node_name, n),
            ("node_ref", node_ref, n), ("road_class", road_class, m), ("ref", ref, m),
            ("name", name, m), ("toll", toll, m), ("inferred", inferred, m),
            ("way_id", way_id, m), ("shape_first", shape_first, m + 1),
        ):  # fmt: skip
            if values is not None and np.ndim(values) and np.shape(values) != (size,):
                raise NetworkError(
                    f"network: {label} has shape {np.shape(values)}; {n} nodes and {m} edges "
                    f"need ({size},)"
                )
        bad = (tails < 0) | (tails >= n) | (heads < 0) | (heads >= n)
        if bad.any():
            raise NetworkError(
                f"network: {int(bad.sum())} of {m} edges end at no node (first: edge "
                f"{int(np.argmax(bad))}); node positions run from 0 to {n - 1}"
            )
        if shape_first is None or shape_lon is None or shape_lat is None:
            ends = np.column_stack([tails, heads]).ravel()
            shape_first = 2 * np.arange(m + 1, dtype=np.int64)
            shape_lon, shape_lat = lons[ends], lats[ends]
        first = np.asarray(shape_first, np.int64)
        shape_lons, shape_lats = (
            np.asarray(shape_lon, np.float64),
            np.asarray(shape_lat, np.float64),
        )
        if len(shape_lons) != first[-1] or len(shape_lats) != first[-1] or first[0] != 0:
            raise NetworkError(
                f"network: shapes have {len(shape_lons)} lon and {len(shape_lats)} lat for points "
                f"{first[0]} to {first[-1]}; shape_first must run from 0 to their number"
            )
        if (np.diff(first) < 2).any():
            raise NetworkError("network: every edge needs a shape of two points or more")
        if length_m is None:
            length_m = shape_lengths_m(first, shape_lons, shape_lats)
        order = np.argsort(tails, kind="stable")
        points_order, shape_firsts = ragged_order(first, order)
        first_out = np.zeros(n + 1, np.int32)
        np.cumsum(np.bincount(tails, minlength=n), out=first_out[1:])

        def per_edge(values: ArrayLike | None, dtype: Any, default: float = 0) -> Any:
            if values is None:
                return np.full(m, default, dtype)
            array = np.broadcast_to(np.asarray(values, dtype), (m,))
            return array[order]

        def per_node(values: ArrayLike | None, dtype: Any) -> Any:
            return np.zeros(n, dtype) if values is None else np.array(values, dtype)

        net = cls(
            first_out=first_out,
            tail=tails[order],
            head=heads[order],
            length_m=per_edge(length_m, np.float64),
            speed_mps=per_edge(speed_mps, np.float64),
            lon=lons,
            lat=lats,
            node_id=np.arange(n, dtype=np.int64)
            if node_id is None
            else np.array(node_id, np.int64),
            node_name=per_node(node_name, np.int32),
            node_ref=per_node(node_ref, np.int32),
            road_class=per_edge(road_class, np.uint8),
            ref=per_edge(ref, np.int32),
            name=per_edge(name, np.int32),
            toll=per_edge(toll, np.bool_),
            inferred=per_edge(inferred, np.bool_),
            way_id=per_edge(way_id, np.int64),
            shape_first=shape_firsts,
            shape_lon=shape_lons[points_order],
            shape_lat=shape_lats[points_order],
            texts=texts,
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
        off_globe = ~((np.abs(self.lon) <= 180) & (np.abs(self.lat) <= 90))
        if off_globe.any():
            v = int(np.argmax(off_globe))
            raise NetworkError(
                f"network: node {self.node_id[v]} lies at lon {self.lon[v]}, lat {self.lat[v]}; "
                "coordinates must be degrees within [-180, 180] and [-90, 90]"
            )
        for label, values, allowed in (
            ("length", self.length_m, self.length_m >= 0),
            ("speed", self.speed_mps, self.speed_mps > 0),
        ):
            wrong = ~(allowed & np.isfinite(values))
            if wrong.any():
                e = int(np.argmax(wrong))
                raise NetworkError(
                    f"network: edge {e} (way {self.way_id[e]}) has {label} {values[e]}; "
                    f"a {label} must be finite and {'above' if label == 'speed' else 'not below'} 0"
                )
        off_globe = ~((np.abs(self.shape_lon) <= 180) & (np.abs(self.shape_lat) <= 90))
        if off_globe.any():
            at = int(np.argmax(off_globe))
            e = int(np.searchsorted(self.shape_first, at, "right")) - 1
            raise NetworkError(
                f"network: edge {e} (way {self.way_id[e]}) passes lon {self.shape_lon[at]}, lat "
                f"{self.shape_lat[at]}; coordinates must be degrees within ±180 and ±90"
            )

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

    def __repr__(self) -> str:
        return (
            f"<RoadNetwork {self.source.name}: {self.n:,} nodes, {self.m:,} edges, "
            f"{self.length_m.sum() / 1000:,.0f} km>"
        )

    def report(self) -> LoadReport:
        """Return what the loader kept, dropped, capped and defaulted."""
        return self.load_report

    def shape(self, edge: int) -> Floats:
        """Return the points of an edge, (k, 2) lon and lat, from its tail to its head."""
        part = slice(self.shape_first[edge], self.shape_first[edge + 1])
        return np.column_stack([self.shape_lon[part], self.shape_lat[part]])

    def path_shape(self, edges: ArrayLike) -> Floats:
        """Return the points of a path of edges, (k, 2), without the doubled joints."""
        ids = np.asarray(edges, np.int64)
        if not len(ids):
            return np.zeros((0, 2))
        order, first = ragged_order(self.shape_first, ids)
        keep = np.ones(len(order), bool)
        keep[first[1:-1]] = False
        return np.column_stack([self.shape_lon[order[keep]], self.shape_lat[order[keep]]])

    def path_nodes(self, edges: ArrayLike) -> NDArray[np.int64]:
        """Return the k + 1 nodes that k consecutive edges pass."""
        ids = np.asarray(edges, np.int64)
        if not len(ids):
            return np.zeros(0, np.int64)
        return np.concatenate([self.tail[ids[:1]], self.head[ids]]).astype(np.int64)

    def edge_ref(self, edge: int) -> str:
        """Return the road number of an edge ("A 4"), empty if it has none."""
        return str(self.texts[self.ref[edge]])

    def edge_name(self, edge: int) -> str:
        """Return the road name of an edge, empty if it has none."""
        return str(self.texts[self.name[edge]])

    def junction_name(self, node: int) -> str:
        """Return the name signed at a node, empty if it has none."""
        return str(self.texts[self.node_name[node]])

    def incident_refs(self, node: int) -> tuple[str, ...]:
        """Return the road numbers that meet at a node, sorted."""
        ins, first_in = self.incoming()
        edges = np.concatenate(
            [
                np.arange(self.first_out[node], self.first_out[node + 1]),
                ins[first_in[node] : first_in[node + 1]],
            ]
        )
        return tuple(sorted({self.edge_ref(int(e)) for e in edges} - {""}))

    def place_name(self, node: int) -> str:
        """Return a name people understand for any node.

        The junction's name; else its exit number with the road; else the road and the nearest
        town; else the coordinates.
        """
        if name := self.junction_name(node):
            return name
        road = " / ".join(self.incident_refs(node)[:2])
        if number := self.texts[self.node_ref[node]]:
            return f"{road} exit {number}".strip()
        where = format_position(float(self.lon[node]), float(self.lat[node]))
        near = self._nearest_town(node)
        return f"{road or 'road'} near {near}" if near else f"{road} at {where}".strip()

    def _nearest_town(self, node: int) -> str:
        towns = np.flatnonzero(self.points.kind >= POINT_KINDS.index("city"))
        if not len(towns):
            return ""
        away = distance_m(
            self.points.lon[towns], self.points.lat[towns], self.lon[node], self.lat[node]
        )
        nearest = int(np.argmin(away))
        return self.texts[self.points.name[towns[nearest]]] if away[nearest] < 50_000 else ""

    def incoming(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return edge ids sorted by head (m,), and where each node's begin (n + 1,)."""
        if "incoming" not in self._kept:
            order = np.argsort(self.head, kind="stable")
            first = np.zeros(self.n + 1, np.int64)
            np.cumsum(np.bincount(self.head, minlength=self.n), out=first[1:])
            self._kept["incoming"] = order, first
        kept: tuple[NDArray[np.int64], NDArray[np.int64]] = self._kept["incoming"]
        return kept

    def attached(self, kind: Callable[[RoadNetwork], Kept]) -> Kept:
        """Return what a class makes of this network, made once and kept as long as the network.

        Upper rooms keep here what depends on the network alone: an index of its names, its
        searches. It is not saved, nor pickled.
        """
        if kind not in self._attached:
            self._attached[kind] = kind(self)
        kept: Kept = self._attached[kind]
        return kept

    def strong_component(self) -> NDArray[np.int32]:
        """Return the strongly connected part of each node (n,); part 0 has the most road."""
        if "strong" not in self._kept:
            from scipy.sparse import csr_array
            from scipy.sparse.csgraph import connected_components

            graph = csr_array(
                (np.ones(self.m, np.int8), self.head, self.first_out), shape=(self.n, self.n)
            )
            count, label = connected_components(graph, directed=True, connection="strong")
            inside = label[self.tail] == label[self.head]
            km = np.bincount(label[self.tail[inside]], self.length_m[inside], minlength=count)
            rank = np.empty(count, np.int32)
            rank[np.argsort(-km, kind="stable")] = np.arange(count)
            self._kept["strong"] = rank[label]
        kept: NDArray[np.int32] = self._kept["strong"]
        return kept

    def connected_share(self) -> float:
        """Return the share [0, 1] of mapped road, by length, in strong component 0."""
        main = self.strong_component() == 0
        mapped = ~self.inferred
        inside = mapped & main[self.tail] & main[self.head]
        return float(self.length_m[inside].sum() / max(self.length_m[mapped].sum(), 1e-9))

    def identity(self) -> str:
        """Return a short hash of the graph itself: nodes, edges, lengths and speeds."""
        if "identity" not in self._kept:
            digest = hashlib.sha256()
            for array in (self.tail, self.head, self.length_m, self.speed_mps, self.node_id):
                digest.update(array.tobytes())
            self._kept["identity"] = digest.hexdigest()[:16]
        return str(self._kept["identity"])

    # -- changing it into another --------------------------------------------------------------

    def reversed(self) -> tuple[RoadNetwork, NDArray[np.int64]]:
        """Return the network with every edge turned round, and for each new edge its old id."""
        points, first = ragged_order(self.shape_first, np.arange(self.m), backwards=True)
        order = np.argsort(self.head, kind="stable")
        turned = RoadNetwork.from_edges(
            self.head, self.tail, self.length_m, lon=self.lon, lat=self.lat,
            speed_mps=self.speed_mps, node_id=self.node_id, node_name=self.node_name,
            node_ref=self.node_ref, road_class=self.road_class, ref=self.ref, name=self.name,
            toll=self.toll, inferred=self.inferred, way_id=self.way_id, shape_first=first,
            shape_lon=self.shape_lon[points], shape_lat=self.shape_lat[points], texts=self.texts,
            points=self.points, source=self.source, report=self.load_report,
        )  # fmt: skip
        return turned, order

    def with_report(self, report: LoadReport) -> RoadNetwork:
        """Return the same network with another load report."""
        other = replace(self, load_report=report)
        # The arrays are the same, so what was made of them holds for both.
        object.__setattr__(other, "_attached", self._attached)
        return other

    # -- what upper rooms offer ----------------------------------------------------------------

    def locate(self, place: Any, role: Role = "any") -> Location:
        """Find the node of a place; see `platoon_osm.network.locate.locate`."""
        return offered("locate")(self, place, role)  # type: ignore[no-any-return]

    def save(self, path: Any) -> None:
        """Write the project's own form; see `platoon_osm.network.saved.store.save_network`."""
        offered("save_network")(self, path)

    def to_networkx(self) -> networkx.MultiDiGraph[int]:
        """Return an OSMnx-style graph; see `platoon_osm.sources.graphs.exchange.to_networkx`."""
        return offered("to_networkx")(self)  # type: ignore[no-any-return]

    @classmethod
    def from_networkx(cls, graph: Any) -> RoadNetwork:
        """Read an OSMnx-style graph; see `platoon_osm.sources.graphs.exchange.from_networkx`."""
        return offered("from_networkx")(graph)  # type: ignore[no-any-return]

    def to_geodataframes(self) -> tuple[geopandas.GeoDataFrame, geopandas.GeoDataFrame]:
        """Return nodes and edges as GeoDataFrames in EPSG:4326."""
        return offered("to_geodataframes")(self)  # type: ignore[no-any-return]


def format_position(lon: float, lat: float) -> str:
    """Return coordinates as people write them: 45.070 N 7.690 E."""
    north, east = "N" if lat >= 0 else "S", "E" if lon >= 0 else "W"
    return f"{abs(lat):.3f} {north} {abs(lon):.3f} {east}"
