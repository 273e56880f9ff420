"""The road network: a directed graph as read-only arrays, with shapes, names and its source."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import NetworkError
from ..offers import offered
from .access import STANDARD_ACCESS, Access
from .arrays import NetworkArrays
from .columns import POINT_KINDS, ROAD_CLASSES, STOP_KINDS, columns_per
from .components import connected_share, strong_components
from .load_report import LoadReport
from .location import Location, Role, format_position
from .making import checked_edges
from .named_points import NamedPoints
from .shapes import ragged_order
from .topology import identity_of, incoming_edges

if TYPE_CHECKING:
    import geopandas
    import networkx

    from .road_stop import RoadStop

__all__ = [
    "POINT_KINDS",
    "ROAD_CLASSES",
    "STOP_KINDS",
    "NamedPoints",
    "RoadNetwork",
    "checked_network",
    "format_position",
]

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

SHAPE = frozenset({"shape_first", "shape_lon", "shape_lat"})


class RoadNetwork(NetworkArrays):
    """A directed road network of n nodes and m edges; an edge's id is its array position.

    Its arrays are those of `NetworkArrays`; here is what people ask of them.
    """

    __slots__ = ()

    # -- telling it from others ----------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        """Whether all that is saved of a road is the same: arrays, texts, points and source.

        What a loader counted, and which file it was opened from, make no other network.
        """
        if self is other:
            return True
        if not isinstance(other, RoadNetwork):
            return NotImplemented
        return (
            self.source == other.source
            and all(
                np.array_equal(getattr(self, column.name), getattr(other, column.name))
                for column in columns_per("node", "edge", "offset", "shape point")
            )
            and self.points == other.points
            and self.texts == other.texts
        )

    def __hash__(self) -> int:
        return hash(self.identity())

    # -- looking at it -------------------------------------------------------------------------

    def __repr__(self) -> str:
        return (
            f"<RoadNetwork {self.source.name}: {self.n:,} nodes, {self.m:,} edges, "
            f"{self.length_m.sum() / 1000:,.0f} km>"
        )

    def _repr_html_(self) -> str:
        """Return what a notebook shows of the network."""
        return offered("network_table")(self)  # type: ignore[no-any-return]  # offered by name

    def report(self) -> LoadReport:
        """Return what the loader kept, dropped, capped and defaulted."""
        return self.load_report

    def shape(self, edge: int) -> Floats:
        """Return the points of an edge, (k, 2) lon and lat, from its tail to its head.

        Parameters
        ----------
        edge : int
            Edge id.

        Returns
        -------
        ndarray of float
            Longitude and latitude [deg], (k, 2).
        """
        part = slice(self.shape_first[edge], self.shape_first[edge + 1])
        return np.column_stack([self.shape_lon[part], self.shape_lat[part]])

    def path_shape(self, edges: ArrayLike) -> Floats:
        """Return the points of a path of edges, (k, 2), without the doubled joints.

        Parameters
        ----------
        edges : array_like
            Edge ids.

        Returns
        -------
        ndarray of float
            Longitude and latitude [deg], (k, 2).
        """
        ids = np.asarray(edges, np.int64)
        if not len(ids):
            return np.zeros((0, 2))
        order, first = ragged_order(self.shape_first, ids)
        keep = np.ones(len(order), bool)
        keep[first[1:-1]] = False
        return np.column_stack([self.shape_lon[order[keep]], self.shape_lat[order[keep]]])

    def path_nodes(self, edges: ArrayLike) -> NDArray[np.int64]:
        """Return the k + 1 nodes that k consecutive edges pass.

        Parameters
        ----------
        edges : array_like
            Edge ids.

        Returns
        -------
        ndarray of int64
            Node positions, (k + 1,).
        """
        ids = np.asarray(edges, np.int64)
        if not len(ids):
            return np.zeros(0, np.int64)
        return np.concatenate([self.tail[ids[:1]], self.head[ids]]).astype(np.int64)

    def edge_ref(self, edge: int) -> str:
        """Return the road number of an edge ("A 4"), empty if it has none.

        Parameters
        ----------
        edge : int
            Edge id.

        Returns
        -------
        str
            Road number.
        """
        return str(self.texts[self.ref[edge]])

    def edge_name(self, edge: int) -> str:
        """Return the road name of an edge, empty if it has none.

        Parameters
        ----------
        edge : int
            Edge id.

        Returns
        -------
        str
            Road name.
        """
        return str(self.texts[self.name[edge]])

    def junction_name(self, node: int) -> str:
        """Return the name signed at a node, empty if it has none.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        str
            Name.
        """
        return str(self.texts[self.node_name[node]])

    def incident_refs(self, node: int) -> tuple[str, ...]:
        """Return the road numbers that meet at a node, sorted.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        tuple of str
            Road numbers.
        """
        ins, first_in = self.incoming()
        edges = np.concatenate(
            [
                np.arange(self.first_out[node], self.first_out[node + 1]),
                ins[first_in[node] : first_in[node + 1]],
            ]
        )
        return tuple(sorted({self.edge_ref(int(e)) for e in edges} - {""}))

    def exit_number(self, node: int) -> str:
        """Return the number signed at a node ("519B", "12A;12B"), empty if it has none.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        str
            Number.
        """
        return str(self.texts[self.node_ref[node]])

    def place_name(self, node: int) -> str:
        """Return a name people understand for any node.

        The junction's name; else its road and exit number, with the nearest town; else the road
        near that town; else the coordinates. See `platoon_osm.network.naming.node_name`.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        str
            A name.
        """
        return offered("place_name")(self, node)  # type: ignore[no-any-return]  # offered by name

    # -- what follows from it ------------------------------------------------------------------

    def incoming(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return the edges by the node they lead to.

        Returns
        -------
        edges : ndarray of int64, (m,)
            Edge ids sorted by head.
        first : ndarray of int64, (n + 1,)
            Where those that arrive at each node begin.
        """
        return self.attached(incoming_edges)

    def strong_component(self) -> Ints:
        """Return the strongly connected part of each node; part 0 has the most road.

        Returns
        -------
        ndarray of int32, (n,)
            Numbers of parts.
        """
        return self.attached(strong_components)

    def connected_share(self) -> float:
        """Return the share of mapped road, by length, in strong component 0.

        Returns
        -------
        float
            Between 0 and 1.
        """
        return connected_share(self, self.strong_component(), ~self.inferred)

    def identity(self) -> str:
        """Return a short hash of the graph itself: nodes, edges, lengths and speeds.

        Returns
        -------
        str
            16 hex digits.
        """
        return self.attached(identity_of)

    # -- changing it into another --------------------------------------------------------------

    def with_columns(self, **columns: ArrayLike) -> Self:
        """Return the network with some columns replaced, edges sorted anew, values validated.

        Parameters
        ----------
        **columns : array_like, or one value for all
            Columns by name. If the number of nodes or edges changes, all columns of that kind.

        Returns
        -------
        RoadNetwork
            With the same texts, points, source and report, but no file.

        Raises
        ------
        NetworkError
            As in `from_edges`.
        """
        own: dict[str, Any] = {
            column.name: getattr(self, column.name)
            for column in columns_per("node", "edge", "offset", "shape point")
            if column.name != "first_out"
        }
        return self.from_edges(
            **{**own, **columns},
            texts=self.texts,
            points=self.points,
            source=self.source,
            report=self.load_report,
        )

    def take(self, edges: ArrayLike, **changed: ArrayLike) -> Self:
        """Return the network with these edges alone; all nodes stay.

        Parameters
        ----------
        edges : array_like of int, (k,)
            Edge ids, repeats allowed; in the new network they are sorted by tail, and those of
            one tail stay in this order.
        **changed : array_like, (k,) or one value for all
            Columns with other values than these edges have, in their order before the sort;
            columns of nodes and points of shapes may be replaced likewise.

        Returns
        -------
        RoadNetwork
            With the same texts, points, source and report.

        Raises
        ------
        NetworkError
            An edge that is none, or a column as in `from_edges`.
        """
        ids = checked_edges(edges, self.m)
        taken: dict[str, Any] = {
            column.name: getattr(self, column.name)[ids]
            for column in columns_per("edge")
            if column.name not in changed
        }
        if not changed.keys() >= SHAPE:
            points, first = ragged_order(self.shape_first, ids)
            taken["shape_first"] = first
            taken |= {
                column.name: getattr(self, column.name)[points]
                for column in columns_per("shape point")
            }
        return self.with_columns(**{**taken, **changed})

    def reversed(self) -> tuple[Self, NDArray[np.int64]]:
        """Return the network with every edge turned round.

        Returns
        -------
        network : RoadNetwork
            The same nodes and edges, from head to tail.
        edges : ndarray of int64, (m,)
            The old id of each new edge.
        """
        points, first = ragged_order(self.shape_first, np.arange(self.m), backwards=True)
        turned = self.with_columns(
            tail=self.head,
            head=self.tail,
            shape_first=first,
            shape_lon=self.shape_lon[points],
            shape_lat=self.shape_lat[points],
            climb_m=self.descent_m,
            descent_m=self.climb_m,
        )
        return turned, np.argsort(self.head, kind="stable")

    # -- what upper rooms offer ----------------------------------------------------------------

    def locate(
        self,
        place: Any = None,
        role: Role = "any",
        *,
        osmid: Any = None,
        label: Any = None,
        access: Access = STANDARD_ACCESS,
    ) -> Location:
        """Find the node of a place; see `platoon_osm.network.locate.locate`.

        Parameters
        ----------
        place : object
            A node, a (lon, lat) pair, a `Location`, a `Place` or a name.
        role : Role
            "origin", "destination" or "any".
        osmid : int, optional
            Id of an OpenStreetMap node, instead of `place`.
        label : str, optional
            What the place is to be called.
        access : Access
            Of a point: what counts as on the road, and how far beside it a place may be.

        Returns
        -------
        Location
            The place.
        """
        found: Location = offered("locate")(
            self, place, role, osmid=osmid, label=label, access=access
        )
        return found

    def stops(self) -> tuple[RoadStop, ...]:
        """Return where trucks may stop beside the roads; see `platoon_osm.network.stops`.

        Returns
        -------
        tuple of RoadStop
            Rest areas, service areas, parkings, fuel and charging, with where the road is left.
        """
        found: tuple[RoadStop, ...] = offered("road_stops")(self)
        return found

    def save(self, path: Any) -> None:
        """Write the project's own form; see `platoon_osm.network.saved.store.save_network`.

        Parameters
        ----------
        path : object
            The file.
        """
        offered("save_network")(self, path)

    def to_networkx(self) -> networkx.MultiDiGraph[int]:
        """Return an OSMnx-style graph; see `platoon_osm.sources.graphs.exchange.to_networkx`."""
        return offered("to_networkx")(self)  # type: ignore[no-any-return]  # offered by name

    @classmethod
    def from_networkx(cls, graph: Any) -> RoadNetwork:
        """Read an OSMnx-style graph; see `platoon_osm.sources.graphs.exchange.from_networkx`.

        Parameters
        ----------
        graph : object
            The graph.

        Returns
        -------
        RoadNetwork
            The network.
        """
        return offered("from_networkx")(graph)  # type: ignore[no-any-return]  # offered by name

    def to_geodataframes(self) -> tuple[geopandas.GeoDataFrame, geopandas.GeoDataFrame]:
        """Return nodes and edges as GeoDataFrames in EPSG:4326."""
        return offered("to_geodataframes")(self)  # type: ignore[no-any-return]  # offered by name


def checked_network(net: Any) -> RoadNetwork:
    """Refuse what is no road network.

    Parameters
    ----------
    net : object
        What somebody gave.

    Returns
    -------
    RoadNetwork
        The same.

    Raises
    ------
    NetworkError
        It is none.
    """
    if not isinstance(net, RoadNetwork):
        raise NetworkError(
            f"network: a {type(net).__name__} is no road network; load one with load_network"
        )
    return net
