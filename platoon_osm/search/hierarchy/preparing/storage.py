"""The hierarchy of a saved network, kept beside its file and rebuilt when it no longer fits.

The file is a plain `.npz`, whose checksums tell damage. It carries a hash of the graph's topology:
weights, lengths and names may change, but as soon as an edge comes or goes it is stale.
"""

from __future__ import annotations

import hashlib
import logging
import zipfile
from dataclasses import fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ....atomic_file import whole_file
from ....errors import MapDataError
from ....network.placed import PlacedNetwork, network_below
from ....network.road_network import RoadNetwork
from ...kept_topology import KeptTopology, hierarchy_path
from ..runtime.threads import cores
from .ranks import block_rows, runs
from .symbolic import Topology, build_topology

__all__ = ["hierarchy_path", "order_with_places", "topology_hash", "topology_of"]

Ints = NDArray[np.int32]

FORMAT_VERSION = 3
log = logging.getLogger(__name__)

MOST_LAST = 256
"""Of places beside the road that are contracted last: their arcs grow with the square of this."""


def topology_of(net: RoadNetwork, threads: int | None = None) -> Topology:
    """Return the hierarchy of a network: kept, else stored beside its file, else built and stored.

    A network opened from a file knows it; one made in memory is only kept. Two processes that
    build at once write files of their own and rename them, so each reads a whole one.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    threads : int, optional
        Cores to use; by default all.

    Returns
    -------
    Topology
        Order, arcs and triangles.
    """
    kept = net.attached(KeptTopology)
    known: Topology | None = kept.of(net)
    if known is not None:
        return known
    file = kept.file
    found = _read(hierarchy_path(file), net) if file is not None else None
    if found is None:
        cores_used = cores() if threads is None else threads
        below = network_below(net)
        order = None if below is net else order_with_places(net, topology_of(below, threads).node)
        found = build_topology(net.tail, net.head, net.lon, net.lat, cores_used, order)
        if file is not None:
            _write(hierarchy_path(file), net, found)
    kept.keep(net, found)
    return found


def order_with_places(net: RoadNetwork, below: Ints) -> Ints:
    """Return the order of contraction of a network with places, from that of the one without.

    A place inside an edge joins two nodes and nothing else, so it goes first. A place beside the
    road joins several, which would all become neighbours of each other if it went early: it goes
    last. But all that go last become neighbours of each other, so where there are more than
    `MOST_LAST` of them they go first after all.

    Parameters
    ----------
    net : RoadNetwork
        The network with places.
    below : ndarray of int, (n - p,)
        The order of the network below.

    Returns
    -------
    ndarray of int, (n,)
        Nodes.
    """
    assert isinstance(net, PlacedNetwork)
    places = np.arange(len(below), net.n)
    on_road = net.place_edge >= 0
    beside = places[~on_road]
    if len(beside) > MOST_LAST:
        return np.concatenate([places[on_road], beside, below]).astype(np.int32)
    return np.concatenate([places[on_road], below, beside]).astype(np.int32)


def topology_hash(net: RoadNetwork) -> str:
    """Return a hash of which edges join which nodes, and of this module's format.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    str
        Hexadecimal digits.
    """
    digest = hashlib.sha256(f"{FORMAT_VERSION} {net.n} {net.m}".encode())
    digest.update(np.ascontiguousarray(net.tail).data)
    digest.update(np.ascontiguousarray(net.head).data)
    return digest.hexdigest()


def _write(path: Path, net: RoadNetwork, topology: Topology) -> None:
    arrays = {item.name: getattr(topology, item.name) for item in fields(Topology)}
    try:
        with whole_file(path, MapDataError) as draft, draft.open("wb") as out:
            np.savez(out, hash=np.array(topology_hash(net)), **arrays)
    except MapDataError as error:
        # A map may lie in a folder that cannot be written; the hierarchy is then built each time.
        log.info("%s: hierarchy not stored (%s)", path, error)


def _read(path: Path, net: RoadNetwork) -> Topology | None:
    if not path.is_file():
        return None
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as stored:
            if str(stored["hash"]) != topology_hash(net):
                log.info("%s: made for another network; building anew", path)
                return None
            topology = Topology(**{item.name: stored[item.name] for item in fields(Topology)})
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        log.warning("%s: damaged (%s); building anew", path, error)
        return None
    if not _is_sound(topology, net):
        log.warning("%s: damaged; building anew", path)
        return None
    return topology


def _is_sound(t: Topology, net: RoadNetwork) -> bool:
    """Tell whether kernels, which check no bounds, may be let loose on these arrays."""
    n, a = net.n, len(t.head)
    expected = {
        "node": (n, "i4"), "rank": (n, "i4"), "first": (n + 1, "i4"), "head": (a, "i4"),
        "upper": (a, "i4"), "run": (len(t.run), "i4"), "block": (len(t.block), "i4"),
        "local": (a, "i4"),
        "parent": (n, "i4"), "triangle": (len(t.triangle), "i4"), "triangle_first": (n + 1, "i8"),
        "forth": (a, "i4"), "back": (a, "i4"),
        "spare": (len(t.spare), "i4"), "spare_place": (len(t.spare), "i4"),
        "subtree": (len(t.subtree), "i4"),
    }  # fmt: skip
    for name, (size, kind) in expected.items():
        array = getattr(t, name)
        if array.shape != (size,) or array.dtype != np.dtype(kind):
            return False
    ranks = np.arange(n, dtype=np.int32)
    degree = np.diff(t.first)
    tail = np.repeat(ranks, np.maximum(degree, 0)) if len(degree) else t.head[:0]
    return bool(
        len(t.subtree) >= 1
        and _climbs(t.first, a)
        and _climbs(t.triangle_first, len(t.triangle))
        and np.array_equal(np.diff(t.triangle_first), degree.astype(np.int64) * (degree - 1) // 2)
        and _within(t.node, 0, n)
        and np.array_equal(t.rank[t.node], ranks)
        and len(tail) == a
        and (t.head > tail).all()
        and _within(t.head, 0, n)
        and np.array_equal(t.upper, t.node[t.head])
        and np.array_equal(t.run, runs(t.first))
        and len(t.block) >= 1
        and _climbs(t.block, n)
        and (np.diff(t.block) > 0).all()
        and _fits_blocks(t)
        and ((t.parent == -1) | (t.parent > ranks)).all()
        and _within(t.parent, -1, n)
        and _within(t.triangle, 0, a)
        and _within(t.forth, 0, net.m + 1)
        and _within(t.back, 0, net.m + 1)
        and _within(t.spare, 0, net.m)
        and _within(t.spare_place, 0, 2 * a)
        and (np.diff(t.spare_place) >= 0).all()
        and (np.diff(t.subtree) >= 0).all()
        and _within(t.subtree, 0, n + 1)
    )


def _fits_blocks(t: Topology) -> bool:
    try:
        return np.array_equal(t.local, block_rows(t.first, t.head, t.block))
    except ValueError:
        return False


def _climbs(first: np.ndarray, total: int) -> bool:
    return bool(first[0] == 0 and first[-1] == total and (np.diff(first) >= 0).all())


def _within(values: np.ndarray, low: int, high: int) -> bool:
    return not len(values) or bool(values.min() >= low and values.max() < high)
