"""The numbers of roads along a way, as pages, sheets and files name them."""

from __future__ import annotations

from collections.abc import Sequence

from ...network.road_network import RoadNetwork
from ...shown_text import shown

__all__ = ["roads_of"]


def roads_of(net: RoadNetwork, edges: Sequence[int]) -> str:
    """Return the road numbers along edges.

    Parameters
    ----------
    net : RoadNetwork
        Whose edges they are.
    edges : sequence of int
        In driving order.

    Returns
    -------
    str
        With commas, each once.
    """
    refs = dict.fromkeys(shown(net.edge_ref(edge)) for edge in edges)
    return ", ".join(ref for ref in refs if ref)
