"""Towns around a network: its own, and those of the table where its map names none."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from functools import cache, cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..antimeridian import middle_longitude_deg, near_deg
from ..geodesy import distance_m, metres_per_degree
from ..location import format_position
from ..nearest_point import NearestPoint
from ..road_network import POINT_KINDS, RoadNetwork
from ..spelling import fold
from .table import TownTable, bundled_towns

__all__ = ["FARTHEST_TOWN_M", "GEONAMES", "GEONAMES_CREDIT", "NearTown", "Town", "TownsAround"]

FARTHEST_TOWN_M = 50_000.0
"""A town farther away than this is no help to find a place."""

ONE_TOWN_M = 15_000.0
"""Of towns that share a further name, one this near to a larger one is a part of it."""

GEONAMES = "GeoNames"

GEONAMES_CREDIT = "names of towns: GeoNames (https://www.geonames.org), CC BY 4.0"
"""To be shown with everything in which a town of the table is named, and with nothing else."""


class NearTown(NamedTuple):
    """The town by which a place is known."""

    name: str
    source: Literal["map", "GeoNames"]
    spellings: frozenset[str]


class Town(NamedTuple):
    """A town of the table.

    Attributes
    ----------
    name : str
        What it is called first.
    lon, lat : float
        Degrees.
    where : str
        Its region, if known, and country.
    lies_in : frozenset of str
        What its region and country are called, as `fold` spells them.
    """

    name: str
    lon: float
    lat: float
    where: str
    lies_in: frozenset[str]

    def label(self) -> str:
        """Return how the town is told from others of its name.

        Returns
        -------
        str
            Name, region, country, and coordinates.
        """
        return f"{self.name}, {self.where} ({format_position(self.lon, self.lat)})"


class TownsAround:
    """The towns in reach of a network's roads; kept with it by `net.attached`.

    The table is read when it is first needed: never, where the map has towns of its own.

    Parameters
    ----------
    net : RoadNetwork
        Whose roads.
    """

    def __init__(self, net: RoadNetwork) -> None:
        # Not the network itself, which holds this: both would outlive their use together.
        self._lon, self._lat = net.lon, net.lat
        self._shape = net.shape_lon, net.shape_lat
        own = np.flatnonzero(net.points.kind >= POINT_KINDS.index("city"))
        self._own_names = [net.texts[code].strip() for code in net.points.name[own]]
        named = [k for k, name in enumerate(self._own_names) if name]
        self._own_names = [self._own_names[k] for k in named]
        own = own[named]
        self._own_at = list(
            zip(net.points.lon[own].tolist(), net.points.lat[own].tolist(), strict=True)
        )
        self._own = NearestPoint(net.points.lon[own], net.points.lat[own], FARTHEST_TOWN_M)

    def nearest(self, lon: float, lat: float) -> NearTown | None:
        """Return the town nearest to a place: of the map, or else of the table.

        Parameters
        ----------
        lon, lat : float
            The place [deg].

        Returns
        -------
        NearTown or None
            Its name and where that is from; None if none is in reach.
        """
        own = self._own.to(lon, lat)
        if own is not None:
            name = self._own_names[own]
            return NearTown(name, "map", frozenset({fold(name)}))
        listed = self._listed.to(lon, lat)
        if listed is None:
            return None
        row = int(self._rows[listed])
        name = self._table.names()[row]
        spellings = frozenset({fold(name), *self._table.further_names()[row]})
        return NearTown(name, "GeoNames", spellings)

    def called(self, folded: str) -> list[Town]:
        """Return the towns of the table that have a name and lie in reach of the roads.

        Parameters
        ----------
        folded : str
            A name as `fold` spells it.

        Returns
        -------
        list of Town
            Those that are called so first; if none is, those that are called so too. The largest
            come first.
        """
        first, further = self._by_name
        rows = self._in_reach(first.get(folded, ()))
        if not rows:
            rows = self._in_reach(further.get(folded, ()))
            rows = [row for k, row in enumerate(rows) if not self._near_one_of(row, rows[:k])]
        return [self._town(row) for row in rows]

    def positions(self, folded: str) -> list[tuple[float, float]]:
        """Return where towns of a name lie, those of the map and those of the table.

        Parameters
        ----------
        folded : str
            A name as `fold` spells it.

        Returns
        -------
        list of (float, float)
            Longitude and latitude [deg].
        """
        first, further = self._by_name
        rows = self._in_reach([*first.get(folded, ()), *further.get(folded, ())])
        own = [
            at
            for at, name in zip(self._own_at, self._own_names, strict=True)
            if fold(name) == folded
        ]
        return own + [(float(self._table.lon[row]), float(self._table.lat[row])) for row in rows]

    def called_elsewhere(self, folded: str) -> Town | None:
        """Return the largest town of the whole table that has a name, to say where it is.

        Parameters
        ----------
        folded : str
            A name as `fold` spells it.

        Returns
        -------
        Town or None
            The town; None if there is none.
        """
        table = bundled_towns()
        first, further = _everywhere()
        rows = first.get(folded) or further.get(folded)
        return self._town(max(rows, key=lambda row: table.population[row])) if rows else None

    def nearest_spellings(self, folded: str) -> list[str]:
        """Return towns of the table around the network that are spelt nearly like a name.

        Parameters
        ----------
        folded : str
            A name as `fold` spells it.

        Returns
        -------
        list of str
            At most four, as they are called first.
        """
        first, further = self._by_name
        near = difflib.get_close_matches(folded, {**first, **further}, 4, 0.75)
        rows = [row for key in near for row in self._in_reach((first.get(key) or further[key])[:1])]
        return list(dict.fromkeys(self._table.names()[row] for row in rows))

    # -- the part of the table that lies around the network --------------------------------------

    @property
    def _table(self) -> TownTable:
        return bundled_towns()

    @cached_property
    def _rows(self) -> NDArray[np.int64]:
        """Rows within the box around all nodes and a margin."""
        if not len(self._lon):
            return np.zeros(0, np.int64)
        table = self._table
        # Counted on across the antimeridian, so that the box is no wider than it must be.
        own = near_deg(self._lon, middle_longitude_deg(self._lon))
        west, east = float(own.min()), float(own.max())
        south, north = float(self._lat.min()), float(self._lat.max())
        farthest = min(max(abs(south), abs(north)) + 1.0, 89.0)
        per_lon = float(metres_per_degree(farthest)[0])
        per_lat = float(metres_per_degree(0.0)[1])
        wide, high = FARTHEST_TOWN_M / per_lon, FARTHEST_TOWN_M / per_lat
        # Round the globe: a network at the date line sees towns beyond it.
        across = np.mod(table.lon - (west - wide), 360.0) <= east - west + 2 * wide
        inside = across & (table.lat >= south - high) & (table.lat <= north + high)
        return np.flatnonzero(inside)

    @cached_property
    def _listed(self) -> NearestPoint:
        return NearestPoint(
            self._table.lon[self._rows], self._table.lat[self._rows], FARTHEST_TOWN_M
        )

    @cached_property
    def _by_name(self) -> tuple[dict[str, list[int]], dict[str, list[int]]]:
        """Rows by what they are called first, and by what they are called too, largest first."""
        table = self._table
        first: dict[str, list[int]] = {}
        further: dict[str, list[int]] = {}
        order = np.argsort(-table.population[self._rows].astype(np.int64), kind="stable")
        for row in self._rows[order].tolist():
            first.setdefault(fold(table.names()[row]), []).append(row)
            for name in table.further_names()[row]:
                further.setdefault(name, []).append(row)
        return first, further

    def _in_reach(self, rows: Iterable[int]) -> list[int]:
        return [row for row in rows if self._road_m(row) <= FARTHEST_TOWN_M]

    def _road_m(self, row: int) -> float:
        """Distance [m] from a town to the nearest point of a road's shape."""
        lon, lat = self._shape if len(self._shape[0]) else (self._lon, self._lat)
        at = float(self._table.lon[row]), float(self._table.lat[row])
        return float(distance_m(lon, lat, *at).min())

    def _near_one_of(self, row: int, others: Iterable[int]) -> bool:
        lon, lat = self._table.lon, self._table.lat
        return any(
            float(distance_m(lon[row], lat[row], lon[other], lat[other])) <= ONE_TOWN_M
            for other in others
        )

    def _town(self, row: int) -> Town:
        table = self._table
        country = table.country_name(int(table.country[row]))
        region = table.region_name(int(table.region[row]))
        return Town(
            table.names()[row], float(table.lon[row]), float(table.lat[row]),
            f"{region}, {country}" if region else country,
            frozenset(fold(text) for text in table.lies_in(row)),
        )  # fmt: skip


@cache
def _everywhere() -> tuple[dict[str, list[int]], dict[str, list[int]]]:
    """Return the rows of the whole table by what towns are called first, and called too."""
    table = bundled_towns()
    first: dict[str, list[int]] = {}
    further: dict[str, list[int]] = {}
    for row, (name, others) in enumerate(zip(table.names(), table.further_names(), strict=True)):
        first.setdefault(fold(name), []).append(row)
        for other in set(others):
            further.setdefault(other, []).append(row)
    return first, further
