"""The bundled map of Italy, read once for all tests of a process that only look at it."""

from functools import cache

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.load import load_network


@cache
def italy() -> RoadNetwork:
    return load_network("italy-motorways")
