"""A motorway of four junctions with one ramp on and one off, and a vehicle for each."""

import numpy as np

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.study.random_network import Draw

KM = 1000.0

#   4           5
#   | 10        ^ 10
#   v           |
# 0 - 1 -- 2 -- 3     0-1, 1-2, 2-3 are 100 km each; 4-1 and 2-5 are 10 km.


def ramps(origins=(0, 4), destinations=(3, 5)):
    tail, head, km = [0, 1, 2, 4, 2], [1, 2, 3, 1, 5], [100, 100, 100, 10, 10]
    net = RoadNetwork.from_edges(
        tail, head, np.array(km) * KM,
        lon=[0.0, 0.9, 1.8, 2.7, 0.9, 1.8], lat=[0.0, 0.0, 0.0, 0.0, 0.1, -0.1],
    )  # fmt: skip
    return Draw(
        net, np.array(origins), np.array(destinations), np.zeros(net.m, bool), net.lon, net.lat
    )
