"""One face for both engines: the reference (scipy's Dijkstra) and the contraction hierarchy.

Which is faster depends on the work. The hierarchy needs compiled code (loaded once a process), an
order (once a network) and costs of its arcs (once a weight), and then answers a search many times
faster. `engine="auto"` adds up what is still missing and compares:

    reference:  m * REFERENCE_EDGE_S  +  searches * n * REFERENCE_NODE_S
    hierarchy:  LOAD_S or COMPILE_S  +  m * ORDER_EDGE_S or m * READ_EDGE_S
                +  m * CUSTOMIZE_EDGE_S  +  searches * n * SWEEP_NODE_S

each term only as far as it has not been paid already in this process. The times were measured on
road networks of two thousand to a million nodes (docs/performance.md); a machine twice as fast
is so in all of them alike. Nothing is imported or compiled as long as the reference is chosen.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..network.road_network import RoadNetwork
from .dijkstra import ReferenceEngine, checked_weight
from .joining import Found, Positions

__all__ = ["Engine", "EngineName", "LeastCosts", "distances", "engine_for", "many_to_many",
           "one_to_many", "path", "prepare", "release", "seeded", "tree", "warm_up"]  # fmt: skip

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]
EngineName = Literal["auto", "reference", "hierarchy"]

REFERENCE_EDGE_S = 1.5e-7
REFERENCE_NODE_S = 1.5e-7
SWEEP_NODE_S = 5e-9
CUSTOMIZE_EDGE_S = 1.2e-8
READ_EDGE_S = 5e-8
ORDER_EDGE_S = 3e-6
LOAD_S = 1.0
COMPILE_S = 30.0

KEPT_WEIGHTS = 2
"""Engines kept with a network: a plan of two vehicles needs two weights in turns."""


class LeastCosts(Protocol):
    """Least costs (n,) between one place, or labelled nodes, and all nodes, and their paths."""

    @property
    def dist(self) -> Floats:
        """Cost of each node (n,); inf if unreachable."""
        ...

    def path(self, node: int) -> Edges:
        """Return edge ids in driving order; raise NoRouteError if there is no way."""
        ...


class Engine(Protocol):
    """What both engines do; see `ReferenceEngine` for each method."""

    @property
    def name(self) -> str:
        """Either "reference" or "hierarchy"."""
        ...

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return costs (k, n) from each of k nodes to all, or from all to each."""
        ...

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs and paths from a node to all, or from all to it."""
        ...

    def trees(self, nodes: ArrayLike, forward: bool = True) -> Sequence[LeastCosts]:
        """Return the trees of several nodes, searched together where that is faster."""
        ...

    def seeded(self, labels: ArrayLike) -> LeastCosts:
        """Return least costs and paths where each node may start at a cost of its own."""
        ...

    def shared_stretch(
        self, pair: Floats, there: Sequence[Floats], onward: Sequence[Floats], limit: float,
        slack: float = 0.0,
    ) -> LeastCosts:  # fmt: skip
        """Return least costs of two that meet and drive together, as far as a limit needs them."""
        ...

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs (S, T)."""
        ...

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs (T,)."""
        ...

    def path(self, source: int, target: int) -> Edges:
        """Return the edges of a least-cost path; raise NoRouteError if there is none."""
        ...

    def best_on_route(
        self,
        route: Edges,
        origins: Edges,
        destinations: Edges,
        platoon: Floats,
        length_m: Floats,
        entries: Positions | None = None,
        exits: Positions | None = None,
    ) -> Found:
        """Return where N members best join a route and leave it."""
        ...


def engine_for(
    net: RoadNetwork, weight: ArrayLike, engine: EngineName = "auto", searches: int = 1
) -> Engine:
    """Return an engine for a weight; the last two are kept with the network.

    Parameters
    ----------
    weight : (m,) costs, not negative; inf where closed. A kept engine is used again only if every
        cost is the same.
    engine : "reference", "hierarchy", or "auto" for the one that is likely faster.
    searches : single searches the reference would need; "auto" decides by it.

    Raises
    ------
    ValueError
        A weight that is negative, NaN or of the wrong shape, or an engine that is none.
    """
    if engine not in ("auto", "reference", "hierarchy"):
        raise ValueError(f'engine {engine!r} is unknown; use "auto", "reference" or "hierarchy"')
    values = checked_weight(net, weight)
    kept: list[tuple[Floats, Engine]] = net._kept.setdefault("engines", [])
    ready = {
        item.name: item for own, item in list(kept) if own is values or np.array_equal(own, values)
    }
    chosen = engine if engine != "auto" else _faster(net, searches, set(ready))
    if chosen in ready:
        return ready[chosen]
    # Kept with a copy: an array changed in place must not find the engine of its old values.
    own: Floats
    made: Engine
    if chosen == "reference":
        own, made = values.copy(), ReferenceEngine(net, values)
    else:
        from .hierarchy.engine import HierarchyEngine

        made = HierarchyEngine(net, values)
        own = made.weight
    kept.append((own, made))
    del kept[:-KEPT_WEIGHTS]
    return made


def _faster(net: RoadNetwork, searches: int, ready: set[str]) -> EngineName:
    reference = searches * net.n * REFERENCE_NODE_S
    if "reference" not in ready:
        reference += net.m * REFERENCE_EDGE_S
    sweeps = searches * net.n * SWEEP_NODE_S
    missing = 0.0 if "hierarchy" in ready else net.m * CUSTOMIZE_EDGE_S
    if not _kept_order(net):
        missing += net.m * (READ_EDGE_S if _stored_order(net) else ORDER_EDGE_S)
    if not _loaded():
        missing += LOAD_S
        # Looking for compiled code imports numba, so only where there is something to gain.
        if reference > missing + sweeps and not _compiled():
            missing += COMPILE_S
    return "hierarchy" if missing + sweeps < reference else "reference"


def _kept_order(net: RoadNetwork) -> bool:
    kept = net._kept.get("hierarchy")
    return kept is not None and kept[0] is net.head


def _stored_order(net: RoadNetwork) -> bool:
    file = net._kept.get("file")
    return file is not None and file.with_name(file.name + ".hierarchy").is_file()


def _loaded() -> bool:
    module: Any = sys.modules.get(f"{__package__}.hierarchy.warmth")
    return module is not None and module.is_warm()


def _compiled() -> bool:
    from .hierarchy.warmth import is_compiled

    return is_compiled()


def release() -> None:
    """Give the system back what the hierarchy keeps of memory for its next results."""
    module: Any = sys.modules.get(f"{__package__}.hierarchy.runtime.lent")
    if module is not None:
        module.release()


def warm_up() -> float:
    """Compile the hierarchy's kernels, or load them if compiled already; return seconds."""
    from .hierarchy.warmth import warm_up as compile_all

    return compile_all()


