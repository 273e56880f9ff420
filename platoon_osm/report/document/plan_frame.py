"""The part of the world round a plan, in which a map is looked at closely."""

from __future__ import annotations

import numpy as np

from ..drawing.basemap import Frame
from .findings import Findings

__all__ = ["plan_frame"]

LEAST_MARGIN = 0.5
"""Degrees round a plan, at least: 40 to 55 km."""

MARGIN = 0.15
"""Round a larger plan, in shares of its width and height."""


def plan_frame(found: Findings) -> Frame:
    """Return the frame of all routes of a plan, with some of the world around them.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    Frame
        West, south, east and north in degrees.
    """
    net = found.net
    edges = np.unique([edge for one in found.plan.stretches for edge in one.edges])
    nodes = np.append(net.tail[edges.astype(np.int64)], net.head[edges.astype(np.int64)])
    stops = [stop for one in found.plan.vehicles for stop in (one.origin, one.destination)]
    lon = [*net.lon[nodes].tolist(), *(found.longitude(stop.lon) for stop in stops)]
    lat = [*net.lat[nodes].tolist(), *(stop.lat for stop in stops)]
    wide = max(LEAST_MARGIN, MARGIN * (max(lon) - min(lon)))
    high = max(LEAST_MARGIN, MARGIN * (max(lat) - min(lat)))
    return (min(lon) - wide, min(lat) - high, max(lon) + wide, max(lat) + high)
