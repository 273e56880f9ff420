"""A vehicle's journey as its driver goes through it: place by place, and who is met or left there.

Everything is read off the plan. A step is a place where something changes for the driver: who
drives along, in which order, whether it is road, or who of two is at the wheel; or a place where
the vehicle stands. What happens to others elsewhere is not told.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

from ...network.road_network import RoadNetwork
from ...plans.clock import MENTIONED_S
from ...plans.plan import Plan
from ...plans.records import PlatoonPoint, Stop, Stretch
from ...plans.timetable import VehicleTimes
from ..document.halts import Halt, halts_of
from ..document.roads import roads_of
from .going_on import GoingOn, going_on

__all__ = ["Step", "Way", "driver_at", "steps_of"]

Company = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Way:
    """What a vehicle drives from one step to the next.

    Attributes
    ----------
    roads : str
        Road numbers in driving order; empty for a way beside the road.
    length_m, drive_s : float
        Of it.
    order : tuple of int
        Who drives it, in their order, this vehicle among them.
    is_access : bool
        Whether it is a way between the road and a place beside it.
    """

    roads: str
    length_m: float
    drive_s: float
    order: Company
    is_access: bool

    @property
    def together(self) -> bool:
        """Whether it is driven as a platoon."""
        return len(self.order) > 1


@dataclass(frozen=True, slots=True)
class Step:
    """A place where something changes for a driver.

    Attributes
    ----------
    place : Stop or PlatoonPoint
        Where; its name is other people's text.
    at_m : float
        How far the vehicle has come [m].
    reached_s, leaves_s : float or None
        When it comes there and when it goes on; None without times.
    joined, left : tuple of int
        Who drives along from here on; and who no longer does.
    moves : bool
        Whether it is this vehicle that joins or leaves.
    way : Way or None
        What follows; None at the destination.
    waited_for : bool
        Whether one of the company waits here for others.
    without : GoingOn or None
        What to do if those who are to be met do not come; None if nobody is.
    halts : tuple of Halt
        Why the vehicle stands here, in order of time.
    turn : int or None
        Which of two drivers, 1 or 2, drives from here on; None if that is no news.
    lead : tuple of int, (2,), or None
        Who leads from here on, and who led until here; None if that is no news.
    """

    place: Stop | PlatoonPoint
    at_m: float
    reached_s: float | None
    leaves_s: float | None
    joined: Company
    left: Company
    moves: bool
    way: Way | None
    waited_for: bool = False
    without: GoingOn | None = None
    halts: tuple[Halt, ...] = ()
    turn: int | None = None
    lead: tuple[int, int] | None = None

    @property
    def pauses(self) -> tuple[Halt, ...]:
        """Breaks, rests, bans and changes of drivers; all halts but waits for others."""
        return tuple(one for one in self.halts if one.what != "wait")

    @property
    def wait_s(self) -> float:
        """How long the vehicle waits for others here; 0 if that is not worth telling."""
        if self.reached_s is None or self.leaves_s is None:
            return 0.0
        wait = self.leaves_s - self.reached_s - sum(one.lasts_s for one in self.pauses)
        return wait if wait >= MENTIONED_S else 0.0

    @property
    def is_pause(self) -> bool:
        """Whether the vehicle does nothing here but pause."""
        return bool(self.pauses) and not (self.joined or self.left)


def steps_of(
    plan: Plan,
    net: RoadNetwork,
    index: int,
    patience_s: float | None = None,
    halts: Sequence[Halt] | None = None,
) -> tuple[Step, ...]:
    """Return the steps of a vehicle, from its origin to its destination.

    Parameters
    ----------
    plan : Plan
        Laid out in whole edges.
    net : RoadNetwork
        The network it is laid out on.
    index : int
        Position of the vehicle in the plan.
    patience_s : float or None
        How long after the planned moment to wait for others at most [s]; None for no other limit
        than the latest arrival.
    halts : sequence of Halt, optional
        Where it stands, if that is known already.

    Returns
    -------
    tuple of Step
        Two or more.
    """
    stretches = [plan.stretches[k] for k in plan.ways[index]]
    times = plan.times[index]
    halts = halts_of(plan, net)[index] if halts is None else halts
    driven = [0.0, *accumulate(one.length_m for one in stretches)]
    found: list[Step] = []
    for number in range(len(stretches) + 1):
        before = stretches[number - 1] if number else None
        after = stretches[number] if number < len(stretches) else None
        came, goes = _order(before, index), _order(after, index)
        joined = tuple(one for one in goes if one not in came)
        left = tuple(one for one in came if one not in goes)
        reached = leaves = None
        if times is not None:
            reached = times.legs[number - 1][1] if number else times.departure_s
            leaves = times.legs[number][0] if after else None
        stands = tuple(one for one in halts if one.before == number)
        turn = None
        if times is not None and after is not None:
            turn = driver_at(times, number)
            if number and turn == driver_at(times, number - 1):
                turn = None
        place, moves = _place(plan, net, index, number, joined, left)
        aside = next((one for one in stands if one.what != "wait"), None)
        if aside is not None and number and not (joined or left):
            place = Stop(-1, aside.lon, aside.lat, aside.name)
        step = Step(
            place=place,
            at_m=driven[number],
            reached_s=reached,
            leaves_s=leaves,
            joined=joined,
            left=left,
            moves=moves,
            way=None if after is None else _way(net, after),
            waited_for=bool(joined) and _others_wait(plan, index, number),
            without=going_on(plan, net, index, number, patience_s) if joined else None,
            halts=stands,
            turn=turn,
            lead=_lead(plan, came, goes),
        )
        if found and after is not None and not _tells(step, found[-1], came, goes):
            found[-1] = replace(found[-1], way=_longer(found[-1].way, step.way))
        else:
            found.append(step)
    return tuple(found)


def _order(stretch: Stretch | None, index: int) -> Company:
    return (index,) if stretch is None else stretch.vehicles


def _lead(plan: Plan, came: Company, goes: Company) -> tuple[int, int] | None:
    """Return who takes the lead from whom, in a plan whose lead is handed on."""
    if plan.rotation is None or min(len(came), len(goes)) < 2 or came[0] == goes[0]:
        return None
    return goes[0], came[0]


def _tells(step: Step, last: Step, came: Company, goes: Company) -> bool:
    """Return whether a driver has to know of a step between two stretches."""
    on_road = step.way is not None and last.way is not None and (
        step.way.is_access != last.way.is_access
    )  # fmt: skip
    stands = step.wait_s > 0 or bool(step.pauses)
    return came != goes or on_road or stands or step.turn is not None


def driver_at(times: VehicleTimes, leg: int) -> int | None:
    """Return which of two drivers drives a leg.

    Parameters
    ----------
    times : VehicleTimes
        Of a vehicle.
    leg : int
        Counted from 0 along its way.

    Returns
    -------
    int or None
        1 or 2; None for a vehicle of one driver. Where the plan does not say who drives which leg,
        the first begins and each change of drivers is one.
    """
    for number, driver in enumerate(times.drivers, 1):
        if len(times.drivers) > 1 and driver.drives is not None and leg in driver.drives:
            return number
    if max((driver.state.drivers for driver in times.drivers), default=1) < 2:
        return None
    changes = sum("change" in one.purposes and one.before <= leg for one in times.pauses)
    return 1 + changes % 2


def _way(net: RoadNetwork, stretch: Stretch) -> Way:
    beside = stretch.access is not None
    roads = "" if beside else roads_of(net, stretch.edges)
    return Way(roads, stretch.length_m, stretch.drive_s, stretch.vehicles, beside)


def _longer(one: Way | None, more: Way | None) -> Way | None:
    if one is None or more is None:
        return one or more
    refs = dict.fromkeys([*one.roads.split(", "), *more.roads.split(", ")])
    return replace(
        one,
        roads=", ".join(filter(None, refs)),
        length_m=one.length_m + more.length_m,
        drive_s=one.drive_s + more.drive_s,
    )


def _place(
    plan: Plan, net: RoadNetwork, index: int, number: int, joined: Company, left: Company
) -> tuple[Stop | PlatoonPoint, bool]:
    """Return where a step is, and whether this vehicle is who joins or leaves."""
    way = plan.ways[index]
    events = [
        event
        for event in plan.events
        if (event.kind == "merge" and joined and number < len(way) and event.stretch == way[number])
        or (event.kind == "separation" and left and number and event.stretch == way[number - 1])
    ]
    mine = [event for event in events if index in event.movers and event.others]
    changes = () if plan.rotation is None else plan.rotation.changes
    if number == 0:
        return plan.trips[index].origin, bool(mine)
    if number == len(way):
        return plan.trips[index].destination, bool(mine)
    for event in (*mine, *events):
        return event.point, bool(mine)
    for change in changes:
        if change.stretch == way[number]:
            return change.point, False
    return _between(plan, net, way[number - 1], way[number]), False


def _between(plan: Plan, net: RoadNetwork, before: int, after: int) -> Stop:
    """Return where one stretch goes over into another, if no event of the plan names it."""
    one, other = plan.stretches[before], plan.stretches[after]
    node = int(net.head[one.edges[-1]] if one.edges else net.tail[other.edges[0]])
    name = (one if one.access else other).access_at or net.place_name(node)
    return Stop(node, float(net.lon[node]), float(net.lat[node]), name)


def _others_wait(plan: Plan, index: int, number: int) -> bool:
    """Return whether others of the company wait where a stretch of a vehicle's way begins."""
    waits = _waits(plan, plan.ways[index][number])
    return any(wait >= MENTIONED_S for other, wait in waits if other != index)


def _waits(plan: Plan, stretch: int) -> Iterator[tuple[int, float]]:
    for other in plan.stretches[stretch].vehicles:
        times, way = plan.times[other], plan.ways[other]
        if times is not None:
            yield other, times.waits[_at(way, stretch)]


def _at(way: Sequence[int], stretch: int) -> int:
    return list(way).index(stretch)
