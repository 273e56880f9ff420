"""The document of a fleet's plan: vehicles per road and how many of them in company, platoons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...errors import ScenarioError
from ...network.preparing.unrolled import unrolled
from ...network.road_network import RoadNetwork
from ...plans.convoys import Convoy, convoys_of, vehicle_m_by_size
from ...plans.fleet import FleetRecord
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...shown_text import fitted
from ..drawing.basemap import (
    BASEMAP_TOLERANCE_M,
    NETWORK_STEPS,
    ROUTE_STEPS,
    ROUTE_TOLERANCE_M,
    basemap_lines,
    route_line,
)
from ..drawing.lines import Line, Lines, Point
from ..markup.quantities import CostUnit
from .checks import check_plan, check_title
from .corridor import Corridor, Ends, corridor_of
from .flows import Histogram, histogram_of
from .model import Provenance
from .provenance import provenance
from .surroundings import Surroundings, surroundings
from .wording import plan_unit

__all__ = [
    "LISTED", "SHARES", "WIDTHS", "FleetDocument", "Listed", "Traffic", "fleet_document_of",
    "width_class",
]  # fmt: skip

WIDTHS = 5
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Upper ends of the classes of how many vehicles of a road drive in company."""

LISTED = 60
"""Platoons that the page lists without a script, and whose roads it shows."""


@dataclass(frozen=True, slots=True)
class Traffic:
    """Roads of about as many vehicles, of which about as many drive in company.

    Attributes
    ----------
    width, share : int
        Classes of the number of vehicles, and of the share of them that drive in company.
    low, high : int
        Least and most vehicles on one of these roads.
    lines : Lines
        As they are driven.
    """

    width: int
    share: int
    low: int
    high: int
    lines: Lines


@dataclass(frozen=True, slots=True)
class Listed:
    """A platoon of the list.

    Attributes
    ----------
    convoy : Convoy
        Of the plan.
    forms, parts : str
        What the places are called where it forms and parts.
    lines : tuple of Line
        Its road; none of those that the page does not show.
    """

    convoy: Convoy
    forms: str
    parts: str
    lines: tuple[Line, ...]


@dataclass(frozen=True, slots=True)
class FleetDocument:
    """All that the page of a fleet shows.

    Attributes
    ----------
    plan : Plan
        As it was planned.
    record : FleetRecord
        What is known of it.
    title : str or None
        Heads the page; None for one that is made.
    unit, list_unit : CostUnit
        How costs are printed, those of all and those of a platoon.
    around : Surroundings
        Ground and towns.
    network : tuple of Line
        The roads of the network.
    traffic : tuple of Traffic
        From few vehicles to many.
    most : int
        Most vehicles on one road.
    platoons : tuple of Listed
        Those that save most first.
    sizes : tuple of (int, float)
        Vehicle-metres by vehicles of a company.
    histogram : Histogram
        What vehicles save.
    corridor : Corridor or None
        None for a plan without times.
    provenance : Provenance
        Where all comes from.
    """

    plan: Plan
    record: FleetRecord
    title: str | None
    unit: CostUnit
    list_unit: CostUnit
    around: Surroundings
    network: tuple[Line, ...]
    traffic: tuple[Traffic, ...]
    most: int
    platoons: tuple[Listed, ...]
    sizes: tuple[tuple[int, float], ...]
    histogram: Histogram
    corridor: Corridor | None
    provenance: Provenance

    @property
    def points(self) -> list[Point]:
        """All points of the roads that are driven, in degrees."""
        return [at for one in self.traffic for line in one.lines for at in line.degrees()]


