"""Other libraries' shortest paths behind one face, each in the form that suits it best."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.search.joining import best_pairs

__all__ = ["RoutingKit", "one_to_all_peers"]

Floats = NDArray[np.float64]


def installed(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def one_to_all_peers(
    net: RoadNetwork, weight: Floats, edges: NDArray[np.int64]
) -> dict[str, Callable[[int], Any]]:
    """Return name -> function from a source to costs (n,), graphs built beforehand.

    Parameters
    ----------
    edges : the lightest of each bundle of parallel edges.
    """
    tail, head, cost = net.tail[edges], net.head[edges], weight[edges]
    found: dict[str, Callable[[int], Any]] = {}

    def as_row(lengths: Any) -> Floats:
        row = np.full(net.n, np.inf)
        row[list(lengths.keys())] = list(lengths.values())
        return row

    triples = list(zip(tail.tolist(), head.tolist(), cost.tolist(), strict=True))
    if installed("networkx") and net.n <= 60_000:
        import networkx as nx

        plain = nx.DiGraph()
        plain.add_nodes_from(range(net.n))
        plain.add_weighted_edges_from(triples)
        found["networkx"] = lambda s: as_row(nx.single_source_dijkstra_path_length(plain, s))
    if installed("igraph") and net.n <= 60_000:
        import igraph

        flat = igraph.Graph(net.n, [t[:2] for t in triples], directed=True)
        costs = cost.tolist()
        found["igraph"] = lambda s: np.array(flat.distances(s, weights=costs)[0])
    if installed("rustworkx") and net.n <= 60_000:
        import rustworkx as rx

        rust = rx.PyDiGraph()
        rust.add_nodes_from(range(net.n))
        rust.add_edges_from(triples)

        def by_rust(s: int) -> Floats:
            row = as_row(rx.dijkstra_shortest_path_lengths(rust, s, float))
            row[s] = 0.0
            return row

        found["rustworkx"] = by_rust
    if installed("networkit") and net.n <= 60_000:
        import networkit as nk

        kit = nk.Graph(net.n, weighted=True, directed=True)
        for a, b, c in triples:
            kit.addEdge(a, b, c)

        def by_kit(s: int) -> Floats:
            search = nk.distance.Dijkstra(kit, s, storePaths=False)
            search.run()
            row = np.array(search.getDistances())
            return np.where(row > 1e300, np.inf, row)

        found["networkit"] = by_kit
    return found


class RoutingKit:
    """Case C by `routingkit-cch`: batched one-to-many from each origin, to each destination.

    Weights must be whole numbers below 2^31.
    """

    def __init__(self, net: RoadNetwork) -> None:
        import routingkit_cch as rk

        self._rk = rk
        order = rk.compute_order_inertial(
            net.n, net.tail.tolist(), net.head.tolist(),
            net.lat.astype(np.float32).tolist(), net.lon.astype(np.float32).tolist(),
        )  # fmt: skip
        self._cch = rk.CCH(order, net.tail.tolist(), net.head.tolist(), False)

    def customized(self, weights: list[int]) -> Any:
        """Return the hierarchy under a weight."""
        return self._rk.CCHMetric(self._cch, weights)

    def members(
        self, metric: Any, route: list[int], origins: list[int], destinations: list[int],
        platoon: Floats, length_m: Floats, solo: Floats,
    ) -> Floats:  # fmt: skip
        """Return costs (N,); the costs alone are given, for they would only slow it down."""
        forth = self._rk.CCHOneToMany(metric, route)
        back = self._rk.CCHManyToOne(metric, route)
        entry = np.array([forth.distances_from(s) for s in origins], np.float64)
        leave = np.array([back.distances_to(t) for t in destinations], np.float64)
        for table in (entry, leave):
            table[np.isnan(table)] = np.inf
        return best_pairs(entry, leave, platoon, length_m, solo)[2]
