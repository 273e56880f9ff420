"""Lines of the routes on the map, and what they tell when they are pointed at."""

from __future__ import annotations

from collections.abc import Iterator

from ...shown_text import fitted
from ..drawing.basemap import route_line
from ..drawing.lines import Line
from ..language.speech import say
from ..markup.quantities import kilometres
from .findings import Findings
from .model_map import BandPart, LanePart, PlatoonLine, SharedCost, SoloLine, Tip
from .roads import roads_of
from .wording import cost_texts, joined

__all__ = ["inferred_routes", "platoon_line", "solo_line"]

COLUMNS = ("table.vehicle", "table.alone", "tip.in-platoon", "table.saving")

MOST_ROWS = 12
"""Vehicles in the table that a platoon shows when pointed at."""


def platoon_line(found: Findings, number: int) -> PlatoonLine:
    """Return one stretch that a platoon drives.

    Parameters
    ----------
    found : Findings
        Of the plan.
    number : int
        Its position among the platoons' stretches.

    Returns
    -------
    PlatoonLine
        With what it costs each vehicle.
    """
    stretch = found.platoons[number]
    rows: list[tuple[str, ...]] = []
    shares: list[SharedCost] = []
    for index in stretch.company:
        letter, share = found.styles[index].letter, stretch.share_of(index)
        shares.append(SharedCost(index, share.alone_cost, share.cost, round(share.fuel_l, 4)))
        if share.alone_cost is None:
            rows.append((letter, "", found.unit.bare(share.cost), ""))
        else:
            text = cost_texts(share.alone_cost, share.cost, found.unit)
            rows.append((letter, text.alone, text.joint, text.share))
    return PlatoonLine(
        vehicles=stretch.company,
        length_m=stretch.length_m,
        costs=tuple(shares),
        parts=tuple(
            BandPart(route_line(found.net, part.edges), part.beside, part.place, part.opposite_m)
            for part in found.platoon_parts[number]
        ),
        tip=Tip(
            head=say("tip.platoon", who=joined(found.letters(stretch.company))),
            lines=(say("tip.costs-in", km=kilometres(stretch.length_m), unit=found.unit.label),),
            columns=tuple(map(say, COLUMNS)) if rows else (),
            rows=tuple(rows[:MOST_ROWS]),
            more=say("tip.more", n=len(rows) - MOST_ROWS) if len(rows) > MOST_ROWS else "",
        ),
        drive_s=round(stretch.drive_s, 2),
        inferred_m=round(stretch.inferred_m, 1),
        roads=fitted(roads_of(found.net, stretch.edges)),
    )


def solo_line(found: Findings, number: int) -> SoloLine:
    """Return one stretch that a vehicle drives alone.

    Parameters
    ----------
    found : Findings
        Of the plan.
    number : int
        Its position among the stretches driven alone.

    Returns
    -------
    SoloLine
        With what it costs.
    """
    stretch = found.solos[number]
    (index,) = stretch.vehicles
    name = fitted(found.plan.trips[index].vehicle)
    letter = found.styles[index].letter
    cost = stretch.shares[0].cost
    inferred: tuple[str, ...] = ()
    if stretch.inferred_m > 0:
        inferred = (say("tip.inferred", km=kilometres(stretch.inferred_m)),)
    met = fitted(stretch.access_at)
    way = (say("tip.access", place=met),) if stretch.access else ()
    return SoloLine(
        vehicle=index,
        length_m=stretch.length_m,
        cost=cost,
        parts=tuple(
            LanePart(
                route_line(found.net, part.edges),
                part.slot,
                part.slots,
                part.bands,
                part.opposite_m,
            )
            for part in found.solo_parts[number]
        ),
        tip=Tip(
            head=say("tip.alone", who=letter)
            if name == letter
            else say("tip.alone-named", who=letter, name=name),
            lines=(
                say("tip.cost", km=kilometres(stretch.length_m), cost=found.unit.full(cost)),
                *inferred,
                *way,
            ),
        ),
        access=stretch.access is not None,
        drive_s=round(stretch.drive_s, 2),
        inferred_m=round(stretch.inferred_m, 1),
        fuel_l=round(stretch.shares[0].fuel_l, 4),
        roads="" if stretch.access else fitted(roads_of(found.net, stretch.edges)),
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
