"""Networks with places between their junctions and beside their roads, and trips among them."""

import numpy as np
from hypothesis import strategies as st
from made_networks import degrees
from made_networks import network as made
from random_networks import road_networks

from platoon_osm.costs.paper import PaperCosts
from platoon_osm.errors import PlatoonError
from platoon_osm.network.geodesy import metres_per_degree
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip

COSTS = PaperCosts(tau=1.0, xi=0.18)


@st.composite
def places_on(draw, net):
    """A node, a point on an edge, or one beside the road."""
    kind = draw(st.sampled_from(["node", "on", "on", "beside"]))
    if kind == "node":
        return draw(st.integers(0, net.n - 1))
    edge = draw(st.integers(0, net.m - 1))
    share = draw(st.floats(0.02, 0.98))
    (lon, lat), (to_lon, to_lat) = net.shape(edge)[[0, -1]]
    at = np.array([lon + share * (to_lon - lon), lat + share * (to_lat - lat)])
    if kind == "beside":
        metres, turn = draw(st.floats(200, 12_000)), draw(st.floats(0, 6.28))
        per_lon, per_lat = metres_per_degree(lat)
        at += metres * np.array([np.cos(turn) / per_lon, np.sin(turn) / per_lat])
    return float(at[0]), float(at[1])


@st.composite
def problems(draw, most_trips=3):
    net = draw(road_networks(most_nodes=7))
    shared = [draw(places_on(net)) for _ in range(draw(st.integers(2, 5)))]
    trips = []
    for k in range(draw(st.integers(2, most_trips))):
        start, end = draw(st.sampled_from(shared)), draw(st.sampled_from(shared))
        trips.append(Trip("ABC"[k], start, end))
    return net, trips


def planned(net, trips, case, **options):
    """Return the plan; None where a trip ends where it starts, or has no way."""
    try:
        return plan_joint(net, COSTS, trips, case, **options)
    except PlatoonError as error:
        if "same place" in str(error) or "no route" in str(error):
            return None
        raise


def carriageways(gap=40, km=100):
    """Two carriageways between three junctions, eastbound below and westbound above.

    0 = 1 = 2 on the south side from west to east, 3 = 4 = 5 on the north side from east to west,
    and ways round at both ends.
    """
    far = km * 1000
    nodes = [(0, 0), (far, 0), (2 * far, 0), (2 * far, gap), (far, gap), (0, gap)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)]
    return made(nodes, edges, node_name=["West", "Mitte", "Ost", "Ost", "Mitte", "West"])


def at(east, north=0.0):
    return tuple(float(value) for value in degrees(east, north))
