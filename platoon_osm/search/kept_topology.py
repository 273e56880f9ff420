"""The hierarchy of a network: kept once it is made, and known to lie beside the network's file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..network.road_network import RoadNetwork

__all__ = ["KeptTopology", "hierarchy_path"]


def hierarchy_path(file: str | Path) -> Path:
    """Return where the hierarchy of a saved network is stored.

    Parameters
    ----------
    file : str or Path
        File of the network.

    Returns
    -------
    Path
        A file beside it.
    """
    path = Path(file)
    return path.with_name(path.name + ".hierarchy")


class KeptTopology:
    """The order and the arcs of one network, made for some arrays and good for no others.

    Parameters
    ----------
    net : RoadNetwork
        The network; `net.attached(KeptTopology)` makes one and keeps it.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self.file: Path | None = net.file
        self._made: tuple[Any, Any, Any] | None = None

    def of(self, net: RoadNetwork) -> Any | None:
        """Return the hierarchy if it was made for the arrays that a network has now.

        Parameters
        ----------
        net : RoadNetwork
            The network searched.

        Returns
        -------
        Topology or None
            None if there is none that fits.
        """
        if self._made is None or self._made[0] is not net.tail or self._made[1] is not net.head:
            return None
        return self._made[2]

    def keep(self, net: RoadNetwork, topology: Any) -> None:
        """Keep the hierarchy of a network.

        Parameters
        ----------
        net : RoadNetwork
            The network it was made for.
        topology : Topology
            Order, arcs and triangles.
        """
        self._made = net.tail, net.head, topology

    def is_stored(self) -> bool:
        """Tell whether there is a file to read the hierarchy from.

        Returns
        -------
        bool
            Whether it lies beside the network's file; it may still be stale.
        """
        return self.file is not None and hierarchy_path(self.file).is_file()
