"""Names of nodes that carry neither name nor number, as `place_name` prints them, found again."""

from __future__ import annotations

import re
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from .coordinate_text import printed_position
from .geodesy import distance_m
from .naming import towns_around
from .place_index import clusters
from .road_network import RoadNetwork
from .spelling import fold, plain
from .towns.surroundings import FARTHEST_TOWN_M

__all__ = ["nodes_printed_as"]

ROUNDING_DEG = 0.0006
"""A little more than half of the last digit of a printed position."""

MOST_CUTS = 12
"""So many times the word "near" is tried as the one that stands before the town."""


def nodes_printed_as(net: RoadNetwork, text: str) -> list[list[int]]:
    """Return the nodes that are called "A 4 near Torino" or "A 4 at 45.070 N 7.690 E".

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    text : str
        What somebody wrote.

    Returns
    -------
    list of list of int
        Nodes near each other are one place. Empty if none is called so.
    """
    own = plain(text)
    bare = (net.node_name == 0) & (net.node_ref == 0)
    nodes = [
        node
        for node in np.flatnonzero((bare | _blank(net)) & _about_there(net, own)).tolist()
        if plain(net.place_name(node)) == own
    ]
    return clusters(net, nodes)


def _blank(net: RoadNetwork) -> NDArray[np.bool_]:
    """Mark nodes whose name and number are blanks alone."""
    blank = [code for code, text in enumerate(net.texts) if not text.strip()]
    return np.isin(net.node_name, blank) & np.isin(net.node_ref, blank)


def _about_there(net: RoadNetwork, own: str) -> NDArray[np.bool_]:
    """Mark the nodes that lie where a text says, so that few need to be named."""
    there = np.zeros(net.n, bool)
    if position := printed_position(own):
        lon, lat = position
        there |= (abs(net.lon - lon) <= ROUNDING_DEG) & (abs(net.lat - lat) <= ROUNDING_DEG)
    around = towns_around(net)
    for near in islice(re.finditer(r"(?<!\S)near ", own), MOST_CUTS):
        for at in around.positions(fold(own[near.end() :])):
            there |= distance_m(net.lon, net.lat, *at) <= FARTHEST_TOWN_M
    return there
