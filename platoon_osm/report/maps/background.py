"""The network behind many maps: its lines are laid on the plane once, then cut for each map."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ..drawing.lines import Line
from .map_view import MapView, mercator
from .pixels import network_data

__all__ = ["Background"]


class Background:
    """Lines of a network that several maps show.

    Parameters
    ----------
    lines : iterable of Line
        Of a document.
    """

    def __init__(self, lines: Iterable[Line]) -> None:
        some = [line.degrees() for line in lines if len(line.points) > 1]
        plane = [mercator(lon, lat) for line in some for lon, lat in line]
        self._plane = np.array(plane, np.float64).reshape(-1, 2)
        self._sizes = np.array([len(line) for line in some], np.int64)

    def path(self, view: MapView, most: int) -> str:
        """Return what a map shows of it.

        Parameters
        ----------
        view : MapView
            The map.
        most : int
            About how many characters it may take.

        Returns
        -------
        str
            SVG path data, as `network_path` has it.
        """
        return network_data(view.on_map(self._plane), self._sizes, view.width, view.height, most)
