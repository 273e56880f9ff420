"""Which roads of a network are closed to a vehicle, and why: equal restrictions judged once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..network.restrictions import decode
from ..network.road_network import RoadNetwork
from .access import Way
from .judgement import Judgement, judge
from .profile import Vehicle

__all__ = ["Closed", "Closures"]

Marks = NDArray[np.bool_]

OPEN = Judgement()


@dataclass(frozen=True, slots=True, eq=False)
class Closed:
    """Which edges a vehicle may not drive.

    Attributes
    ----------
    closed : ndarray of bool, (m,)
        Closed at any time, or by hours that are not known to be open.
    ends : ndarray of bool, (m,)
        Open to it only where a trip starts or ends.
    """

    closed: Marks
    ends: Marks


class Closures:
    """Judges the restrictions of a network; `net.attached(Closures)` keeps one.

    Parameters
    ----------
    net : RoadNetwork
        Whose restrictions.
    """

    def __init__(self, net: RoadNetwork) -> None:
        # Not the network itself, which holds this: both would outlive their use together.
        codes, self._row = np.unique(net.restriction, return_inverse=True)
        self._layers = [decode(net.texts[code]) for code in codes.tolist()]
        self._length_m = net.length_m
        self._known: dict[Vehicle, tuple[Judgement, ...]] = {}

    def of(self, vehicle: Vehicle) -> Closed:
        """Return which edges are closed to a vehicle, hours left open.

        Parameters
        ----------
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        Closed
            Marks of all edges.
        """
        judged = self._judged(vehicle)
        ways = np.array([one.way for one in judged], np.int64)[self._row]
        return Closed(ways == Way.CLOSED, ways == Way.ENDS)

    def on(self, edge: int, vehicle: Vehicle) -> Judgement:
        """Judge one edge, hours left open.

        Parameters
        ----------
        edge : int
            Edge id.
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        Judgement
            Open where nothing is restricted.
        """
        return self._judged(vehicle)[int(self._row[edge])]

    def layers(self, edge: int) -> tuple[dict[str, str], ...]:
        """Return what the map restricts on an edge.

        Parameters
        ----------
        edge : int
            Edge id.

        Returns
        -------
        tuple of dict of str to str
            Tags of the road, of barriers on it, of the turn onto it.
        """
        return self._layers[int(self._row[edge])]

    def km_by_reason(self, vehicle: Vehicle) -> Mapping[str, float]:
        """Return how much road is not open to a vehicle, by the tags that decide.

        Parameters
        ----------
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        mapping of str to float
            "closed: maxheight" or "ends only: hgv" to km of carriageway, the most first.
        """
        metres = np.bincount(self._row, self._length_m, len(self._layers))
        found: dict[str, float] = {}
        for one, length in zip(self._judged(vehicle), metres.tolist(), strict=True):
            if one.way != Way.OPEN:
                label = "closed" if one.way == Way.CLOSED else "ends only"
                name = f"{label}: {', '.join(one.kinds)}"
                found[name] = found.get(name, 0.0) + length / 1000
        return dict(sorted(found.items(), key=lambda pair: (-pair[1], pair[0])))

    def _judged(self, vehicle: Vehicle) -> tuple[Judgement, ...]:
        if vehicle not in self._known:
            self._known[vehicle] = tuple(
                judge(layers, vehicle) if layers else OPEN for layers in self._layers
            )
        return self._known[vehicle]
