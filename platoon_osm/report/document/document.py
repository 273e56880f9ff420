"""One plan on one network as one document: all that the page shows, and nothing else.

It is made in one pass: what is worked out of the plan is worked out once and handed down, and each
builder puts its part into words once. Texts have passed `shown`, figures come both as numbers in SI
units and, where the page prints them, as text. The schema is described in docs/report.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...costs.weights import EdgeWeights
from ...network.preparing.unrolled import unrolled
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...shown_text import fitted
from ..drawing.basemap import network_lines
from ..drawing.vehicle_styles import VehicleStyle
from ..language.speech import speaking, spoken
from .as_json import as_json
from .bill_parts import bill_of, chances_of, gain_of
from .checks import check_title
from .event_marks import event_mark, told_events
from .findings import Findings, find
from .journey import rounded
from .law_clocks import law_of
from .lead_marks import lead_turns, position_marks
from .long_drives import long_drives
from .map_lines import inferred_routes, platoon_line, solo_line
from .model import CostLabel, Document
from .model_map import Basemap, EventMark
from .pause_marks import pause_marks
from .place_labels import junction_labels
from .plan_frame import plan_frame
from .provenance import provenance
from .status import status
from .stop_labels import stop_labels
from .surroundings import surroundings
from .timeline import timeline
from .totals import groups, subtitle_of, title_of, totals
from .traffic import traffic
from .vehicles import vehicle

__all__ = ["DOCUMENT_VERSION", "document_of", "report_document"]

DOCUMENT_VERSION = 4


def report_document(
    plan: Plan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    weights: EdgeWeights | None = None,
    styles: Mapping[str, VehicleStyle] | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> dict[str, Any]:
    """Return the document of a plan, plain JSON types throughout.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    title : str or None
        Heads the page; by default made from the first vehicle's journey.
    weights : EdgeWeights or None
        Those the plan was made with. The paper's preset needs none; for others they tell what a
        section costs alone and what a detour costs, which is left out without them.
    styles : mapping of str to VehicleStyle, or None
        Letter, colour and dash of each vehicle by its name; by default their own. Several
        documents that share a page share these.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Returns
    -------
    dict
        The document, as docs/report.md describes it.

    Raises
    ------
    ScenarioError
        A plan of another network, without vehicles, with two vehicles of one name, or weights
        that do not fit it.
    """
    document = document_of(
        plan, net, title=title, weights=weights, styles=styles, language=language, clock=clock
    )
    return as_json(document)  # type: ignore[no-any-return]  # a record becomes a dict


def document_of(
    plan: Plan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    weights: EdgeWeights | None = None,
    styles: Mapping[str, VehicleStyle] | None = None,
    language: str | None = None,
    clock: int | None = None,
    largest: float | None = None,
) -> Document:
    """Return the document of a plan as records; as `report_document` otherwise.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    title : str or None
        Heads the page; by default made from the first vehicle's journey.
    weights : EdgeWeights or None
        Those the plan was made with.
    styles : mapping of str to VehicleStyle, or None
        How each vehicle looks, by its name.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.
    largest : float or None
        The largest cost printed on the page; by default that of all vehicles alone.

    Returns
    -------
    Document
        All that pages show.

    Raises
    ------
    ScenarioError
        As in `report_document`.
    """
    check_title(title)
    with speaking(language, clock):
        return _document(find(plan, net, weights, styles, largest), plan, net, title)


def _document(found: Findings, plan: Plan, net: RoadNetwork, title: str | None) -> Document:
    plane = unrolled(net)
    vehicles = tuple(vehicle(found, index) for index in range(len(plan.vehicles)))
    stops = [(s.lon, s.lat) for one in vehicles for s in (one.origin, one.destination)]
    around = surroundings(plane, stops)
    near = plan_frame(found)
    law = law_of(plan)
    events = _events(found)
    return Document(
        format="platoon_osm report",
        version=DOCUMENT_VERSION,
        language=spoken().code,
        clock=spoken().clock,
        title=title_of(found, title),
        subtitle=subtitle_of(found),
        status=tuple(
            status(
                [one.called for one in vehicles],
                [one.times for one in vehicles],
                bool(found.groups),
                law,
                plan.remarks,
                plan.timetable.rules if plan.timetable else "",
            )
        ),
        cost_unit=CostLabel(
            found.unit.label,
            found.unit.note,
            fitted(plan.unit),
            found.unit.scale,
            found.unit.decimals,
        ),
        totals=totals(found),
        vehicles=vehicles,
        groups=tuple(groups(found)),
        platoons=tuple(platoon_line(found, number) for number in range(len(found.platoons))),
        solos=tuple(solo_line(found, number) for number in range(len(found.solos))),
        traffic=traffic(found),
        events=tuple(mark for _, mark in events),
        journey=rounded(found.scale),
        schedule=timeline(plan),
        law=law,
        inferred_routes=tuple(inferred_routes(found)),
        towns=around.towns,
        junctions=junction_labels(plane, near),
        stops=stop_labels(plan, net),
        basemap=Basemap(
            network_lines(plane, near, inferred=False),
            network_lines(plane, near, inferred=True),
        ),
        ground=around.ground,
        provenance=around.told_in(provenance(plan, net, found.unit)),
        levels=found.levels,
        long_drives=() if law else long_drives(found),
        leads=lead_turns(found),
        positions=position_marks(found.plan),
        bill=bill_of(plan),
        gain=gain_of(plan),
        chances=chances_of(plan, [number for number, _ in events]),
    )


def _events(found: Findings) -> list[tuple[int, EventMark]]:
    """Return merges and separations in driving order; if vehicles stand, all in order of time.

    Each with its position in the plan, -1 for a pause.
    """
    marks = [(number, event_mark(found, number)) for number in told_events(found)]
    pauses = [(-1, pause) for pause in pause_marks(found)]
    if not pauses:
        return marks
    return sorted((*marks, *pauses), key=lambda one: one[1].at_s or 0.0)
