"""Where trips of a vehicle may start and end: on roads that are open to it."""

from __future__ import annotations

from ..network.road_network import RoadNetwork
from ..network.usable_nodes import UsableNodes
from .closures import Closures
from .profile import Vehicle

__all__ = ["VehicleNodes"]


class VehicleNodes:
    """Usable nodes by vehicle; `net.attached(VehicleNodes)` keeps them.

    Parameters
    ----------
    net : RoadNetwork
        Whose nodes.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self._known: dict[Vehicle, UsableNodes] = {}
        del net  # it holds this, and is given again when a vehicle asks

    def of(self, net: RoadNetwork, vehicle: Vehicle) -> UsableNodes:
        """Return the nodes where trips of a vehicle may start and end.

        Parameters
        ----------
        net : RoadNetwork
            The same network.
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        UsableNodes
            Those of the whole network where nothing is closed to it.
        """
        if vehicle not in self._known:
            closed = net.attached(Closures).of(vehicle).closed
            self._known[vehicle] = (
                UsableNodes(net, closed) if closed.any() else net.attached(UsableNodes)
            )
        return self._known[vehicle]
