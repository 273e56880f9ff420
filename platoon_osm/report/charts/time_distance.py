"""The time-distance diagram of a platoon as numbers: how far each vehicle is at every moment.

All vehicles count the same kilometres: where two drive together both have come equally far. Before
it merges a vehicle is as far back as its own way to the merging point is long, and after it has
left it goes on likewise, so the slope of every line is a true speed: the mean of that stretch.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...plans.clock import MENTIONED_S, Clock
from ..document.model import Document
from ..document.model_law import Standing

__all__ = [
    "BEYOND", "Band", "Course", "Diagram", "Leg", "Place", "Spot", "Stand", "diagram_of",
]  # fmt: skip

BEYOND = 0.25
"""What was asked for is drawn up to this share of the day before its begin and after its end."""

HELD_S = 60.0
"""Who leaves later than it could by less is not drawn as held back."""

SAME_M, SAME_S = 1.0, 1.0


@dataclass(frozen=True, slots=True)
class Leg:
    """A straight piece of a line.

    Attributes
    ----------
    begin_m, end_m : float
        On the scale of distance.
    begin_s, end_s : float
        On the clock of the plan.
    band : int or None
        The stretch in platoon that it is, as its position in the document; None alone.
    """

    begin_m: float
    begin_s: float
    end_m: float
    end_s: float
    band: int | None


@dataclass(frozen=True, slots=True)
class Stand:
    """A while in which a vehicle does not move.

    Attributes
    ----------
    at_m : float
        Where, on the scale of distance.
    begin_s, end_s : float
        From when to when.
    vehicles : tuple of int
        Who stands there for just that long.
    kind : str
        Why, as of a `Standing`.
    """

    at_m: float
    begin_s: float
    end_s: float
    vehicles: tuple[int, ...]
    kind: str = "wait"


@dataclass(frozen=True, slots=True)
class Course:
    """One vehicle's line.

    Attributes
    ----------
    vehicle : int
        Its position in the document.
    legs : tuple of Leg
        In driving order.
    leaves_s : float
        When it leaves its origin; if it merges right there, it may wait there first.
    held_from_s : float or None
        From when on it could have left, if it leaves later.
    earliest_s, latest_s : float or None
        Earliest departure and latest arrival asked for.
    """

    vehicle: int
    legs: tuple[Leg, ...]
    leaves_s: float
    held_from_s: float | None
    earliest_s: float | None
    latest_s: float | None


@dataclass(frozen=True, slots=True)
class Band:
    """A stretch in platoon.

    Attributes
    ----------
    piece : int
        Its position among the document's platoons.
    leg : Leg
        Where and when.
    vehicles : tuple of int
        Who drive it, in the order of the document.
    """

    piece: int
    leg: Leg
    vehicles: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Place:
    """A place on the scale of distance.

    Attributes
    ----------
    at_m : float
        Where.
    name : str
        Its name.
    weight : int
        How many vehicles merge or part there; the more, the sooner it is named.
    """

    at_m: float
    name: str
    weight: int


@dataclass(frozen=True, slots=True)
class Spot:
    """A merge or a separation on the diagram.

    Attributes
    ----------
    event : int
        Its position in the document.
    at_m, at_s : float
        Where and when.
    """

    event: int
    at_m: float
    at_s: float


@dataclass(frozen=True, slots=True)
class Diagram:
    """The time-distance diagram of vehicles that belong together.

    Attributes
    ----------
    courses : tuple of Course
        A line a vehicle, in the order given.
    bands : tuple of Band
        Stretches in platoon.
    waits : tuple of Stand
        Who stands where, waiting for others or for another reason.
    spots : tuple of Spot
        Merges and separations, and the middles of pauses.
    places : tuple of Place
        What is named on the scale of distance, in its order.
    guide : int
        The vehicle along whose road distance is told.
    begin_s, end_s : float
        The span of time that is drawn.
    end_m : float
        The scale of distance runs from 0 to here.
    clock : Clock
        What turns seconds into times of day.
    """

    courses: tuple[Course, ...]
    bands: tuple[Band, ...]
    waits: tuple[Stand, ...]
    spots: tuple[Spot, ...]
    places: tuple[Place, ...]
    guide: int
    begin_s: float
    end_s: float
    end_m: float
    clock: Clock


def diagram_of(document: Document, members: Sequence[int]) -> Diagram | None:
    """Return the diagram of the vehicles of a platoon.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions; those that drive all their way alone are left out.

    Returns
    -------
    Diagram or None
        None if the plan has no times, nobody drives in company, or the vehicles have no common
        scale of distance.
    """
    schedule = document.schedule
    vehicles = document.vehicles
    inside = [i for i in members if any(kind == "platoon" for kind, _ in vehicles[i].way)]
    if schedule is None or not inside or any(document.levels[i] is None for i in inside):
        return None
    begin_s, end_s = _span(document, inside)
    courses = tuple(_course(document, index, begin_s) for index in inside)
    bands: dict[int, Band] = {}
    for course in courses:
        for leg in course.legs:
            if leg.band is not None and leg.band not in bands:
                company = tuple(sorted(document.platoons[leg.band].vehicles))
                bands[leg.band] = Band(leg.band, leg, company)
    guide = _guide(document, inside)
    spots = tuple(_spots(document, courses))
    last_m = max(course.legs[-1].end_m for course in courses)
    return Diagram(
        courses=courses,
        bands=tuple(bands[piece] for piece in sorted(bands)),
        waits=tuple(_waits(document, courses)),
        spots=spots,
        places=tuple(_places(document, courses[inside.index(guide)], spots)),
        guide=guide,
        begin_s=begin_s,
        end_s=max(end_s, begin_s + 60.0),
        end_m=max(last_m, 1.0),
        clock=schedule.clock,
    )


def _span(document: Document, members: Sequence[int]) -> tuple[float, float]:
    """Return the time that is drawn: the day, and windows that begin or end near it."""
    days = [document.vehicles[index].day for index in members]
    first, last = min(day.departure_s for day in days), max(day.arrival_s for day in days)
    far = (last - first) * BEYOND
    asked = (day.earliest_departure_s for day in days)
    begins = (max(at, first - far) for at in asked if at is not None)
    ends = (day.latest_arrival_s for day in days)
    return (
        min(first, *begins, first),
        max([last, *(at for at in ends if at is not None and at <= last + far)]),
    )


def _course(document: Document, index: int, begin_s: float) -> Course:
    vehicle = document.vehicles[index]
    at_m = document.levels[index] or 0.0
    legs: list[Leg] = []
    for (kind, piece), (begin, end) in zip(vehicle.way, vehicle.day.spans, strict=True):
        length = document.piece_m(kind, piece)
        legs.append(Leg(at_m, begin, at_m + length, end, piece if kind == "platoon" else None))
        at_m += length
    day = vehicle.day
    earliest = day.earliest_departure_s
    held = None
    if earliest is not None and day.departure_s - earliest >= HELD_S:
        held = max(earliest, begin_s)
    return Course(index, tuple(legs), day.departure_s, held, earliest, day.latest_arrival_s)


def _waits(document: Document, courses: Sequence[Course]) -> Iterator[Stand]:
    """Yield each while of standing once, with all who stand there for just that long."""
    found: dict[tuple[int, int, int, str], list[tuple[int, float, Standing]]] = {}
    for course in courses:
        for one in document.vehicles[course.vehicle].day.stands:
            if one.lasts_s >= MENTIONED_S:
                at_m = _stands_at(course, one)
                when = (round(one.begin_s / SAME_S), round(one.end_s / SAME_S))
                key = (round(at_m / SAME_M), *when, one.kind)
                found.setdefault(key, []).append((course.vehicle, at_m, one))
    for who in found.values():
        _, at_m, one = who[0]
        vehicles = tuple(vehicle for vehicle, _, _ in who)
        yield Stand(at_m, one.begin_s, one.end_s, vehicles, one.kind)


def _stands_at(course: Course, one: Standing) -> float:
    """Return where the leg begins that follows."""
    after = (leg.begin_m for leg in course.legs if leg.begin_s >= one.end_s - SAME_S)
    return next(after, course.legs[-1].end_m)


def _spots(document: Document, courses: Sequence[Course]) -> Iterator[Spot]:
    known = {course.vehicle: course for course in courses}
    for number, event in enumerate(document.events):
        mover = next((index for index in event.vehicles if index in known), None)
        if mover is None or event.at_s is None:
            continue
        if event.until_s is not None:
            stands = Standing(event.kind, event.at_s, event.until_s)
            middle_s = (event.at_s + event.until_s) / 2
            yield Spot(number, _stands_at(known[mover], stands), middle_s)
            continue
        legs = [leg for leg in known[mover].legs if leg.band is not None]
        if event.kind == "merge":
            leg = min(legs, key=lambda one: abs(one.begin_s - (event.at_s or 0.0)))
            yield Spot(number, leg.begin_m, leg.begin_s)
        else:
            leg = min(legs, key=lambda one: abs(one.end_s - (event.at_s or 0.0)))
            yield Spot(number, leg.end_m, leg.end_s)


def _guide(document: Document, members: Sequence[int]) -> int:
    """Return the master, or else who drives farthest in the platoon."""
    vehicles = document.vehicles
    masters = [index for index in members if vehicles[index].role == "master"]
    return masters[0] if masters else max(members, key=lambda i: (vehicles[i].platoon_m, -i))


def _places(document: Document, guide: Course, spots: Sequence[Spot]) -> Iterator[Place]:
    """Yield the ends of the guide's way and all points, those of one name and spot once."""
    own = document.vehicles[guide.vehicle]
    every = len(document.vehicles)
    found = [
        Place(guide.legs[0].begin_m, own.origin.brief, every),
        Place(guide.legs[-1].end_m, own.destination.brief, every),
    ]
    for spot in spots:
        event = document.events[spot.event]
        if event.stands:
            # Their icons say enough.
            continue
        found.append(Place(spot.at_m, event.name, len(event.vehicles)))
    merged: list[Place] = []
    for place in sorted(found, key=lambda one: (one.at_m, one.name)):
        if merged and merged[-1].name == place.name and place.at_m - merged[-1].at_m < 2_000:
            last = merged.pop()
            place = Place(last.at_m, last.name, last.weight + place.weight)
        merged.append(place)
    yield from merged
