"""When everyone drives, so that those who merge are there together: exact for given routes.

With t_p the start [s] of piece p (`pieces.py`) and d_p its driving time [s], a vehicle that drives
p and then q needs

    t_q = t_p + d_p    if nobody joins where q begins,
    t_q >= t_p + d_p   if somebody does; the difference is waiting on the road [s].

With e, l and a a vehicle's earliest departure, latest departure and latest arrival [s], p its
first piece and z its last: t_p >= e; t_p <= l, unless it merges at its very origin, where it
leaves by l and waits; t_z + d_z <= a + L, with its lateness L >= 0. What is linear in t and L is
minimised in turn, each under the least values of those before:

1. the largest L,
2. the sum of all L,
3. the sum of all waiting, so departures are shifted before anyone waits,
4. the sum of all arrivals; in a group of vehicles that drive together and name latest times only,
   the negative sum: such a group arrives just in time,
5. the sum of all t, which settles at which of several points the waiting happens.

A group of vehicles that names no time at all leaves at the earliest moment the plan names.
The model is ours.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ...plans.clock import Clock, late_by
from ...plans.plan import Plan
from ...plans.timetable import Timetable, VehicleTimes
from ...plans.trip import TIMES, Trip, check_one_clock
from ...plans.zones import clock_of, in_order
from .flexibility import with_latest_arrivals
from .pieces import Pieces, pieces_of

__all__ = ["ROUTES_GIVEN", "schedule", "with_times"]

ROUTES_GIVEN = "who merges where was chosen without the clock, and the times are exact for that"

SLACK_S = 1e-5
"""How far a later aim may move an earlier one from its least value [s]."""

NEAR_S = 0.005
"""Times of the solver this near to a bound are meant to be at it [s]."""

Floats = NDArray[np.float64]
Row = dict[int, float]


def with_times(plan: Plan, trips: Sequence[Trip]) -> Plan:
    """Return a plan with its timetable; the plan itself if no trip names a time.

    Parameters
    ----------
    plan : Plan
        Without times.
    trips : sequence of Trip
        Those of the plan's vehicles, by name.

    Returns
    -------
    Plan
        The same routes; remarks tell who is late.
    """
    timetable = schedule(plan, trips)
    if timetable is None:
        return plan
    return replace(
        plan,
        timetable=timetable,
        proof=replace(plan.proof, conditions=(*plan.proof.conditions, ROUTES_GIVEN)),
        remarks=(*plan.remarks, *_lateness(timetable)),
    )


def _lateness(timetable: Timetable) -> Iterator[str]:
    late = [times for times in timetable.vehicles if times.late_s]
    if late:
        who = ", ".join(f"{times.vehicle} by {late_by(times.late_s)}" for times in late)
        yield (
            f"not feasible in time: late are at best {who}; give earlier departures, later "
            "arrivals, or other company"
        )


def schedule(plan: Plan, trips: Sequence[Trip]) -> Timetable | None:
    """Return when everyone drives; None if no trip names a time.

    Parameters
    ----------
    plan : Plan
        Without times.
    trips : sequence of Trip
        Those of the plan's vehicles, by name.

    Returns
    -------
    Timetable or None
        The best times for these routes, as the module's text says.

    Raises
    ------
    ScenarioError
        Times with and without a zone, a vehicle without its trip, or legs that do not fit together.
    """
    check_one_clock(trips)
    named = [at for trip in trips for at in trip.times.values()]
    if not named:
        return None
    known = {trip.vehicle: trip for trip in trips}
    for vehicle in plan.vehicles:
        if vehicle.vehicle not in known:
            raise ScenarioError(f"schedule: vehicle {vehicle.vehicle!r} has no trip; give it one")
    first = min(named, key=in_order)
    clock = Clock.at(first)
    asked = with_latest_arrivals(
        [known[trip.vehicle] for trip in plan.trips], [trip.alone.time_s for trip in plan.trips]
    )
    windows = [_window(trip, clock) for trip in asked]
    pieces = pieces_of(plan.stretches, plan.ways)
    starts = _starts(pieces, windows)
    # Seconds count from the whole second at or before the first departure.
    leaving = (w.leaves(starts[way[0]]) for w, way in zip(windows, pieces.ways, strict=True))
    shift = math.floor(min(leaving) + NEAR_S)
    windows = [window.moved(shift) for window in windows]
    spans = _settled(pieces, windows, starts - shift)
    vehicles = tuple(
        VehicleTimes(
            vehicle.vehicle,
            window.leaves(spans[way[0]][0]),
            tuple(spans[piece] for piece in way),
            window.earliest, window.latest, window.arrival,
        )
        for vehicle, window, way in zip(plan.vehicles, windows, pieces.ways, strict=True)
    )  # fmt: skip
    in_time = not any(times.late_s for times in vehicles)
    # By the clocks of the zone that is named first, as far as times are shown.
    shown = clock_of(first, shift, (at for times in vehicles for at in times.moments))
    return Timetable(shown.start.isoformat(), in_time, vehicles, shown.name, shown.offsets)


@dataclass(frozen=True, slots=True)
class _Window:
    """When a vehicle wants to leave and arrive [s]; None where it does not say."""

    earliest: float | None
    latest: float | None
    arrival: float | None

    def leaves(self, start: float) -> float:
        """Return when it leaves if its first piece starts then."""
        return float(start) if self.latest is None else min(float(start), self.latest)

    def moved(self, by: float) -> _Window:
        """Return the window by a clock that starts so much later."""
        every = (self.earliest, self.latest, self.arrival)
        return _Window(*(None if at is None else at - by for at in every))


NOTHING_ASKED = _Window(None, None, None)


def _window(trip: Trip, clock: Clock) -> _Window:
    times = trip.times
    return _Window(*(clock.seconds(times[name]) if name in times else None for name in TIMES))


# -- the linear programme --------------------------------------------------------------------------


def _starts(pieces: Pieces, windows: Sequence[_Window]) -> Floats:
    """Return the start of each piece [s], right but for the last digits."""
    from scipy.optimize import linprog

    model = _Model(pieces, windows)
    values: Floats = np.zeros(model.size)
    for aim in model.aims():
        if not aim.any():
            continue
        rows, limits = model.demands()
        found = linprog(aim, rows, limits, bounds=model.bounds, method="highs")
        if found.x is None:
            raise ScenarioError(
                f"schedule: the solver found no times ({found.message}); check the times of the "
                "trips"
            )
        values = found.x
        model.limit(
            {k: aim[k] for k in np.flatnonzero(aim).tolist()}, float(aim @ values) + SLACK_S
        )
    return np.array([values[piece.root] + piece.offset_s for piece in pieces.pieces])


class _Model:
    """Rows, limits and bounds of the linear programme.

    Its variables are the starts of all pieces (those that are settled by another are fixed at 0),
    the lateness of each vehicle, its wait at its origin, and the largest lateness.
    """

    def __init__(self, pieces: Pieces, windows: Sequence[_Window]) -> None:
        self.pieces, self.windows = pieces, windows
        self.late = len(pieces.pieces)
        self.origin_wait = self.late + len(windows)
        self.size = self.origin_wait + len(windows) + 1
        self.rows: list[Row] = []
        self.limits: list[float] = []
        self.named = self._named()
        self.bounds: list[tuple[float | None, float | None]] = [(0.0, None)] * self.size
        for k, piece in enumerate(pieces.pieces):
            self.bounds[k] = self._bounds(k)
            if piece.root == k:
                for last in piece.before:
                    # t_last + d_last <= t_k
                    self.limit(self.row((last, 1), (k, -1)), -self._end(last) + piece.offset_s)
        for index, window in enumerate(windows):
            first, final = pieces.ways[index][0], pieces.ways[index][-1]
            if window.arrival is not None:
                late = self.late + index
                row = self.row((final, 1)) | {late: -1.0}
                self.limit(row, window.arrival - self._end(final))
                self.limit({late: 1.0, self.size - 1: -1.0}, 0.0)
            if window.latest is not None and len(pieces.pieces[first].company) > 1:
                row = self.row((first, 1)) | {self.origin_wait + index: -1.0}
                self.limit(row, window.latest)

    def limit(self, row: Row, most: float) -> None:
        """Demand that a sum is at most so much."""
        self.rows.append(row)
        self.limits.append(most)

    def demands(self) -> tuple[Any, Floats | None]:
        """Return all rows as a sparse matrix, and what their sums may be at most."""
        from scipy.sparse import csr_array

        if not self.rows:
            return None, None
        first = np.cumsum([0, *(len(row) for row in self.rows)])
        columns = [column for row in self.rows for column in row]
        factors = [factor for row in self.rows for factor in row.values()]
        shape = (len(self.rows), self.size)
        return csr_array((factors, columns, first), shape=shape), np.array(self.limits)

    def row(self, *terms: tuple[int, float]) -> Row:
        """Return a row with factors for starts of pieces, without what is constant in them."""
        row: Row = {}
        for piece, factor in terms:
            root = self.pieces.pieces[piece].root
            row[root] = row.get(root, 0.0) + factor
        return row

    def _end(self, piece: int) -> float:
        """Return what lies between the start of a piece's root and the piece's end."""
        one = self.pieces.pieces[piece]
        return one.offset_s + one.time_s

    def _bounds(self, k: int) -> tuple[float | None, float | None]:
        piece = self.pieces.pieces[k]
        if piece.root != k:
            return 0.0, 0.0
        begin = [self.windows[index] for index in piece.begins]
        low = [window.earliest for window in begin if window.earliest is not None]
        high = [window.latest for window in begin if window.latest is not None]
        # In company a vehicle may have to leave its origin and wait; alone it just leaves.
        alone = len(piece.company) == 1
        if begin and not self.named[min(piece.company)]:
            low.append(0.0)
        return max(low, default=None), min(high, default=None) if alone else None

    def _named(self) -> list[bool]:
        """Return for each vehicle whether it, or one it is linked with, names a time."""
        named = [False] * len(self.windows)
        for group in self.pieces.groups:
            if any(self.windows[index] != NOTHING_ASKED for index in group):
                for index in group:
                    named[index] = True
        return named

    def aims(self) -> Iterator[Floats]:
        """Yield what is minimised, one after another."""
        most_late, all_late, waiting, arrivals, starts = np.zeros((5, self.size))
        most_late[-1] = 1
        all_late[self.late : self.origin_wait] = 1
        waiting[self.origin_wait : -1] = 1
        for way in self.pieces.ways:
            # arrival - departure, which is driving time and waiting
            for column, factor in self.row((way[-1], 1), (way[0], -1)).items():
                waiting[column] += factor
        for group in self.pieces.groups:
            from_when = any(self.windows[index].earliest is not None for index in group)
            for index in group:
                last = self.pieces.pieces[self.pieces.ways[index][-1]].root
                arrivals[last] += -1 if self.named[index] and not from_when else 1
        if any(window.arrival is not None for window in self.windows):
            yield most_late
            yield all_late
        for k, piece in enumerate(self.pieces.pieces):
            starts[k] = piece.root == k
        yield from (waiting, arrivals, starts)


def _settled(
    pieces: Pieces, windows: Sequence[_Window], starts: Floats
) -> list[tuple[float, float]]:
    """Return start and end of each piece, so that all that should be equal is so to the last digit.

    The solver's times hold to about 1e-7 s: those near a bound are put there, others are
    rounded to milliseconds.
    """
    spans: list[tuple[float, float]] = []
    for k, piece in enumerate(pieces.pieces):
        if piece.root != k:
            begin = spans[piece.before[0]][1]
        else:
            low = [spans[last][1] for last in piece.before]
            own = [windows[index] for index in piece.begins]
            low += [window.earliest for window in own if window.earliest is not None]
            least = max(low, default=-math.inf)
            near = [least, *(window.latest for window in own if window.latest is not None)]
            at = float(starts[k])
            # Rounded down, or those who wait for it would wait for the rounding.
            rounded = math.floor(at * 1e3 + 0.1) / 1e3
            begin = next((one for one in near if abs(one - at) < NEAR_S), rounded)
            begin = max(begin, least)
        spans.append((begin, begin + piece.time_s))
    return spans
