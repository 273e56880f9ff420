"""The paper's random network and trips: Table 1, with the choices it leaves open as options.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole
from ..network.load_report import LoadReport, Source
from ..network.road_network import RoadNetwork
from ..network.texts import TextTable

__all__ = ["Draw", "RandomNetwork"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

METRES_PER_DEGREE = (111_319.5, 110_574.3)
"""Of longitude and latitude at the equator, where the plane is laid: there great circles, which
the A* heuristic estimates with, differ from the plane's straight lines by 0.3 % at most."""


@dataclass(frozen=True, slots=True, eq=False)
class Draw:
    """A network and the trips of N vehicles on it.

    Attributes
    ----------
    net : RoadNetwork
        n nodes, m edges.
    origins, destinations : ndarray of int, (N,)
        Nodes; vehicle 0 starts at the centre of the spawn circle.
    access : ndarray of bool, (m,)
        Edges by which vehicles reach the network; no junction leads into them.
    x_m, y_m : ndarray of float, (n,)
        Plane coordinates [m], for pictures.
    unconnected, impossible : int
        Draws thrown away before this one, because the network fell apart, or because some vehicle
        found no destination far enough.
    """

    net: RoadNetwork
    origins: Index
    destinations: Index
    access: NDArray[np.bool_]
    x_m: Floats
    y_m: Floats
    unconnected: int = 0
    impossible: int = 0


@dataclass(frozen=True, slots=True)
class RandomNetwork:
    """Table 1 of [1]_, row by row, and the readings of what it leaves open.

    Attributes
    ----------
    width_m, height_m : float
        Area [X, Y] boundaries.
    nodes : int
        Number of nodes, uniform in the area.
    edges : int
        Number of edges left of the complete graph; two-way roads, unless `directed`.
    dropout : float
        Edge dropout rate, [0, 1); each edge left is dropped with this probability.
    spawn_diameter_m : float
        Diameter of the circle in which vehicles start, around a random node.
    min_route_m : float
        Minimum route length of each vehicle.
    vehicles : int
        N_v, with the master.
    pruning : {"shortest", "random"}
        Whether the shortest edges of the complete graph are kept, or any.
    directed : bool
        One-way edges, of which `edges` are kept.
    connected : {"whole", "part"}
        "whole" draws again unless every node reaches every other; "part" puts vehicles and
        destinations in the largest part that does.
    spawning : {"points", "nodes"}
        "points" are uniform in the circle and reach the network by straight access edges; "nodes"
        are the network's own within the circle.
    access_nodes : int
        k, the nearest nodes that a point's access edges lead to.
    route_length : {"network", "straight"}
        What `min_route_m` is compared with: the shortest route, or the straight line.
    max_redraws : int
        Draws thrown away before giving up.
    """

    width_m: float = 1e6
    height_m: float = 1e6
    nodes: int = 100
    edges: int = 500
    dropout: float = 0.2
    spawn_diameter_m: float = 1e3
    min_route_m: float = 5e5
    vehicles: int = 10
    pruning: Literal["shortest", "random"] = "shortest"
    directed: bool = False
    connected: Literal["whole", "part"] = "whole"
    spawning: Literal["points", "nodes"] = "points"
    access_nodes: int = 3
    route_length: Literal["network", "straight"] = "network"
    max_redraws: int = 1000

    def __post_init__(self) -> None:
        for name, low, high in (
            ("width_m", 1.0, 1e7), ("height_m", 1.0, 1e7), ("dropout", 0.0, 0.999),
            ("spawn_diameter_m", 0.0, 2e7), ("min_route_m", 0.0, 1e8),
        ):  # fmt: skip
            value = getattr(self, name)
            if not (is_number(value) and math.isfinite(value) and low <= value <= high):
                raise ScenarioError(
                    f"{name} = {brief(value)} must be a number in [{low:g}, {high:g}]"
                )
        for name, allowed in (
            ("pruning", ("shortest", "random")), ("directed", (False, True)),
            ("connected", ("whole", "part")), ("spawning", ("points", "nodes")),
            ("route_length", ("network", "straight")),
        ):  # fmt: skip
            value = getattr(self, name)
            if not isinstance(value, str | bool) or value not in allowed:
                choice = " or ".join(str(item) for item in allowed)
                raise ScenarioError(f"{name} = {brief(value)} must be {choice}")
        complete = self.nodes * (self.nodes - 1) // (1 if self.directed else 2) if is_whole(
            self.nodes
        ) else 0  # fmt: skip
        for name, low, high in (
            ("nodes", 2, 5000), ("edges", 1, complete), ("vehicles", 2, 10_000),
            ("access_nodes", 1, self.nodes), ("max_redraws", 0, 10**9),
        ):  # fmt: skip
            value = getattr(self, name)
            if not (is_whole(value) and low <= value <= high):
                raise ScenarioError(
                    f"{name} = {brief(value)} must be a whole number in {low} to {high}"
                )

    def draw(self, rng: np.random.Generator) -> Draw:
        """Draw a network and its trips, again and again until both are possible.

        Parameters
        ----------
        rng : numpy.random.Generator
            Where chance comes from.

        Returns
        -------
        Draw
            The first possible one.

        Raises
        ------
        ScenarioError
            No draw was possible within `max_redraws`.
        """
        unconnected = impossible = 0
        while unconnected + impossible <= self.max_redraws:
            x, y = rng.random(self.nodes) * self.width_m, rng.random(self.nodes) * self.height_m
            tail, head = self._edges(rng, x, y)
            inside = _largest_part(self.nodes, tail, head)
            if self.connected == "whole" and not inside.all():
                unconnected += 1
                continue
            found = self._trips(rng, x, y, tail, head, np.flatnonzero(inside))
            if found is None:
                impossible += 1
                continue
            return _as_draw(*found, unconnected, impossible)
        raise ScenarioError(
            f"random network: none of {self.max_redraws + 1} draws was possible ({unconnected} not "
            f"connected, {impossible} without destinations far enough); take more edges, less "
            'dropout, shorter routes, or connected="part"'
        )

    def _edges(self, rng: np.random.Generator, x: Floats, y: Floats) -> tuple[Index, Index]:
        """Return the directed edges left after pruning and dropout."""
        if self.directed:
            a, b = np.nonzero(~np.eye(self.nodes, dtype=bool))
        else:
            a, b = np.triu_indices(self.nodes, 1)
        if self.pruning == "shortest":
            away = (x[a] - x[b]) ** 2 + (y[a] - y[b]) ** 2
            kept = np.sort(np.argsort(away, kind="stable")[: self.edges])
        else:
            kept = np.sort(rng.choice(len(a), self.edges, replace=False))
        kept = kept[rng.random(self.edges) >= self.dropout]
        if self.directed:
            return a[kept], b[kept]
        return np.concatenate([a[kept], b[kept]]), np.concatenate([b[kept], a[kept]])

    def _trips(
        self,
        rng: np.random.Generator,
        x: Floats,
        y: Floats,
        tail: Index,
        head: Index,
        inside: Index,
    ) -> tuple[Floats, Floats, Index, Index, int, Index, Index] | None:
        """Place the vehicles and choose their destinations; None if one of them has none."""
        centre = int(rng.choice(inside))
        others = self.vehicles - 1
        junctions = len(x)
        if self.spawning == "nodes":
            away = np.hypot(x[inside] - x[centre], y[inside] - y[centre])
            origins = np.append(
                centre, rng.choice(inside[away <= self.spawn_diameter_m / 2], others)
            )
        else:
            px, py = self._points(rng, x[centre], y[centre], others)
            away = np.hypot(px[:, None] - x[inside], py[:, None] - y[inside])
            count = min(self.access_nodes, len(inside))
            near = np.sort(np.argsort(away, axis=1, kind="stable")[:, :count], axis=1)
            own = junctions + np.arange(others)
            x, y = np.append(x, px), np.append(y, py)
            # Access edges lead into the network only, so nobody passes through another's start.
            tail = np.concatenate([tail, np.repeat(own, count)])
            head = np.concatenate([head, inside[near].ravel()])
            origins = np.append(centre, own)
        if self.route_length == "network":
            far = _route_lengths(x, y, tail, head, origins)[:, inside]
        else:
            far = np.hypot(x[origins, None] - x[inside], y[origins, None] - y[inside])
        # Without a minimum too, a vehicle has to go somewhere.
        allowed = np.isfinite(far) & (far >= self.min_route_m) & (inside != origins[:, None])
        if not allowed.any(axis=1).all():
            return None
        destinations = inside[(rng.random(allowed.shape) * allowed).argmax(axis=1)]
        return x, y, tail, head, junctions, origins, destinations

    def _points(
        self, rng: np.random.Generator, x: float, y: float, count: int
    ) -> tuple[Floats, Floats]:
        """Return points uniform in the part of the spawn circle that lies in the area."""
        px, py = np.empty(count), np.empty(count)
        missing = np.arange(count)
        while len(missing):
            radius = self.spawn_diameter_m / 2 * np.sqrt(rng.random(len(missing)))
            angle = 2 * np.pi * rng.random(len(missing))
            px[missing] = x + radius * np.cos(angle)
            py[missing] = y + radius * np.sin(angle)
            out = (px < 0) | (px > self.width_m) | (py < 0) | (py > self.height_m)
            missing = missing[out[missing]]
        return px, py


