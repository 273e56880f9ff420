"""Title, subtitle, sums and groups of a document."""

from __future__ import annotations

from collections.abc import Iterator

from ...plans.bill import Bill
from ...plans.paid import paid, saved_part
from ...shown_text import fitted, shortened, shown
from ..drawing.crowd import CROWD
from ..language.speech import number, say
from ..markup.quantities import carbon, clock_span, kilometres, litres, percent, true_minus
from .event_marks import told_events
from .findings import Findings
from .model import Figure, Group, Totals
from .stands import all_waited_s
from .stop_names import brief_name
from .wording import cost_texts, joined

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
        The same made fit, or else the first vehicle's journey, and of
        a crowd how many more there are.
    """
    if title and shown(title):
        return fitted(title)
    vehicles = found.plan.vehicles
    first = next((v for v in vehicles if v.role == "master"), vehicles[0])
    ends = (
        shortened(shown(brief_name(stop.name, stop.lon, stop.lat)), 40)
        for stop in (first.origin, first.destination)
    )
    way = " \u2013 ".join(ends)
    if len(vehicles) > CROWD:
        way = say("list.more", who=way, n=len(vehicles) - 1)
    return say("totals.title" if found.groups else "totals.title-alone", way=way)


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
    kinds = [found.plan.events[place].kind for place in told_events(found)]
    merges, separations = kinds.count("merge"), kinds.count("separation")
    parts = [say("totals.vehicles", n=len(found.plan.vehicles))]
    if len(found.groups) > 1:
        parts.append(say("totals.platoons", n=len(found.groups)))
    if merges:
        parts.append(say("totals.merges", n=merges))
    if separations:
        parts.append(say("totals.separations", n=separations))
    if found.plan.bill is not None and found.groups:
        # Money heads the page then, in the place of these.
        parts.append(say("totals.road-in-platoon", length=kilometres(found.plan.platoon_road_m)))
        if (table := found.plan.timetable) is not None:
            parts.append(say("totals.waiting-time", time=clock_span(all_waited_s(table))))
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
    plan = found.plan
    road_m = plan.platoon_road_m
    alone_l = sum(vehicle.alone.fuel_l for vehicle in plan.vehicles)
    saved_l = alone_l - sum(vehicle.fuel_l for vehicle in plan.vehicles)
    extra_m = sum(vehicle.length_m - vehicle.alone.length_m for vehicle in plan.vehicles)
    alone, joint = paid(plan)
    figures: tuple[Figure, ...]
    if found.groups and plan.bill is not None:
        figures = _money_figures(found, plan.bill)
    elif found.groups:
        figures = (
            _saving(found),
            Figure(
                kilometres(road_m),
                say("totals.in-platoon", km=number(plan.platoon_m / 1000)),
                "plain",
            ),
            _third_figure(found, alone_l, saved_l, extra_m),
        )
    else:
        figures = _figures_alone(found)
    return Totals(
        solo_cost=alone,
        joint_cost=joint,
        saving=saved_part(plan),
        platoon_road_m=road_m,
        platoon_m=plan.platoon_m,
        fuel_saved_l=saved_l,
        extra_m=extra_m,
        figures=figures,
        text=cost_texts(alone, joint, found.unit),
    )


def _money_figures(found: Findings, bill: Bill) -> tuple[Figure, ...]:
    """Return what is saved in money, fuel and CO2e."""
    alone, joint = paid(found.plan)
    alone_l = sum(one.alone_fuel_l for one in bill.vehicles) or 1.0
    in_time = found.plan.timetable is None or found.plan.timetable.feasible
    chances = found.plan.chances
    share = true_minus(percent(saved_part(found.plan)))
    label = say("totals.saved-share", share=share)
    if chances is not None:
        expected = found.unit.full(chances.expected_saving)
        label = say("totals.saved-expected", share=share, expected=expected)
    to_wheel, from_well = bill.saved_kg
    fuel_share = true_minus(percent(bill.saved_fuel_l / alone_l))
    return (
        Figure(
            found.unit.full(alone - joint),
            label,
            "good" if alone > joint and in_time else "plain",
        ),
        Figure(
            true_minus(litres(bill.saved_fuel_l)),
            say("totals.fuel-saved-share", share=fuel_share),
            "plain",
        ),
        Figure(
            true_minus(carbon(from_well)),
            say("totals.carbon", mass=true_minus(carbon(to_wheel))),
            "plain",
        ),
    )


def _saving(found: Findings) -> Figure:
    """Return what is saved: no success if somebody is late for it."""
    plan, table = found.plan, found.plan.timetable
    alone, joint = paid(plan)
    saved = alone - joint
    in_time = table is None or table.feasible
    return Figure(
        true_minus(percent(saved_part(plan))),
        say("totals.saved", cost=found.unit.full(saved)),
        "good" if saved > 0 and in_time else "plain",
    )


def _figures_alone(found: Findings) -> tuple[Figure, ...]:
    """Return what the journeys take where nobody drives in company."""
    plan = found.plan
    length_m = sum(vehicle.length_m for vehicle in plan.vehicles)
    time_s = sum(vehicle.time_s for vehicle in plan.vehicles)
    fuel_l = sum(vehicle.fuel_l for vehicle in plan.vehicles)
    cost = say("totals.cost", cost=found.unit.full(paid(plan)[1]))
    return (
        Figure(kilometres(length_m), say("totals.to-drive"), "plain"),
        Figure(clock_span(time_s), say("totals.driving"), "plain"),
        Figure(litres(fuel_l), say("totals.fuel", cost=cost), "plain"),
    )


def _third_figure(found: Findings, alone_l: float, saved_l: float, extra_m: float) -> Figure:
    """Return what it takes: waiting where there are times, else fuel, else distance."""
    if (table := found.plan.timetable) is not None:
        fuel = (
            say("totals.fuel-saved", fuel=litres(saved_l))
            if saved_l > 0
            else say("totals.no-fuel-saved")
        )
        return Figure(clock_span(all_waited_s(table)), say("totals.waiting", fuel=fuel), "plain")
    if saved_l <= 0:
        return Figure(true_minus(kilometres(extra_m)), say("totals.further-than-alone"), "plain")
    # Shorter is possible: alone, a vehicle may take a longer road that costs less.
    way = say(
        "totals.further" if extra_m >= 0 else "totals.shorter", length=kilometres(abs(extra_m))
    )
    if abs(extra_m) < 50:
        way = say("totals.no-extra")
    share = percent(saved_l / alone_l)
    return Figure(litres(saved_l), say("totals.fuel-share", share=share, way=way), "plain")


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
    for rank, (kind, members) in enumerate(kinds, 1):
        # The vehicles of a platoon share one road: its length counts once.
        road_m = sum(one.length_m for one in found.platoons if one.vehicles[0] in members)
        before, after = paid(found.plan, members)
        facts = say("totals.vehicles", n=len(members))
        if len(members) > 1:
            facts += f" ({joined(found.letters(members))})"
        if kind == "platoon":
            facts += f", {say('totals.road-in-platoon', length=kilometres(road_m))}"
        yield Group(
            kind=kind,
            name=say("totals.platoon", number=rank) if kind == "platoon" else say("totals.alone"),
            facts=facts,
            vehicles=members,
            road_m=road_m,
            saved=before - after,
            text=cost_texts(before, after, found.unit),
        )
