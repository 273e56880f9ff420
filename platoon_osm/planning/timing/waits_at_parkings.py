"""Who waits for company waits at the last truck parking before it, if there is one near.

Times have a vehicle wait where it merges, which on a motorway is nowhere to stand. What it drives
between the last parking on its way and that place can as well be driven after the wait as before
it: it is alone there, or with the same company, and everybody is met when they were. So all times
of others, all costs and all lengths stay. Where a road on the way would be closed then, or no
parking is near, the wait stays where it is, without a place.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from ...network.road_network import RoadNetwork
from ...network.stops import stops_along
from ...plans.clock import MENTIONED_S
from ...plans.pauses import Pause, PausePlace
from ...plans.plan import Plan
from ...plans.records import Stretch
from ...plans.timetable import LATE_S, VehicleTimes
from ...vehicles.profile import Vehicle
from .hours_check import broken_hours
from .parking_before import FARTHEST_BACK_M, parking_place, parkings_back
from .stops import Place, cut_plan, time_to

__all__ = ["with_waits_at_parkings"]

COMPANY = ("company",)


@dataclass(frozen=True, slots=True)
class _Move:
    """A wait and the parking to which it moves.

    Attributes
    ----------
    stretches : tuple of int
        What is driven after the wait instead of before, in driving order.
    cut : (int, float) or None
        Where on the first of them the parking is; None if it begins there, after a pause.
    wait_s : float
        How long they wait [s].
    place : PausePlace
        The parking.
    """

    stretches: tuple[int, ...]
    cut: Place | None
    wait_s: float
    place: PausePlace


def with_waits_at_parkings(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Plan:
    """Return a plan in which waits for company happen at parkings, where those are near.

    Parameters
    ----------
    plan : Plan
        With or without times.
    net : RoadNetwork
        The network whose edges it names.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.

    Returns
    -------
    Plan
        The same journeys and meetings; `Pause` records name the parkings.
    """
    if plan.timetable is None or not len(net.points.kind):
        return plan
    moves = list(_moves(plan, net, vehicles))
    if not moves:
        return plan
    before = len(broken_hours(plan, net, vehicles))
    moved = _moved(plan, net, moves)
    while moves and len(broken_hours(moved, net, vehicles)) > before:
        moves = [
            one
            for one in moves
            if len(broken_hours(_moved(plan, net, [one]), net, vehicles)) <= before
        ][: len(moves) - 1]
        moved = _moved(plan, net, moves)
    return moved


# -- which waits -----------------------------------------------------------------------------------


def _moves(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Iterator[_Move]:
    around = _Around(plan)
    joined = {event.stretch for event in plan.events if event.kind == "merge"}
    for number, stretch in enumerate(plan.stretches):
        after = {around.after(index, number) for index in stretch.vehicles}
        following = after.pop()
        # One place, one moment: who waits in two companies at once is not moved.
        if after or following is None or following not in joined:
            continue
        wait_s = around.plain_wait_s(number, following)
        if wait_s >= MENTIONED_S:
            move = _to_parking(plan, net, vehicles, around, number, wait_s)
            if move is not None:
                yield move


class _Around:
    """What vehicles drive before and after a stretch, and how long they stand between."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.leg = {
            (index, number): leg
            for index, way in enumerate(plan.ways)
            for leg, number in enumerate(way)
        }

    def after(self, index: int, number: int) -> int | None:
        leg, way = self.leg[index, number], self.plan.ways[index]
        return way[leg + 1] if leg + 1 < len(way) else None

    def before(self, number: int) -> int | None:
        """Return the stretch that the same company drove before, if it is one."""
        found = set()
        for index in self.plan.stretches[number].vehicles:
            leg = self.leg[index, number]
            found.add(self.plan.ways[index][leg - 1] if leg else None)
        one = found.pop()
        if found or one is None:
            return None
        same = self.plan.stretches[one].company == self.plan.stretches[number].company
        return one if same else None

    def pauses(self, number: int) -> list[tuple[float, Pause | None]]:
        """Return how long each vehicle of a stretch stands before it, and the record of that."""
        found: list[tuple[float, Pause | None]] = []
        for index in self.plan.stretches[number].vehicles:
            leg, times = self.leg[index, number], self._times(index)
            record = next((one for one in times.pauses if one.before == leg), None)
            found.append((times.waits[leg], record))
        return found

    def plain_wait_s(self, number: int, following: int) -> float:
        """Return how long the company of a stretch waits after it, without a record [s]."""
        waits = set()
        for index in self.plan.stretches[number].vehicles:
            leg, times = self.leg[index, following], self._times(index)
            if any(one.before == leg for one in times.pauses):
                return 0.0
            waits.add(times.waits[leg])
        return min(waits) if max(waits) - min(waits) < LATE_S else 0.0

    def _times(self, index: int) -> VehicleTimes:
        assert self.plan.timetable is not None
        return self.plan.timetable.vehicles[index]


