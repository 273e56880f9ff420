"""Who drives longer than 4 h 30 at a stretch: where, and when where there are times.

A plan without driving rules sets no breaks, so a page says where one falls due. Driving in a
platoon is driving; a wait of 45 min or more is counted as a break. Under rules their clocks tell.
"""

from __future__ import annotations

import numpy as np

from ...costs.fatigue import FITTED_RANGE_S
from ...plans.records import Stretch
from ...shown_text import fitted
from .findings import Findings
from .model_day import LongDrive

__all__ = ["BREAK_S", "MOST_DRIVING_S", "long_drives"]

MOST_DRIVING_S = FITTED_RANGE_S[1]
"""The longest legal spell of driving without a break."""

BREAK_S = 2700.0
"""A break that begins a new spell."""


def long_drives(found: Findings) -> tuple[LongDrive, ...]:
    """Return who drives too long without a break.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    tuple of LongDrive
        In the order of the vehicles, the first such spell of each.
    """
    drives = (_long_drive(found, index) for index in range(len(found.plan.vehicles)))
    return tuple(drive for drive in drives if drive is not None)


def _long_drive(found: Findings, index: int) -> LongDrive | None:
    plan = found.plan
    times = plan.times[index]
    spell_s = before_m = 0.0
    due: LongDrive | None = None
    for number, stretch_id in enumerate(plan.ways[index]):
        stretch = plan.stretches[stretch_id]
        if times is not None and times.waits[number] >= BREAK_S:
            if due is not None:
                break
            spell_s = 0.0
        left_s = MOST_DRIVING_S - spell_s
        spell_s += stretch.drive_s
        if due is None and spell_s > MOST_DRIVING_S + 1:
            share = left_s / stretch.drive_s
            due = LongDrive(
                vehicle=index,
                drive_s=0.0,
                at_m=before_m + share * stretch.length_m,
                # The schedule draws a stretch at its mean speed too.
                at_s=None if times is None else times.legs[number][0] + left_s,
                place=_place(found, stretch, share),
            )
        before_m += stretch.length_m
    if due is None:
        return None
    return LongDrive(due.vehicle, spell_s, due.at_m, due.at_s, due.place)


def _place(found: Findings, stretch: Stretch, share: float) -> str:
    """Return the junction nearest to a point of a stretch; empty beside the road."""
    if not stretch.edges:
        return ""
    net = found.net
    edges = np.asarray(stretch.edges, np.int64)
    reached = np.concatenate([[0.0], np.cumsum(net.length_m[edges])])
    nodes = net.path_nodes(stretch.edges)
    near = np.argsort(np.abs(reached - share * reached[-1]), kind="stable")
    return fitted(net.place_name(int(nodes[int(near[0])])))
