"""The document of a plan with many vehicles: flows on the network, savings as a histogram."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...network.preparing.unrolled import unrolled
from ...network.road_network import RoadNetwork
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ..drawing.basemap import ROUTE_STEPS, ROUTE_TOLERANCE_M, basemap_lines
from ..drawing.lines import Lines
from ..drawing.ticks import round_step
from ..language.speech import speaking
from .as_json import as_json
from .document import document_of
from .model import Document

__all__ = ["Flow", "FlowDocument", "Histogram", "flow_document", "flow_document_of", "histogram_of"]

FLOWS_VERSION = 1

BINS = 12
EMPTY_STEP = 0.01
"""Width of a bin where nobody saves or loses anything."""


@dataclass(frozen=True, slots=True)
class Flow:
    """The roads that one number of vehicles drive on.

    Attributes
    ----------
    vehicles : int
        How many.
    length_m : float
        Of the roads.
    lines : Lines
        As they are driven.
    """

    vehicles: int
    length_m: float
    lines: Lines


@dataclass(frozen=True, slots=True)
class Histogram:
    """How many vehicles save what share of their cost.

    Attributes
    ----------
    step : float
        Width of a bin.
    first : int
        Number of the first bin; it begins at `first * step`.
    counts : tuple of int
        Vehicles in each bin.
    median : float
        What the middle vehicle saves.
    """

    step: float
    first: int
    counts: tuple[int, ...]
    median: float


@dataclass(frozen=True, slots=True)
class FlowDocument:
    """A document, and what the page for many vehicles shows beyond it.

    Attributes
    ----------
    document : Document
        Of the plan.
    flows : tuple of Flow
        From few vehicles to many.
    most : int
        Most vehicles on one road.
    histogram : Histogram
        Of the savings.
    """

    document: Document
    flows: tuple[Flow, ...]
    most: int
    histogram: Histogram


def flow_document(
    plan: Plan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> dict[str, Any]:
    """Return what the page for many vehicles shows as plain JSON types.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    title : str or None
        Heads the page; by default made from the first vehicle's journey.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Returns
    -------
    dict
        A report document with `flows`, `most` and `histogram`, as docs/report.md describes it.

    Raises
    ------
    ScenarioError
        As in `report_document`.
    """
    with speaking(language, clock):
        found = flow_document_of(plan, net, title=title)
    return {
        **as_json(found.document),
        "format": "platoon_osm flows",
        "version": FLOWS_VERSION,
        "flows": as_json(found.flows),
        "most": found.most,
        "histogram": as_json(found.histogram),
    }


def flow_document_of(plan: Plan, net: RoadNetwork, *, title: str | None = None) -> FlowDocument:
    """Return what the page for many vehicles shows as records.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    title : str or None
        Heads the page.

    Returns
    -------
    FlowDocument
        All that the page shows.

    Raises
    ------
    ScenarioError
        As in `report_document`.
    """
    document = document_of(plan, net, title=title)
    flows = tuple(_flows(plan, net))
    return FlowDocument(
        document=document,
        flows=flows,
        most=max((flow.vehicles for flow in flows), default=0),
        histogram=histogram_of([vehicle.saving for vehicle in document.vehicles]),
    )


def _flows(plan: Plan, net: RoadNetwork) -> Iterator[Flow]:
    """Yield the roads used, for each number of vehicles that drive on them."""
    count: Counter[int] = Counter()
    plan, net = laid_out(plan, net)
    net = unrolled(net)
    for vehicle in plan.vehicles:
        count.update({edge for leg in vehicle.legs if leg.access is None for edge in leg.edges})
    edges = np.array(sorted(count), np.int64)
    used = np.array([count[int(edge)] for edge in edges], np.int64)
    for vehicles in sorted(set(used.tolist())):
        here = edges[used == vehicles]
        lines = basemap_lines(net, here, ROUTE_TOLERANCE_M, directed=True)
        yield Flow(vehicles, float(net.length_m[here].sum()), Lines.rounded(lines, ROUTE_STEPS))


def histogram_of(savings: Sequence[float]) -> Histogram:
    """Return how many vehicles save what share: bins of a round width, and the middle vehicle.

    Parameters
    ----------
    savings : sequence of float
        By what share each vehicle pays less than alone.

    Returns
    -------
    Histogram
        Of all of them.
    """
    low, high = min(0.0, *savings, 0.0), max(0.0, *savings, 0.0)
    step = round_step((high - low) / BINS) if high > low else EMPTY_STEP
    # Shares that are zero but for rounding belong to no gain and no loss.
    first = math.floor(low / step + 1e-9)
    counts: Counter[int] = Counter(math.floor(saving / step + 1e-9) for saving in savings)
    last = max(counts)
    return Histogram(
        step=step,
        first=first,
        counts=tuple(counts.get(k, 0) for k in range(first, last + 1)),
        median=float(np.median(savings)),
    )