def prepare(net: RoadNetwork) -> None:
    """Order and contract a network for the hierarchy, and store that beside its file."""
    from .hierarchy.preparing.storage import topology_of

    topology_of(net)


def many_to_many(
    net: RoadNetwork, weight: ArrayLike, sources: ArrayLike, targets: ArrayLike,
    engine: EngineName = "auto",
) -> Floats:  # fmt: skip
    """Return least costs (S, T) between sources and targets; inf where there is no way."""
    searches = min(np.size(sources), np.size(targets))
    return engine_for(net, weight, engine, searches).many_to_many(sources, targets)


def one_to_many(
    net: RoadNetwork, weight: ArrayLike, source: int, targets: ArrayLike,
    engine: EngineName = "auto",
) -> Floats:  # fmt: skip
    """Return least costs (T,) from a source to targets; inf where there is no way."""
    return engine_for(net, weight, engine).one_to_many(source, targets)


def distances(
    net: RoadNetwork, weight: ArrayLike, nodes: ArrayLike, forward: bool = True,
    engine: EngineName = "auto",
) -> Floats:  # fmt: skip
    """Return costs (k, n) from each of k nodes to all, or from all to each if not forward."""
    return engine_for(net, weight, engine, np.size(nodes)).distances(nodes, forward)


def tree(
    net: RoadNetwork, weight: ArrayLike, node: int, forward: bool = True,
    engine: EngineName = "auto",
) -> LeastCosts:  # fmt: skip
    """Return least costs and paths from a node to all, or from all to it if not forward."""
    return engine_for(net, weight, engine).tree(node, forward)


def seeded(
    net: RoadNetwork, weight: ArrayLike, labels: ArrayLike, engine: EngineName = "auto"
) -> LeastCosts:
    """Return least costs and paths where node x may start at cost `labels[x]`."""
    return engine_for(net, weight, engine, 2).seeded(labels)


def path(
    net: RoadNetwork, weight: ArrayLike, source: int, target: int, engine: EngineName = "auto"
) -> Edges:
    """Return the edges of a least-cost path.

    Raises
    ------
    NoRouteError
        If there is none.
    """
    return engine_for(net, weight, engine).path(source, target)
