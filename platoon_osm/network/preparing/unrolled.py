"""A network laid on a plane: its longitudes are counted on across the antimeridian."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..antimeridian import continued_deg, middle_longitude_deg, near_deg
from ..placed import network_below
from ..road_network import RoadNetwork

__all__ = ["centre_longitude_deg", "unrolled"]


def centre_longitude_deg(net: RoadNetwork) -> float:
    """Return the meridian in the middle of a network.

    Parameters
    ----------
    net : RoadNetwork
        With places on it or without: they do not move the middle.

    Returns
    -------
    float
        In [-180, 180] [deg].
    """
    return network_below(net).attached(_centre)


def _centre(net: RoadNetwork) -> float:
    return middle_longitude_deg(np.concatenate([net.lon, net.shape_lon]))


def unrolled(net: RoadNetwork) -> RoadNetwork:
    """Return a network whose roads lie beside each other as on a plane, to be drawn or searched.

    Parameters
    ----------
    net : RoadNetwork
        Longitudes in [-180, 180].

    Returns
    -------
    RoadNetwork
        Its longitudes lie within half a turn of the network's middle, so that those of a network
        across the antimeridian go beyond 180 on one side; each shape is counted on from its first
        point. The network itself if none of that changes anything.
    """
    centre = centre_longitude_deg(net)
    lon = near_deg(net.lon, centre)
    start = net.shape_first[:-1]
    shape_lon = continued_deg(net.shape_lon, net.shape_first)
    moved = near_deg(net.shape_lon[start], centre) - net.shape_lon[start]
    if moved.any():
        shape_lon = shape_lon + np.repeat(moved, np.diff(net.shape_first))
    point_lon = near_deg(net.points.lon, centre)
    if (
        np.array_equal(lon, net.lon)
        and np.array_equal(shape_lon, net.shape_lon)
        and np.array_equal(point_lon, net.points.lon)
    ):
        return net
    points = replace(net.points, lon=point_lon)
    return replace(net, lon=lon, shape_lon=shape_lon, points=points, _file=None)
