"""What driving really costs by place and size of a company, and by its pace.

Vehicles choose by one weight in company (`EdgeWeights.platoon`), for who else will be there is not
known then. Objectives that know more tell by this what each pays in the end: never more than it was
planned with.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from .share import Share

__all__ = ["ByPlace"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


class ByPlace(Protocol):
    """Costs of one vehicle on one network by its place in a company."""

    @property
    def told_sizes(self) -> tuple[int, ...]:
        """The sizes whose places may cost unlike amounts, and one beyond for the rest."""
        ...

    def share(self, edges: Index, position: int, size: int, drive_s: Floats | None) -> Share:
        """Return what the vehicle pays on a stretch.

        Parameters
        ----------
        edges : ndarray of int, (k,)
            Edges of the stretch.
        position : int
            Place of the vehicle in the company; 0 leads.
        size : int
            Vehicles in the company.
        drive_s : ndarray of float, (k,), or None
            How long the company drives each edge [s]; None for the vehicle's own pace.

        Returns
        -------
        Share
            Cost and fuel, as planned and alone.
        """
        ...

    def in_place(self, position: int, size: int, drive_s: Floats | None) -> Floats:
        """Return what the vehicle pays on each edge in a place of a company.

        Parameters
        ----------
        position : int
            Place of the vehicle in the company; 0 leads.
        size : int
            Vehicles in the company.
        drive_s : ndarray of float, (m,), or None
            How long the company drives each edge [s]; None for the vehicle's own pace.

        Returns
        -------
        ndarray of float, (m,)
            All terms together.
        """
        ...

    def planned(self, slowest_s: Floats | None) -> tuple[Floats, Floats]:
        """Return the most a member and a master may pay on each edge, whoever drives with them.

        Parameters
        ----------
        slowest_s : ndarray of float, (m,), or None
            How long the slowest vehicle drives each edge [s]; None if all are as fast.

        Returns
        -------
        tuple of ndarray of float, (m,)
            Of a member and of a master.
        """
        ...

    def least(self, vehicles: int, slowest_s: Floats | None) -> float:
        """Return the least ratio of what may really be paid in company to what is planned with.

        Parameters
        ----------
        vehicles : int
            How many there are in all.
        slowest_s : ndarray of float, (m,), or None
            As in `planned`.

        Returns
        -------
        float
            At most 1, which it is where neither places nor paces matter.
        """
        ...

    def on(self, net: RoadNetwork) -> ByPlace:
        """Return the same on another network.

        Parameters
        ----------
        net : RoadNetwork
            Such as one with places between its junctions.

        Returns
        -------
        ByPlace
            Of the same vehicle.
        """
        ...