def fleet_document_of(
    plan: Plan, net: RoadNetwork, title: str | None, corridor: Ends | None
) -> FleetDocument:
    """Return what the page of a fleet shows.

    Parameters
    ----------
    plan : Plan
        Of a fleet.
    net : RoadNetwork
        The network it was made on.
    title : str or None
        Heads the page.
    corridor : tuple of int or str, (2,), or None
        Whose diagram is shown; by default the busiest road's.

    Returns
    -------
    FleetDocument
        All of it.

    Raises
    ------
    ScenarioError
        A plan of another network or of no fleet, or a corridor that nobody drives.
    """
    check_title(title)
    check_plan(plan, net)
    if plan.fleet is None:
        raise ScenarioError("fleet page: this is no fleet's plan; hand in what plan_fleet returned")
    unit = plan_unit(plan)
    laid, below = laid_out(plan, net)
    plane = unrolled(below)
    stops = [(s.lon, s.lat) for one in plan.trips for s in (one.origin, one.destination)]
    around = surroundings(unrolled(net), stops)
    traffic = _traffic(laid, plane)
    platoons = _platoons(plan, laid, plane)
    most_saved = max((one.convoy.saving or 0.0 for one in platoons), default=0.0)
    every = np.arange(plane.m)
    return FleetDocument(
        plan=plan,
        record=plan.fleet,
        title=title,
        unit=unit,
        list_unit=plan_unit(plan, most_saved),
        around=around,
        network=tuple(
            Lines.rounded(basemap_lines(plane, every, BASEMAP_TOLERANCE_M), NETWORK_STEPS)
        ),
        traffic=traffic,
        most=max((one.high for one in traffic), default=0),
        platoons=platoons,
        sizes=tuple(vehicle_m_by_size(plan).items()),
        histogram=histogram_of([vehicle.saving for vehicle in plan.vehicles]),
        corridor=corridor_of(laid, plane, corridor),
        provenance=around.told_in(provenance(plan, net, unit)),
    )


def width_class(vehicles: int, most: int) -> int:
    """Return the class of a number of vehicles; classes are even in the square root.

    Parameters
    ----------
    vehicles : int
        On a road.
    most : int
        On any road.

    Returns
    -------
    int
        0 to 4.
    """
    share = (vehicles / most) ** 0.5 if most else 0.0
    return min(WIDTHS - 1, max(0, int(np.ceil(share * WIDTHS)) - 1))


def _traffic(plan: Plan, net: RoadNetwork) -> tuple[Traffic, ...]:
    every, together = np.zeros(net.m, np.int64), np.zeros(net.m, np.int64)
    for stretch in plan.stretches:
        if stretch.access is None:
            edges = list(stretch.edges)
            np.add.at(every, edges, len(stretch.vehicles))
            if stretch.together:
                np.add.at(together, edges, len(stretch.vehicles))
    most = int(every.max(initial=0))
    used = np.flatnonzero(every)
    widths = np.array([width_class(int(one), most) for one in every[used]], np.int64)
    shares = np.searchsorted(SHARES, together[used] / every[used])
    found = []
    for width in range(WIDTHS):
        for share in range(len(SHARES)):
            here = used[(widths == width) & (shares == share)]
            if len(here):
                lines = basemap_lines(net, here, ROUTE_TOLERANCE_M, directed=True)
                low, high = int(every[here].min()), int(every[here].max())
                drawn = Lines.rounded(lines, ROUTE_STEPS)
                found.append(Traffic(width, share, low, high, drawn))
    return tuple(found)


def _platoons(plan: Plan, laid: Plan, net: RoadNetwork) -> tuple[Listed, ...]:
    convoys = sorted(convoys_of(plan), key=lambda one: (-(one.saving or 0.0), one.vehicles))
    found = []
    for rank, one in enumerate(convoys):
        first, last = (laid.stretches[k] for k in (one.stretches[0], one.last))
        forms, parts = one.forms, one.parts
        # Who goes on together after a stop has no merge of its own.
        if not forms and first.edges:
            forms = net.place_name(int(net.tail[first.edges[0]]))
        if not parts and last.edges:
            parts = net.place_name(int(net.head[last.edges[-1]]))
        roads = one.stretches if rank < LISTED else ()
        lines = tuple(route_line(net, laid.stretches[k].edges) for k in roads)
        found.append(Listed(one, fitted(forms), fitted(parts), lines))
    return tuple(found)
