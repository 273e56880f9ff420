"""Which engine is faster: the seconds that each would still need.

The hierarchy needs compiled code (loaded once a process), an order (once a network) and costs of
its arcs (once a weight), and then answers a search many times faster. What is still missing is
added up and compared:

    reference:  m * REFERENCE_EDGE_S  +  searches * n * REFERENCE_NODE_S
    hierarchy:  LOAD_S or COMPILE_S  +  m * ORDER_EDGE_S or m * READ_EDGE_S
                +  m * GROW_EDGE_S where places lie between its junctions
                +  m * CUSTOMIZE_EDGE_S  +  searches * n * SWEEP_NODE_S

each term only as far as it has not been paid already in this process. The times were measured on
road networks of two thousand to a million nodes (docs/performance.md); a machine twice as fast
is so in all of them alike. Nothing is imported or compiled as long as the reference is chosen.
"""

from __future__ import annotations

import sys
from collections.abc import Collection
from typing import Any, Literal

from ..network.placed import network_below
from ..network.road_network import RoadNetwork
from .kept_topology import KeptTopology

__all__ = ["faster"]

REFERENCE_EDGE_S = 1.5e-7
REFERENCE_NODE_S = 1.5e-7
SWEEP_NODE_S = 5e-9
CUSTOMIZE_EDGE_S = 1.2e-8
READ_EDGE_S = 5e-8
ORDER_EDGE_S = 3e-6
GROW_EDGE_S = 6e-7
LOAD_S = 1.0
COMPILE_S = 30.0


def faster(
    net: RoadNetwork, searches: float, ready: Collection[str]
) -> Literal["reference", "hierarchy"]:
    """Return the name of the engine that is likely faster.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    searches : float
        Single searches the reference would need.
    ready : collection of str
        Names of the engines that are made already for the weight in question.

    Returns
    -------
    str
        Either "reference" or "hierarchy".
    """
    reference = searches * net.n * REFERENCE_NODE_S
    if "reference" not in ready:
        reference += net.m * REFERENCE_EDGE_S
    sweeps = searches * net.n * SWEEP_NODE_S
    missing = 0.0 if "hierarchy" in ready else net.m * CUSTOMIZE_EDGE_S
    if net.attached(KeptTopology).of(net) is None:
        below = network_below(net)
        topology = below.attached(KeptTopology)
        if below is not net:
            missing += net.m * GROW_EDGE_S
        if topology.of(below) is None:
            missing += net.m * (READ_EDGE_S if topology.is_stored() else ORDER_EDGE_S)
    if not _loaded():
        missing += LOAD_S
        # Looking for compiled code imports numba, so only where there is something to gain.
        if reference > missing + sweeps and not _compiled():
            missing += COMPILE_S
    return "hierarchy" if missing + sweeps < reference else "reference"


def _loaded() -> bool:
    module: Any = sys.modules.get(f"{__package__}.hierarchy.warmth")
    return module is not None and module.is_warm()


def _compiled() -> bool:
    from .hierarchy.warmth import is_compiled

    return is_compiled()
