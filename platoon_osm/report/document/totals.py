"""Title, subtitle, sums and groups of a document."""

from __future__ import annotations

from collections.abc import Iterator

from ...shown_text import fitted, shortened, shown
from ..markup.quantities import clock_span, kilometres, litres, percent, true_minus
from .event_marks import told_events
from .findings import Findings
from .model import Figure, Group, Totals
from .wording import cost_texts, counted, joined

__all__ = ["groups", "subtitle_of", "title_of", "totals"]


def title_of(found: Findings, title: str | None) -> str:
    """Return what heads the page.

    Parameters
    ----------
    found : Findings
        Of the plan.
    title : str or None
        As asked for.

    Returns
    -------
    str
        The same made fit, or else the first vehicle's journey.
    """
    if title and shown(title):
        return fitted(title)
    vehicles = found.plan.vehicles
    first = next((v for v in vehicles if v.role == "master"), vehicles[0])
    ends = (shortened(shown(stop.name), 40) for stop in (first.origin, first.destination))
    return "Platoon plan, " + " \u2013 ".join(ends)


def subtitle_of(found: Findings) -> str:
    """Return how many vehicles, platoons and points a plan has.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    str
        In one line.
    """
    kinds = [found.plan.events[number].kind for number in told_events(found)]
    merges, separations = kinds.count("merge"), kinds.count("separation")
    parts = [counted(len(found.plan.vehicles), "vehicle", "vehicles")]
    if len(found.groups) > 1:
        parts.append(f"{len(found.groups)} platoons")
    if merges:
        parts.append(counted(merges, "merge point", "merge points"))
    if separations:
        parts.append(counted(separations, "separation point", "separation points"))
    if not found.groups:
        parts.append("no platoon")
    return ", ".join(parts)


def totals(found: Findings) -> Totals:
    """Return the sums over all vehicles.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    Totals
        With the three figures at the head of the page.
    """
    plan, unit = found.plan, found.unit
    road_m = plan.platoon_road_m
    alone_l = sum(vehicle.alone.fuel_l for vehicle in plan.vehicles)
    saved_l = alone_l - sum(vehicle.fuel_l for vehicle in plan.vehicles)
    extra_m = sum(vehicle.length_m - vehicle.alone.length_m for vehicle in plan.vehicles)
    saved = plan.solo_cost - plan.joint_cost
    figures = (
        Figure(
            true_minus(percent(plan.saving)),
            f"saved, {unit.full(saved)}",
            "good" if saved > 0 else "plain",
        ),
        Figure(
            kilometres(road_m),
            f"of road in platoon, {plan.platoon_m / 1000:,.0f} vehicle-km",
            "plain",
        ),
        _third_figure(found, alone_l, saved_l, extra_m),
    )
    return Totals(
        solo_cost=plan.solo_cost,
        joint_cost=plan.joint_cost,
        saving=plan.saving,
        platoon_road_m=road_m,
        platoon_m=plan.platoon_m,
        fuel_saved_l=saved_l,
        extra_m=extra_m,
        figures=figures,
        text=cost_texts(plan.solo_cost, plan.joint_cost, unit),
    )


def _third_figure(found: Findings, alone_l: float, saved_l: float, extra_m: float) -> Figure:
    """Return what it takes: waiting where there are times, else fuel, else distance."""
    if (table := found.plan.timetable) is not None:
        fuel = f"{litres(saved_l)} of fuel saved" if saved_l > 0 else "no fuel saved"
        return Figure(clock_span(table.waiting_s), f"waiting on the road; {fuel}", "plain")
    if saved_l <= 0:
        return Figure(kilometres(extra_m), "further than alone", "plain")
    # Shorter is possible: alone, a vehicle may take a longer road that costs less.
    longer = f"{kilometres(abs(extra_m))} {'further' if extra_m >= 0 else 'less'} to drive"
    if abs(extra_m) < 50:
        longer = "no extra distance"
    share = f"{percent(saved_l / alone_l)} of fuel saved"
    return Figure(litres(saved_l), f"{share}; {longer}", "plain")


def groups(found: Findings) -> Iterator[Group]:
    """Yield platoons as groups of vehicles, then those who drive alone as one group.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Yields
    ------
    Group
        With its sums.
    """
    vehicles = found.plan.vehicles
    grouped = {index for group in found.groups for index in group}
    alone = tuple(index for index in range(len(vehicles)) if index not in grouped)
    kinds = [("platoon", group) for group in found.groups] + [("alone", alone)] * bool(alone)
    for number, (kind, members) in enumerate(kinds, 1):
        # The vehicles of a platoon share one road: its length counts once.
        road_m = sum(one.length_m for one in found.platoons if one.vehicles[0] in members)
        before = sum(vehicles[index].solo_cost for index in members)
        after = sum(vehicles[index].joint_cost for index in members)
        facts = counted(len(members), "vehicle", "vehicles")
        if len(members) > 1:
            facts += f" ({joined(found.letters(members))})"
        if kind == "platoon":
            facts += f", {kilometres(road_m)} of road in platoon"
        yield Group(
            kind=kind,
            name=f"Platoon {number}" if kind == "platoon" else "Driving alone",
            facts=facts,
            vehicles=members,
            road_m=road_m,
            saved=before - after,
            text=cost_texts(before, after, found.unit),
        )
