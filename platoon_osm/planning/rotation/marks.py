"""Where on its road a company may hand on the lead: at junctions, and where it stands.

Where a stretch ends, because its vehicles pause there, is such a place too. Within an edge there is
none, unless the edge is longer by a stated length than the least share that anybody of the company
has to lead; then there is one every kilometre of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...network.road_network import RoadNetwork
from ...plans.records import Stretch
from ..timing.stops import Place

__all__ = ["Mark", "marks_of"]

STEP_M = 1000.0
"""How far places within a long edge are from each other [m]."""


APART_M = 1.0
"""Of places that are nearer to each other than this the first one will do [m]."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A place on the road of a company.

    Attributes
    ----------
    at_m : float
        How far it is from where the company begins [m].
    stretch : int
        Which of its stretches it lies on, counted from 0.
    cut : (int, float) or None
        Where on that stretch; None where the stretch begins.
    """

    at_m: float
    stretch: int
    cut: Place | None


def marks_of(
    net: RoadNetwork, stretches: Sequence[Stretch], share_m: float, longer_m: float
) -> list[Mark]:
    """Return where a company may hand on the lead.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges they name.
    stretches : sequence of Stretch
        Of the company, in driving order.
    share_m : float
        The least share that anybody is to lead [m].
    longer_m : float
        By how much an edge has to be longer for places within it [m].

    Returns
    -------
    list of Mark
        Ascending, without the beginning and the end of the company.
    """
    found: list[Mark] = []
    begin_m = 0.0
    for number, stretch in enumerate(stretches):
        if number:
            found.append(Mark(begin_m, number, None))
        found += (
            Mark(begin_m + at_m, number, cut)
            for at_m, cut in _within(net, stretch, share_m + longer_m)
        )
        begin_m += stretch.length_m
    apart: list[Mark] = []
    for mark in found:
        last_m = apart[-1].at_m if apart else 0.0
        if mark.at_m - last_m >= APART_M and begin_m - mark.at_m >= APART_M:
            apart.append(mark)
    return apart


def _within(net: RoadNetwork, stretch: Stretch, most_m: float) -> list[tuple[float, Place]]:
    edges = np.asarray(stretch.edges, np.int64)
    last = len(edges) - 1
    begin, end = np.zeros(len(edges)), np.ones(len(edges))
    begin[0], end[last] = stretch.span
    lengths = net.length_m[edges]
    driven = lengths * (end - begin)
    whole = float(driven.sum())
    # Pieces of a stretch that was cut before have their share of its length, not their own.
    scale = stretch.length_m / whole if whole > 0 else 1.0
    found: list[tuple[float, Place]] = []
    at = 0.0
    for place, own in enumerate((driven * scale).tolist()):
        if place:
            found.append((at, (place, 0.0)))
        if own > most_m:
            count = int(own // STEP_M)
            first, span = float(begin[place]), float(end[place] - begin[place])
            found += (
                (at + own * k / count, (place, first + span * k / count)) for k in range(1, count)
            )
        at += own
    return found
