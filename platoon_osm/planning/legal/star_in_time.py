"""One star under driving rules: when it is driven, and who drives in it.

Under "system" members and master pay least in all. The master gains once an edge, so members hang
together. Paid the whole gain on each edge they do not, and pay no more than any plan costs: that is
a bound, and exact for one member; paid a share each, that less what is given away beside. The plan
is the best of those that are found at these prices, at its true cost.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..cases import Case, running_sum
from ..company.draft import NO_CHEAPER
from ..question import Question
from ..star import Star
from .legal_question import LegalQuestion
from .member_ways import MemberWays
from .platoon.again import Again
from .platoon.real import Together
from .platoon.record import PlatoonTiming, gained
from .platoon.search import PlatoonSearch
from .platoon.star_searches import StarSearches
from .platoon.star_times import StarTimes
from .star_input import star_way

__all__ = ["LIMIT_S", "Platooned", "StarSearch", "case_of", "closing_lengths"]

Floats = NDArray[np.float64]

LONGEST_S = 7 * 86_400
"""A window that is open ends so long after it begins, as far as closings are looked at [s]."""

BESIDE_S = (0, 1800)
"""How much longer than a closing pauses for it are [s]."""

LIMIT_S = 60.0
"""No turn of the search for one master lasts longer, on however slow a machine [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Platooned:
    """One star as it is driven.

    Attributes
    ----------
    star : Star
        The master and its members.
    timing : PlatoonTiming
        When.
    ways : MemberWays
        The members' ways.
    together : list of sequence of (int, int), (M, ...)
        Where each member drives with the master; nothing for one that stays alone.
    """

    star: Star
    timing: PlatoonTiming
    ways: MemberWays
    together: list[Sequence[Together]]

    @property
    def joined(self) -> list[int]:
        """The vehicles that drive with the master, and the master, as positions in the plan."""
        own = [k for k, some in zip(self.star.members, self.together, strict=True) if len(some)]
        return sorted([self.star.master, *own]) if own else []


def case_of(question: Question) -> Case:
    """Return which points are free in a star.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    {"A", "B", "C"}
        "C" where any case will do.
    """
    asked = question.problem.case
    return "A" if asked == "A" else "B" if asked == "B" else "C"


class StarSearch:
    """A search for when a star is driven and who drives in it, so that what is asked for is least.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    star : Star
        A master and its members.
    among : collection of int, optional
        The vehicles that may join; by default all.

    Attributes
    ----------
    star : Star
        The same.
    """

    def __init__(
        self, legal: LegalQuestion, star: Star, among: Collection[int] | None = None
    ) -> None:
        self.star = star
        gain = np.maximum(star.gain, 0.0)
        self._shares: tuple[float, ...] = ()
        if legal.question.problem.optimum == "member" or not gain.any():
            self._searches = [_Priced(legal, star, among, None)]
        else:
            self._shares = tuple(dict.fromkeys((1.0, 1.0 / max(len(star.members), 1))))
            self._searches = [_Priced(legal, star, among, one * gain) for one in self._shares]

    def go_on(self, most_spans: int, below: float = np.inf) -> Platooned:
        """Search on.

        Parameters
        ----------
        most_spans : int
            Spans of departures that are looked at before it stops.
        below : float
            A plan that costs as much is of no interest, and may not be found; no more than before.

        Returns
        -------
        Platooned
            The best so far with its cost, and a bound of all plans of this star.
        """
        if not self._shares:
            return self._searches[0].go_on(most_spans, below)
        gain, most = np.maximum(self.star.gain, 0.0), most_spans // len(self._shares)
        found = [
            _for_all(one.go_on(most, below + _away(gain, share)), share)
            for one, share in zip(self._searches, self._shares, strict=True)
        ]
        best = min(found, key=lambda one: one.timing.cost)
        timing = replace(
            best.timing,
            bound=min(best.timing.cost, max(one.timing.bound for one in found)),
            waiting_bound=min(best.timing.cost, max(one.timing.waiting_bound for one in found)),
            proved=all(one.timing.proved for one in found),
            spans=sum(one.timing.spans for one in found),
            work=sum(one.timing.work for one in found),
            asked=sum(one.timing.asked for one in found),
        )
        return replace(best, timing=timing)


def _away(gain: Floats, share: float) -> float:
    """Return what is given away of a master's gains if members are paid a share of each."""
    return (1.0 - share) * float(gain.sum())


def _for_all(found: Platooned, share: float) -> Platooned:
    """Return a star that was searched at prices with its true cost, and a bound of all plans.

    Members that are paid a share of the master's gain on each of their edges, and the rest of all
    gains given away, cost no more in all than any plan does: the gain counts once an edge.
    """
    star, timing = found.star, found.timing
    gain = np.maximum(star.gain, 0.0)
    along = running_sum(gain)
    alone = found.star.costs[2]
    pays = [
        one.cost + share * sum(float(along[j] - along[i]) for i, j in some)
        for one, some in zip(timing.members, found.together, strict=False)
    ]
    together = list(found.together)
    # One companion is enough for the master: who costs more than it brings stays alone.
    for row in sorted(range(len(pays)), key=lambda k: float(alone[k]) - pays[k]):
        own, with_it = together[row], gained(star.gain, together)
        together[row] = ()
        if (
            own
            and pays[row] - alone[row]
            > with_it - gained(star.gain, together) + NO_CHEAPER * pays[row]
        ):
            pays[row] = float(alone[row])
        else:
            together[row] = own
    away, cost = _away(gain, share), timing.cost
    if timing.timetable is not None:
        cost = sum(pays) + star.master_alone - gained(star.gain, together)
    timing = replace(
        timing, cost=cost, bound=min(timing.bound - away, cost),
        waiting_bound=min(timing.waiting_bound - away, cost),
    )  # fmt: skip
    return replace(found, timing=timing, together=together)


class _Priced:
    """The search of a star whose members are paid for company, or not."""

    def __init__(
        self,
        legal: LegalQuestion,
        star: Star,
        among: Collection[int] | None,
        price: Floats | None,
    ) -> None:
        own = star_way(legal, star, case_of(legal.question), among, price)
        self._ways = MemberWays(legal, own)
        trips = self._ways.trips
        self._search = PlatoonSearch(
            StarSearches(
                own.times, trips, trips, plain=self._ways.open(), lengths=closing_lengths(own.times)
            ),
            _again(legal, self._ways) if case_of(legal.question) == "C" else None,
        )

    def go_on(self, most_spans: int, below: float) -> Platooned:
        """Search on."""
        star = self._ways.own.star
        timing = self._search.go_on(most_spans, below, LIMIT_S)
        together: list[Sequence[Together]] = [one.stretches for one in timing.members] or [
            () for _ in star.members
        ]
        return Platooned(star, timing, self._ways, together)


def closing_lengths(times: StarTimes) -> tuple[int, ...]:
    """Return how long a master may have to stand for its road to be open again.

    Parameters
    ----------
    times : StarTimes
        A master and its members.

    Returns
    -------
    tuple of int
        Of the closings on its way that the master may meet, the longest one that a pause of the
        law does not outlast, and a little more, for there is a place only now and then [s].
    """
    road, window, limits = times.road, times.window, times.rules.limits
    first = max(window.earliest_s, window.arrival_s - LONGEST_S)
    last = min(window.arrival_s, window.earliest_s + LONGEST_S)
    lasts = [
        int(end - begin) for begin, end in road.forbidden_s.tolist() if end > first and begin < last
    ]
    longest = max(lasts, default=0)
    known = max((one for one in (limits.break_s, limits.rest_s) if one < LONGEST_S), default=0.0)
    return tuple(longest + more for more in BESIDE_S) if longest > known else ()


def _again(legal: LegalQuestion, ways: MemberWays) -> Again:
    """Return what it takes for members that stopped alone to join again."""
    star, fleet = ways.own.star, legal.question.fleet
    solo_along = [running_sum(fleet.alone(member)[star.route]) for member in star.members]

    shape = len(star.members), len(star.route) + 1
    return Again(np.array(solo_along).reshape(shape), ways.trips.trip)
