"""What searches are asked with, checked once at their doors: weights, nodes, labels, positions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import NoRouteError, SearchError
from ..network.road_network import RoadNetwork

__all__ = [
    "checked_along", "checked_edges", "checked_labels", "checked_network", "checked_node",
    "checked_nodes", "checked_pairs", "checked_positions", "checked_two", "checked_weight",
    "described", "no_route",
]  # fmt: skip

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


def no_route(net: RoadNetwork, node: int, forward: bool) -> NoRouteError:
    """Return the error to raise when a node cannot be reached, or cannot reach.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    node : int
        The node in question.
    forward : bool
        Whether paths lead to the node; else they start there.

    Returns
    -------
    NoRouteError
        It names the place and the remedy.
    """
    return NoRouteError(
        f"no route {'to' if forward else 'from'} {net.place_name(node)} (node {node}); "
        "choose another place or load more roads"
    )


def checked_network(net: Any) -> RoadNetwork:
    """Return what is a network as it is.

    Parameters
    ----------
    net : object
        What was given for a network.

    Returns
    -------
    RoadNetwork
        The same object.

    Raises
    ------
    SearchError
        If it is something else, as when arguments are swapped.
    """
    if not isinstance(net, RoadNetwork):
        raise SearchError(
            f"net is {described(net)}, not a RoadNetwork; give the network first, then the weight"
        )
    return net


def checked_weight(net: RoadNetwork, weight: ArrayLike, called: str = "weight") -> Floats:
    """Return costs of the edges as an array.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    called : str
        What an error calls the weight.

    Returns
    -------
    ndarray of float, (m,)
        The costs; not a copy where none is needed.

    Raises
    ------
    SearchError
        A weight that is negative, NaN, no numbers or of the wrong shape.
    """
    values = _numbers(called, weight, net.m, "the network has {} edges", "has")
    # The least of values that hold a NaN is NaN, and NaN is not 0 or more.
    if not values.min(initial=0.0) >= 0:
        worst = int(np.argmin(np.where(np.isnan(values), -np.inf, values)))
        raise SearchError(f"{called} of edge {worst} is {values[worst]}; it must be 0 or more")
    return values


def checked_labels(net: RoadNetwork, labels: ArrayLike, called: str = "label") -> Floats:
    """Return starting costs of the nodes as an array.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    labels : array_like of float, (n,)
        Cost of starting at each node, 0 or more; inf where no path may start.
    called : str
        What an error calls one of them.

    Returns
    -------
    ndarray of float, (n,)
        The labels; not a copy where none is needed.

    Raises
    ------
    SearchError
        A label that is negative, NaN, no number, or labels of the wrong shape.
    """
    values = _numbers(f"{called}s", labels, net.n, "the network has {} nodes", "have")
    if not values.min(initial=0.0) >= 0:
        worst = int(np.argmin(np.where(np.isnan(values), -np.inf, values)))
        raise SearchError(f"{called} of node {worst} is {values[worst]}; it must be 0 or more")
    return values


def checked_nodes(net: RoadNetwork, nodes: ArrayLike) -> Longs:
    """Return nodes as an array.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    nodes : array_like of int, (k,)
        Node positions; one alone counts as k = 1.

    Returns
    -------
    ndarray of int, (k,)
        A copy.

    Raises
    ------
    SearchError
        A node outside the network, or what is no list of whole numbers.
    """
    if type(nodes) is int and 0 <= nodes < net.n:
        return np.array([nodes], np.int64)  # the usual case, in less time than a small sweep
    wanted = _whole("nodes", nodes)
    if wanted.size and (wanted.min() < 0 or wanted.max() >= net.n):
        worst = wanted[np.argmax((wanted < 0) | (wanted >= net.n))]
        raise SearchError(f"node {worst}: the network has nodes 0 to {net.n - 1}")
    return wanted.astype(np.int64)


def checked_node(net: RoadNetwork, node: ArrayLike) -> int:
    """Return one node.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    node : int
        Node position.

    Returns
    -------
    int
        The node.

    Raises
    ------
    SearchError
        A node outside the network, or what is not one node.
    """
    wanted = checked_nodes(net, node)
    if wanted.shape != (1,):
        raise SearchError(
            f"node is a list of {len(wanted)}; give one node, or use a search of many"
        )
    return int(wanted[0])


def checked_edges(net: RoadNetwork, edges: ArrayLike) -> Longs:
    """Return edges as an array.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    edges : array_like of int, (k,)
        Edge ids.

    Returns
    -------
    ndarray of int, (k,)
        A copy.

    Raises
    ------
    SearchError
        An edge outside the network, or what is no list of whole numbers.
    """
    wanted = _whole("edges", edges)
    if wanted.size and (wanted.min() < 0 or wanted.max() >= net.m):
        worst = wanted[np.argmax((wanted < 0) | (wanted >= net.m))]
        raise SearchError(f"edge {worst}: the network has edges 0 to {net.m - 1}")
    return wanted.astype(np.int64)


def checked_along(route: Longs, values: ArrayLike, called: str) -> Floats:
    """Return what grows along a route as an array.

    Parameters
    ----------
    route : ndarray of int, (K + 1,)
        Nodes of the route.
    values : array_like of float, (K + 1,)
        A sum up to each node.
    called : str
        What an error calls it.

    Returns
    -------
    ndarray of float, (K + 1,)
        The sums.

    Raises
    ------
    SearchError
        Another number of values, or what is no number.
    """
    found = _numbers(called, values, len(route), "the route has {} nodes", "has")
    if not np.isfinite(found).all():
        worst = int(np.argmin(np.isfinite(found)))
        raise SearchError(f"{called} at position {worst} of the route is {found[worst]}")
    return np.ascontiguousarray(found)


def checked_positions(
    route: Longs, members: int, positions: Any, called: str
) -> tuple[Longs, Longs] | None:
    """Return the positions on a route that members may use.

    Parameters
    ----------
    route : ndarray of int, (K + 1,)
        Nodes of the route.
    members : int
        Number N of members.
    positions : tuple of array_like of int or None
        First (N + 1,), where each member's positions begin, and all positions; None allows all.
    called : str
        What an error calls them.

    Returns
    -------
    tuple of ndarray of int, or None
        The same, checked.

    Raises
    ------
    SearchError
        Positions outside the route, or `first` that does not fit.
    """
    if positions is None:
        return None
    if not isinstance(positions, Sequence) or len(positions) != 2:
        raise SearchError(
            f"{called}: {described(positions)}; give where each member's begin, and all"
        )
    first, at = (_whole(called, part).astype(np.int64) for part in positions)
    fits = len(first) == members + 1 and first[0] == 0 and first[-1] == len(at)
    if not fits or (np.diff(first) < 0).any():
        raise SearchError(f"{called}: first must rise from 0 to {len(at)} in {members + 1} steps")
    if len(at) and (at.min() < 0 or at.max() >= len(route)):
        raise SearchError(f"{called}: the route has positions 0 to {len(route) - 1}")
    return first, at


def checked_pairs(net: RoadNetwork, origins: ArrayLike, destinations: ArrayLike) -> list[Longs]:
    """Return the origins and destinations of members.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    origins : array_like of int, (N,)
        Nodes where members start.
    destinations : array_like of int, (N,)
        Nodes where they go.

    Returns
    -------
    list of ndarray of int, (N,)
        Both.

    Raises
    ------
    SearchError
        Nodes outside the network, or not as many of the one as of the other.
    """
    start, end = checked_nodes(net, origins), checked_nodes(net, destinations)
    if len(start) != len(end):
        raise SearchError(
            f"{len(start)} origins and {len(end)} destinations; give one of each a member"
        )
    return [start, end]


def checked_two(net: RoadNetwork, costs: Any, called: str, values: bool = True) -> list[Floats]:
    """Return the costs of two vehicles.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    costs : sequence of array_like of float, (n,)
        Costs at every node, of either vehicle.
    called : str
        What an error calls them.
    values : bool
        Whether to look at every cost; else at shapes only.

    Returns
    -------
    list of ndarray of float, (n,)
        Both.

    Raises
    ------
    SearchError
        Not two, or arrays that do not fit the network.
    """
    if not isinstance(costs, list | tuple | np.ndarray) or len(costs) != 2:
        raise SearchError(f"{called} is {described(costs)}; give two arrays, one of each vehicle")
    if values:
        return [checked_labels(net, part, called) for part in costs]
    return [_numbers(called, part, net.n, "the network has {} nodes", "has") for part in costs]


def _numbers(called: str, given: Any, count: int, of: str, has: str) -> Floats:
    values = _array(called, given)
    if values.dtype == np.float64 and values.shape == (count,):
        return values
    if values.dtype.kind not in "iuf" and values.size:
        raise SearchError(f"{called} {has} no numbers but {described(values)}; give costs")
    if values.shape != (count,):
        raise SearchError(f"{called} {has} shape {values.shape}; {of.format(count)}")
    return values.astype(np.float64, copy=False)


def _whole(called: str, given: Any) -> NDArray[Any]:
    values = np.atleast_1d(_array(called, given))
    if values.dtype.kind not in "iu" and values.size:
        raise SearchError(
            f"{called}: {described(given)} where whole numbers are needed; give positions"
        )
    if values.ndim != 1:
        raise SearchError(f"{called} have shape {values.shape}; give them in one row")
    return values


def _array(called: str, given: Any) -> NDArray[Any]:
    try:
        return np.asarray(given)
    except (TypeError, ValueError) as error:
        raise SearchError(f"{called}: {described(given)} is no array; give one row") from error


def described(thing: Any) -> str:
    """Return in a few words what something is.

    Parameters
    ----------
    thing : object
        What was given.

    Returns
    -------
    str
        One line, for an error.
    """
    if isinstance(thing, np.ndarray):
        kinds = {"b": "true and false", "U": "text", "S": "text", "O": "objects", "c": "complex"}
        return f"an array of {kinds.get(thing.dtype.kind, str(thing.dtype))}"
    if thing is None or isinstance(thing, bool | int | float | str):
        text = repr(thing)
        return text if len(text) <= 40 else f"{text[:37]}..."
    return f"a {type(thing).__name__}"
