"""Lines of the routes on the map, and what they tell when they are pointed at."""

from __future__ import annotations

from collections.abc import Iterator

from ...costs.weights import EdgeWeights
from ...plans.records import VehiclePlan
from ...plans.stretches import PlatoonSection, SoloStretch
from ..drawing.basemap import route_line
from ..drawing.lines import Line
from ..markup.quantities import kilometres
from ..markup.shown_text import fitted
from .findings import Findings
from .model_map import BandPart, LanePart, PlatoonLine, SharedCost, SoloLine, Tip
from .solo_costs import sum_over
from .wording import cost_texts, joined

__all__ = ["inferred_routes", "platoon_line", "solo_line"]

MOST_ROWS = 12
"""Vehicles in the table that a platoon shows when pointed at."""


def platoon_line(found: Findings, number: int) -> PlatoonLine:
    """Return one stretch of one company.

    Parameters
    ----------
    found : Findings
        Of the plan.
    number : int
        Its position among the sections.

    Returns
    -------
    PlatoonLine
        With what it costs each vehicle.
    """
    section = found.sections[number]
    length_m = sum_over(found.net.length_m, section.edges)
    rows: list[tuple[str, ...]] = []
    shares: list[SharedCost] = []
    for index in section.vehicles:
        letter = found.styles[index].letter
        alone, joint = _section_costs(found.plan.vehicles[index], section, found.known)
        shares.append(SharedCost(index, alone, joint))
        if joint is not None and alone is not None:
            text = cost_texts(alone, joint, found.unit)
            rows.append((letter, text.alone, text.joint, text.share))
        elif joint is not None:
            rows.append((letter, "", found.unit.bare(joint), ""))
    return PlatoonLine(
        vehicles=section.vehicles,
        length_m=length_m,
        costs=tuple(shares),
        parts=tuple(
            BandPart(route_line(found.net, part.edges), part.beside, part.place, part.opposite_m)
            for part in found.parts[number]
        ),
        tip=Tip(
            head=f"Platoon of {joined(found.letters(section.vehicles))}",
            lines=(f"{kilometres(length_m)}; costs in {found.unit.label}",),
            columns=("Vehicle", "Alone", "In platoon", "Saving") if rows else (),
            rows=tuple(rows[:MOST_ROWS]),
            more=f"and {len(rows) - MOST_ROWS} more" if len(rows) > MOST_ROWS else "",
        ),
    )


def _section_costs(
    vehicle: VehiclePlan, section: PlatoonSection, known: EdgeWeights | None
) -> tuple[float | None, float | None]:
    """Return the cost of a section alone and in platoon; None where the plan does not tell."""
    whole = next((leg.cost for leg in vehicle.legs if leg.edges == section.edges), None)
    if known is None:
        return None, whole
    own = known.master if vehicle.role == "master" else known.platoon
    joint = sum_over(own, section.edges) if whole is None else whole
    return sum_over(known.solo, section.edges), joint


def solo_line(found: Findings, stretch: SoloStretch) -> SoloLine:
    """Return one stretch that a vehicle drives alone.

    Parameters
    ----------
    found : Findings
        Of the plan.
    stretch : SoloStretch
        One of its stretches.

    Returns
    -------
    SoloLine
        With what it costs.
    """
    leg = stretch.leg
    name = fitted(found.plan.vehicles[stretch.vehicle].vehicle)
    letter = found.styles[stretch.vehicle].letter
    inferred = (f"{kilometres(leg.inferred_m)} inferred",) if leg.inferred_m > 0 else ()
    return SoloLine(
        vehicle=stretch.vehicle,
        length_m=leg.length_m,
        cost=leg.cost,
        parts=tuple(
            LanePart(
                route_line(found.net, part.edges),
                part.slot,
                part.slots,
                part.bands,
                part.opposite_m,
            )
            for part in stretch.parts
        ),
        tip=Tip(
            head=f"{letter} alone" if name == letter else f"{letter} alone ({name})",
            lines=(
                f"{kilometres(leg.length_m)}, cost {found.unit.full(leg.cost)}",
                *inferred,
            ),
        ),
    )


def inferred_routes(found: Findings) -> Iterator[Line]:
    """Yield the stretches of all routes that the loader inferred, each once.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Yields
    ------
    Line
        In the order in which they are driven.
    """
    seen: set[bytes] = set()
    for vehicle in found.plan.vehicles:
        run: list[int] = []
        for edge in (*vehicle.edges, -1):
            if edge >= 0 and found.net.inferred[edge]:
                run.append(edge)
            elif run:
                line = route_line(found.net, tuple(run))
                if (key := line.points.tobytes()) not in seen:
                    seen.add(key)
                    yield line
                run = []
