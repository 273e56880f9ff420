"""Which of several plans are of the same trips, and how these differ from one of them.

Two plans are of the same trips if the same vehicles drive from the same places to the same places.
When they may drive is not part of it, as a plan of other windows is what one compares; that the
windows differ is said. Costs of other trips say nothing of each other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...plans.plan import Plan
from ...plans.records import Stop
from ..language.speech import say
from .model import Document
from .side_sums import SideSums, side_sums
from .wording import joined

__all__ = ["AlikePlans", "Difference", "alike", "alike_plans"]

SAME_DEGREES = 5
"""Decimals to which places agree: about a metre."""


@dataclass(frozen=True, slots=True)
class Difference:
    """How a plan differs from that which it is set against: its own less that one's.

    Attributes
    ----------
    cost : float or None
        Of all vehicles as planned, in the plans' unit; None if the plans count costs differently.
    saving : float
        Share of the cost alone.
    length_m : float
        Driven by all vehicles.
    fuel_l : float
        Of all vehicles.
    waiting_s, under_way_s : float or None
        On the road, and from door to door; None if one of the two has no times.
    breaks_s, rests_s : float or None
        Of breaks, and of rests; None if one of the two has no driving rules.
    """

    cost: float | None
    saving: float
    length_m: float
    fuel_l: float
    waiting_s: float | None
    under_way_s: float | None
    breaks_s: float | None
    rests_s: float | None


@dataclass(frozen=True, slots=True)
class AlikePlans:
    """Plans of the same trips.

    Attributes
    ----------
    plans : tuple of int
        Positions in the comparison.
    baseline : int
        Position in the comparison of that which the others are set against.
    differences : tuple of Difference or None
        Of each plan; None for that one itself.
    sums : tuple of SideSums or None
        The day of each plan; None without times.
    gaps : tuple of float or None
        By what share each may cost more than the best, under the conditions of its proof; 0 where
        that is proved to be none, None where nothing is proved.
    remarks : tuple of str
        What a reader should know before comparing.
    """

    plans: tuple[int, ...]
    baseline: int
    differences: tuple[Difference | None, ...]
    sums: tuple[SideSums | None, ...]
    gaps: tuple[float | None, ...]
    remarks: tuple[str, ...]


def alike(plans: Sequence[Plan]) -> list[tuple[int, ...]]:
    """Return which plans are of the same trips.

    Parameters
    ----------
    plans : sequence of Plan
        On one network.

    Returns
    -------
    list of tuple of int
        Positions of plans that are alike, by the first of them.
    """
    found: list[list[int]] = []
    for place, plan in enumerate(plans):
        known = next((one for one in found if _same_trips(plans[one[0]], plan)), None)
        if known is None:
            found.append([place])
        else:
            known.append(place)
    return [tuple(places) for places in found]


def _same_trips(one: Plan, other: Plan) -> bool:
    """Tell whether plans are of the same vehicles, between the same places."""
    theirs = {trip.vehicle: trip for trip in other.trips}
    return len(one.trips) == len(other.trips) and all(
        (twin := theirs.get(trip.vehicle)) is not None
        and _same_place(trip.origin, twin.origin)
        and _same_place(trip.destination, twin.destination)
        for trip in one.trips
    )


def _same_place(one: Stop, other: Stop) -> bool:
    # A town has several junctions, and which of them is taken depends on the roads that are open.
    return one.name == other.name or _place(one) == _place(other)


def _place(stop: Stop) -> tuple[float, float]:
    return round(stop.lon, SAME_DEGREES), round(stop.lat, SAME_DEGREES)


def alike_plans(
    places: tuple[int, ...], baseline: int, plans: Sequence[Plan], documents: Sequence[Document]
) -> AlikePlans:
    """Return plans of the same trips, set against one of them.

    Parameters
    ----------
    places : tuple of int
        Their positions.
    baseline : int
        The position of that one; the first of them unless it is among them.
    plans : sequence of Plan
        All that are compared.
    documents : sequence of Document
        Of each.

    Returns
    -------
    AlikePlans
        With differences and remarks.
    """
    base = baseline if baseline in places else places[0]
    counted_alike = {place: _costs_of(plans[place]) == _costs_of(plans[base]) for place in places}
    sums = {place: side_sums(plans[place], documents[place].law) for place in places}
    return AlikePlans(
        plans=places,
        baseline=base,
        differences=tuple(
            None
            if place == base
            else _difference(
                documents[place], documents[base], counted_alike[place], sums[place], sums[base]
            )
            for place in places
        ),
        sums=tuple(sums.values()),
        gaps=tuple(_gap(plans[place]) for place in places),
        remarks=tuple(_remarks(places, base, plans, documents)),
    )


def _gap(plan: Plan) -> float | None:
    """Return by what share a plan may be dearer than the best; None where nothing is proved."""
    gap: float | None = plan.proof.get("gap", 0.0 if plan.proof.get("kind") == "exact" else None)
    return gap


def _costs_of(plan: Plan) -> object:
    return plan.unit, tuple(sorted((key, repr(value)) for key, value in plan.params.items()))


def _difference(
    own: Document,
    base: Document,
    counted_alike: bool,
    day: SideSums | None,
    base_day: SideSums | None,
) -> Difference:
    under_way = breaks = rests = waiting = None
    if own.schedule is not None and base.schedule is not None:
        waiting = own.schedule.waiting_s - base.schedule.waiting_s
    if day is not None and base_day is not None:
        under_way = day.under_way_s - base_day.under_way_s
        if day.law and base_day.law:
            breaks, rests = day.breaks_s - base_day.breaks_s, day.rests_s - base_day.rests_s
    return Difference(
        cost=own.totals.joint_cost - base.totals.joint_cost if counted_alike else None,
        saving=own.totals.saving - base.totals.saving,
        length_m=sum(one.length_m for one in own.vehicles)
        - sum(one.length_m for one in base.vehicles),
        fuel_l=sum(one.fuel_l for one in own.vehicles) - sum(one.fuel_l for one in base.vehicles),
        waiting_s=waiting,
        under_way_s=under_way,
        breaks_s=breaks,
        rests_s=rests,
    )


def _remarks(
    places: tuple[int, ...], base: int, plans: Sequence[Plan], documents: Sequence[Document]
) -> Iterator[str]:
    units = {documents[place].cost_unit.label for place in places}
    if len(units) > 1:
        yield say("compare.other-units", units=", ".join(sorted(units)))
    if len({_costs_of(plans[place]) for place in places}) > 1:
        yield say("compare.other-costs")
    for place in places:
        if who := _other_windows(plans[place], plans[base], documents[base]):
            yield say(
                "compare.other-windows",
                title=documents[place].title,
                base=documents[base].title,
                who=joined(who),
            )


def _other_windows(own: Plan, base: Plan, shown: Document) -> list[str]:
    """Return what the vehicles are called whose times asked for are other than in a plan."""
    called = {
        trip.vehicle: one.called for trip, one in zip(base.trips, shown.vehicles, strict=True)
    }
    mine, theirs = _windows(own), _windows(base)
    return [called[name] for name in called if mine[name] != theirs[name]]


def _windows(plan: Plan) -> dict[str, tuple[str, ...]]:
    """Return the times that each vehicle asked for, as moments of the calendar."""
    table = plan.timetable
    if table is None:
        return {trip.vehicle: ("", "", "") for trip in plan.trips}
    return {
        trip.vehicle: tuple(
            "" if at is None else table.clock.iso(at)
            for at in (
                times.earliest_departure_s, times.latest_departure_s, times.latest_arrival_s
            )
        )
        for trip, times in zip(plan.trips, table.vehicles, strict=True)
    }  # fmt: skip