def _largest_part(nodes: int, tail: Index, head: Index) -> NDArray[np.bool_]:
    """Mark the nodes of the largest strongly connected part."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(len(tail)), (tail, head)), shape=(nodes, nodes)).tocsr()
    count, label = connected_components(graph, directed=True, connection="strong")
    return np.asarray(label == np.bincount(label, minlength=count).argmax())


def _route_lengths(x: Floats, y: Floats, tail: Index, head: Index, origins: Index) -> Floats:
    """Return lengths of the shortest routes from each origin to every node [m]."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    length = np.hypot(x[tail] - x[head], y[tail] - y[head])
    graph = coo_array((length, (tail, head)), shape=(len(x), len(x))).tocsr()
    found: Floats = dijkstra(graph, indices=origins)
    return found


def _as_draw(
    x: Floats, y: Floats, tail: Index, head: Index, junctions: int, origins: Index,
    destinations: Index, unconnected: int, impossible: int,
) -> Draw:  # fmt: skip
    per_lon, per_lat = METRES_PER_DEGREE
    counts = {
        "networks drawn again, not connected": unconnected,
        "networks drawn again, no destination far enough": impossible,
    }
    net = RoadNetwork.from_edges(
        tail, head, np.hypot(x[tail] - x[head], y[tail] - y[head]),
        lon=(x - x[:junctions].mean()) / per_lon, lat=(y - y[:junctions].mean()) / per_lat,
        texts=TextTable.from_strings([""]),
        source=Source("random network, Table 1 of the paper"), report=LoadReport(counts),
    )  # fmt: skip
    return Draw(net, origins, destinations, net.tail >= junctions, x, y, unconnected, impossible)