def _to_parking(
    plan: Plan,
    net: RoadNetwork,
    vehicles: Sequence[Vehicle],
    around: _Around,
    number: int,
    wait_s: float,
) -> _Move | None:
    """Return the move to the last parking before the end of a stretch; None if none is near."""
    company = [vehicles[index] for index in plan.stretches[number].vehicles]
    chain: list[int] = []
    back_m = 0.0
    current: int | None = number
    while current is not None and back_m <= FARTHEST_BACK_M:
        stretch = plan.stretches[current]
        chain.insert(0, current)
        for passed, _ in parkings_back(net, stretch, company, back_m):
            stop, share = passed.stop, passed.access.share
            stays = stop.max_stay_s is None or stop.max_stay_s >= wait_s
            cut = (passed.place, share) if share < 1.0 else (passed.place + 1, 0.0)
            within = (0, stretch.span[0]) < cut < (len(stretch.edges), 0.0)
            if stays and within and cut < (len(stretch.edges) - 1, stretch.span[1]):
                place = parking_place(stop, passed.access)
                return _Move(tuple(chain), cut, wait_s, place)
        back_m += stretch.length_m
        stood = around.pauses(current)
        if any(gap > 0 or record is not None for gap, record in stood):
            place_there = _common_parking(net, stretch, stood, wait_s)
            near = back_m <= FARTHEST_BACK_M
            return _Move(tuple(chain), None, wait_s, place_there) if near and place_there else None
        current = around.before(current)
    return None


def _common_parking(
    net: RoadNetwork, stretch: Stretch, stood: Sequence[tuple[float, Pause | None]], wait_s: float
) -> PausePlace | None:
    """Return the parking at which all pause before a stretch, if they may stay on."""
    places = {record.place if record is not None else None for _, record in stood}
    one = places.pop()
    if places or one is None or not one.has_parking:
        return None
    longest = max(gap for gap, _ in stood) + wait_s
    for passed in stops_along(net, stretch.edges, stretch.span):
        stop = passed.stop
        if (stop.lon, stop.lat) == (one.lon, one.lat) and (stop.max_stay_s or longest) < longest:
            return None
    return one


# -- the plan that has them ------------------------------------------------------------------------


def _moved(plan: Plan, net: RoadNetwork, moves: Sequence[_Move]) -> Plan:
    assert plan.timetable is not None
    later = {number: one for one in moves for number in one.stretches}
    cuts = {one.stretches[0]: one.cut for one in moves if one.cut is not None}
    first_s = {number: time_to(net, plan.stretches[number], cut) for number, cut in cuts.items()}
    vehicles = tuple(
        _times(times, way, later, first_s)
        for times, way in zip(plan.timetable.vehicles, plan.ways, strict=True)
    )
    untimed = replace(plan, timetable=None)
    found = cut_plan(net, untimed, {number: [cut] for number, cut in cuts.items()})
    return replace(found, timetable=replace(plan.timetable, vehicles=vehicles))


def _times(
    times: VehicleTimes,
    way: Sequence[int],
    later: Mapping[int, _Move],
    first_s: Mapping[int, float],
) -> VehicleTimes:
    """Return the times of a vehicle whose waits are moved."""
    legs: list[tuple[float, float]] = []
    pauses: list[Pause] = []
    now: list[int] = []  # which leg each one was: two pieces of a leg were the same
    for leg, (number, (begin, end)) in enumerate(zip(way, times.legs, strict=True)):
        move = later.get(number)
        own = [one for one in times.pauses if one.before == leg]
        wait_s = 0.0 if move is None else move.wait_s
        if move is not None and number in first_s:
            pauses += (replace(one, before=len(legs)) for one in own)
            parked = begin + first_s[number]
            legs.append((begin, parked))
            now.append(leg)
            pauses.append(Pause(len(legs), COMPANY, parked, parked + wait_s, move.place))
            legs.append((parked + wait_s, end + wait_s))
        else:
            if own and move is not None and number == move.stretches[0]:
                own[-1] = _longer(own[-1], wait_s)
            pauses += (replace(one, before=len(legs)) for one in own)
            legs.append((begin + wait_s, end + wait_s))
        now.append(leg)
    drivers = tuple(
        one
        if one.drives is None
        else replace(one, drives=tuple(k for k, leg in enumerate(now) if leg in one.drives))
        for one in times.drivers
    )
    for leg in range(len(legs) - 2, -1, -1):
        # Sums differ in their last digits: nobody is to leave before it has arrived.
        begin, end = legs[leg]
        end = min(end, legs[leg + 1][0])
        legs[leg] = min(begin, end), end
    return replace(times, legs=tuple(legs), pauses=tuple(pauses), drivers=drivers)


def _longer(pause: Pause, by_s: float) -> Pause:
    purposes = (*(one for one in pause.purposes if one not in COMPANY), *COMPANY)
    return replace(pause, purposes=purposes, end_s=pause.end_s + by_s)
