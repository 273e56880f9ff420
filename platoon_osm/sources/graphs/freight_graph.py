"""GraphML of the ETISplus long-distance network: places and distances, without road tags."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...errors import NetworkError
from ...network.load_report import Source
from .graph_values import number

if TYPE_CHECKING:
    import networkx

__all__ = ["REMARK", "as_tagged", "freight_source", "is_freight_graph"]

LICENCE = "CC BY 4.0"
ATTRIBUTION = "ETISplus network, Speth et al., Synthetic European road freight transport flow data"

REMARK = (
    "the edges have no road tags: all were taken as motorway, straight between their ends, with "
    "the distances the file gives"
)


def is_freight_graph(graph: networkx.Graph[Any]) -> bool:
    """Say whether nodes have `position_x` and `position_y` and edges `distance`, and no tags.

    Parameters
    ----------
    graph : Graph
        The graph.

    Returns
    -------
    bool
        Whether it is one.
    """
    node = next((data for _, data in graph.nodes(data=True)), {})
    edge = next((data for *_, data in graph.edges(data=True)), {})
    return (
        {"position_x", "position_y"} <= node.keys()
        and "x" not in node
        and "distance" in edge
        and "highway" not in edge
    )


def as_tagged(graph: networkx.Graph[Any]) -> None:
    """Give nodes and edges the attributes that OSMnx's graphs have, in place.

    Every node becomes a junction, for each is a place where vehicles start and arrive.

    Parameters
    ----------
    graph : Graph
        The graph.

    Raises
    ------
    NetworkError
        An edge without a distance [km].
    """
    for _, data in graph.nodes(data=True):
        data |= {
            "x": data.get("position_x"), "y": data.get("position_y"),
            "highway": "motorway_junction",
        }  # fmt: skip
    for u, v, data in graph.edges(data=True):
        km = number(data.get("distance"))
        if km is None:
            raise NetworkError(
                f"graph: edge {u!r} -> {v!r} has distance {data.get('distance')!r:.40}; give "
                "kilometres"
            )
        data |= {"highway": "motorway", "length": km * 1000.0, "osmid": None}


def freight_source(name: str, sha256: str) -> Source:
    """Return the identity of such a file.

    Parameters
    ----------
    name : str
        What it is called.
    sha256 : str
        Hex digest of the file.

    Returns
    -------
    Source
        The identity.
    """
    return Source(name, sha256, "", LICENCE, ATTRIBUTION)
