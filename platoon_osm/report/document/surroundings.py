"""What lies around a network: land and sea under it, and towns, to know where it is."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...network.antimeridian import near_deg
from ...network.geodesy import distance_m
from ...network.road_network import RoadNetwork
from ...network.towns.surroundings import GEONAMES_CREDIT
from ...network.towns.table import bundled_towns
from ...shown_text import shortened, shown
from ..drawing.basemap import BASEMAP_STEPS
from ..drawing.lines import Point
from ..ground.clipping import Frame
from ..ground.model import Ground
from ..ground.patches import ground_under
from ..language.speech import say
from .model import LabelledText, Provenance
from .model_map import TownLabel
from .place_labels import LONGEST_NAME, town_labels

__all__ = ["Surroundings", "surroundings"]

CITY, TOWN = 100_000, 30_000
"""Inhabitants from which on a listed town is one; smaller ones count as villages."""

MOST_NEAR, MOST_WIDE = 90, 20
"""Listed towns in the network's own part of the world, and around that."""

LEAST_WIDE = 250_000
"""Inhabitants a town must have to be named around the network's own part of the world."""

NEAR_APART, WIDE_APART = 45, 22
"""So many towns may stand in a row across such a part; further ones between them are left out."""

LEAST_APART_M = 4_000.0


@dataclass(frozen=True, slots=True, eq=False)
class Surroundings:
    """Ground and towns of a document.

    Attributes
    ----------
    ground : Ground or None
        None for a network that does not lie on land.
    towns : tuple of TownLabel
        Those of the map, and listed ones where it has none; the most important first.
    credits : tuple of str
        Whom to name for them.
    """

    ground: Ground | None
    towns: tuple[TownLabel, ...]
    credits: tuple[str, ...]

    def told_in(self, provenance: Provenance) -> Provenance:
        """Return where a plan comes from, and what its ground is made of.

        Parameters
        ----------
        provenance : Provenance
            Of the plan.

        Returns
        -------
        Provenance
            With a row and credits more.
        """
        if self.ground is None:
            return provenance
        row = LabelledText(say("ground.label"), say("ground.source"))
        return replace(
            provenance,
            rows=(*provenance.rows, row),
            credits=tuple(dict.fromkeys([*provenance.credits, *self.credits])),
        )


def surroundings(net: RoadNetwork, stops: Sequence[Point]) -> Surroundings:
    """Return what lies around a network and a plan on it.

    Parameters
    ----------
    net : RoadNetwork
        Its own towns are named first.
    stops : sequence of tuple of float
        Longitude and latitude of the plan's starts and destinations.

    Returns
    -------
    Surroundings
        Ground and towns.

    Raises
    ------
    NetworkError
        A table of the package is damaged.
    """
    own = town_labels(net)
    ground = ground_under(net, stops)
    if ground is None:
        return Surroundings(None, own, ())
    found = list(own)
    frames = [patch.frame for patch in ground.patches]
    for frame, least, most, apart in (
        (frames[min(2, len(frames) - 1)], 0, MOST_NEAR, NEAR_APART),
        (frames[min(1, len(frames) - 1)], LEAST_WIDE, MOST_WIDE, WIDE_APART),
    ):
        found += _listed(frame, least, most, apart, found)
    towns = tuple(sorted(found, key=lambda town: town.rank))
    return Surroundings(ground, towns, (GEONAMES_CREDIT,) if len(found) > len(own) else ())


def _listed(
    frame: Frame, least: int, most: int, apart: int, known: Iterable[TownLabel]
) -> list[TownLabel]:
    """Return listed towns of a frame, the largest first, none near another one."""
    table = bundled_towns()
    middle = (frame.west + frame.east) / 2
    # As far round the globe as the frame is.
    lon = near_deg(table.lon, middle)
    inside = (lon > frame.west) & (lon < frame.east)
    inside &= (table.lat > frame.south) & (table.lat < frame.north)
    rows = np.flatnonzero(inside & (table.population >= least))
    rows = rows[np.argsort(-table.population[rows].astype(np.int64), kind="stable")]
    across = float(distance_m(middle, frame.south, middle, frame.north))
    reach = max(across / apart, LEAST_APART_M)
    taken = [(town.lon / BASEMAP_STEPS, town.lat / BASEMAP_STEPS) for town in known]
    found: list[TownLabel] = []
    for row in rows.tolist():
        at = float(lon[row]), float(table.lat[row])
        if _is_near(at, taken, reach):
            continue
        taken.append(at)
        people = int(table.population[row])
        rank = 0 if people >= CITY else 1 if people >= TOWN else 2
        name = shortened(shown(table.names()[row]), LONGEST_NAME)
        found.append(TownLabel(_steps(at[0]), _steps(at[1]), name, rank))
        if len(found) == most:
            break
    return found


def _steps(degrees: float) -> int:
    return round(degrees * BASEMAP_STEPS)


def _is_near(at: Point, others: Sequence[Point], reach_m: float) -> bool:
    if not others:
        return False
    # The cheap box first: most are far away.
    degrees = reach_m / 100_000
    wide = degrees / max(math.cos(math.radians(at[1])), 0.05)
    near = [one for one in others if abs(one[1] - at[1]) < degrees and abs(one[0] - at[0]) < wide]
    return any(float(distance_m(*at, *one)) < reach_m for one in near)
