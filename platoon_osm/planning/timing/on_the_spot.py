"""An edge as its closings ask for it: its country, clocks and place, and when it is driven.

Within a stretch the time to drive it is shared among its edges as for a lone truck.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime, tzinfo
from itertools import pairwise
from zoneinfo import ZoneInfo

import numpy as np

from ...driving.bans.rules import bans_of
from ...network.road_network import RoadNetwork
from ...plans.records import Stretch

__all__ = ["LocalClock", "country_of_edge", "edge_times", "local_clock", "midpoint"]


@dataclass(frozen=True, slots=True)
class LocalClock:
    """What clocks show where an edge is.

    Attributes
    ----------
    zone : tzinfo or None
        None if all moments are without one.
    """

    zone: tzinfo | None

    def __call__(self, at: datetime) -> datetime:
        """Return what they show at a moment, without a zone."""
        return (at if self.zone is None else at.astimezone(self.zone)).replace(tzinfo=None)


def local_clock(country: str, start: datetime) -> LocalClock:
    """Return the clocks of a country.

    Parameters
    ----------
    country : str
        Two letters; of one that is not known, clocks go as those of the plan.
    start : datetime
        A moment of the plan.

    Returns
    -------
    LocalClock
        Turns moments into what they show.
    """
    if start.tzinfo is None:
        return LocalClock(None)
    bans = bans_of(country)
    return LocalClock(ZoneInfo(bans.zone) if bans else start.tzinfo)


def country_of_edge(net: RoadNetwork, edge: int) -> str:
    """Return the country of an edge.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Its position.

    Returns
    -------
    str
        Two letters; empty if it is not known.
    """
    return net.texts[int(net.country[edge])][:2].upper()


def midpoint(net: RoadNetwork, edge: int) -> tuple[float, float]:
    """Return a place on an edge.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Its position.

    Returns
    -------
    (float, float)
        Longitude and latitude of its head.
    """
    head = int(net.head[edge])
    return float(net.lon[head]), float(net.lat[head])


def edge_times(net: RoadNetwork, stretch: Stretch) -> list[tuple[float, float]]:
    """Return when the edges of a stretch are driven, after its start.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    stretch : Stretch
        With edges.

    Returns
    -------
    list of (float, float)
        Seconds.
    """
    edges = np.array(stretch.edges)
    times = net.length_m[edges] / net.speed_mps[edges]
    begin, end = stretch.span
    if len(edges) == 1:
        times = times * (end - begin)
    else:
        times[0] *= 1 - begin
        times[-1] *= end
    ends = np.cumsum(times)
    if ends[-1] > 0:
        ends *= stretch.drive_s / ends[-1]
    bounds = [0.0, *ends.tolist()]
    return list(pairwise(bounds))
