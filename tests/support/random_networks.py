"""Random networks and trips for hypothesis."""

import numpy as np
from hypothesis import strategies as st

from platoon_osm.costs.paper import PaperCosts, paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.trip import Trip


def network(tails, heads, length_m, lon=None, lat=None):
    """A network whose edges keep the order given, if that is sorted by tail."""
    n = int(max(*tails, *heads)) + 1 if lon is None else len(lon)
    return RoadNetwork.from_edges(
        tails, heads, length_m,
        lon=9 + np.arange(n) / 10 if lon is None else lon,
        lat=45 + (np.arange(n) % 3) / 10 if lat is None else lat,
    )  # fmt: skip


@st.composite
def tied_networks(draw, free_platoon=True, company_never_dearer=True):
    """Small multigraphs full of ties: small whole numbers for every weight.

    One-way and parallel edges, loops, edges of no length, parts that do not connect. All sums are
    exact, so that equal costs are truly equal.
    """
    n = draw(st.integers(2, 6))
    m = draw(st.integers(1, 14))
    node = st.integers(0, n - 1)
    ends = sorted((draw(node), draw(node)) for _ in range(m))
    small = st.integers(0, 4)
    length = np.array([draw(small) for _ in ends], float)
    solo = np.array([draw(small) for _ in ends], float)
    below = st.sampled_from([0, 0.5, 0.75, 1])
    top = np.ones(m) if company_never_dearer else np.full(m, 2.0)
    platoon = solo * top * [draw(below) for _ in ends]
    master = solo * [draw(below) for _ in ends]
    if not free_platoon:
        # No way of some length that costs nothing: then longest least-cost ways exist.
        solo, platoon, master = solo + length, platoon + length, master + length
    lon, lat = 9 + np.arange(n) / 10, np.full(n, 45.0)
    net = network([a for a, _ in ends], [b for _, b in ends], length, lon, lat)
    return net, EdgeWeights(solo, platoon, master, "m", {})


@st.composite
def routes(draw, net):
    """Some drive along the network: edge ids that follow each other."""
    edge = draw(st.integers(0, net.m - 1))
    route = [edge]
    for _ in range(draw(st.integers(0, 6))):
        onward = np.arange(net.first_out[net.head[edge]], net.first_out[net.head[edge] + 1])
        if not len(onward):
            break
        edge = int(onward[draw(st.integers(0, len(onward) - 1))])
        route.append(edge)
    return np.array(route)


@st.composite
def road_networks(draw, most_nodes=9):
    """Strongly connected networks on a map, with lengths that never tie by accident."""
    n = draw(st.integers(4, most_nodes))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    ring = np.arange(n)
    extra = draw(st.integers(0, 2 * n))
    tails = np.concatenate([ring, rng.integers(0, n, extra)])
    heads = np.concatenate([np.roll(ring, -1), rng.integers(0, n, extra)])
    order = np.lexsort((heads, tails))
    length = rng.uniform(5e3, 9e4, len(tails))
    return network(
        tails[order], heads[order], length, rng.uniform(8, 12, n), rng.uniform(44, 46, n)
    )


@st.composite
def problems(draw, most_trips=4, trips_at_least=2):
    """A network, the paper's weights and some trips."""
    net = draw(road_networks())
    costs = PaperCosts(
        tau=draw(st.sampled_from([0.0, 0.3, 1.0])),
        xi=draw(st.sampled_from([0.0, 0.18, 1.0])),
        mixing=draw(st.sampled_from(["printed", "gain"])),
    )
    trips = []
    for k in range(draw(st.integers(trips_at_least, most_trips))):
        origin = draw(st.integers(0, net.n - 1))
        away = draw(st.integers(1, net.n - 1))
        trips.append(Trip("ABCDE"[k], origin, (origin + away) % net.n))
    return net, paper_weights(net, costs), trips
