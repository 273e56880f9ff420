"""Who leads what, company by company in driving order, with what everybody owes carried along.

A vehicle's fair share of a company is its length by the number of its vehicles. What a vehicle has
led too little or too much in one company it owes, or has ahead, in the next one it is in. Who is
willing to lead a part of its share alone, leaves the rest to the others.

What is best for one company is not always best for those after it. So companies are tried one by
one without a change of the lead within them, and that is kept where it makes the greatest deviation
of all less, or changes fewer at the same deviation.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from ...network.road_network import RoadNetwork
from ...plans.records import Stretch
from ..timing.stops import Place
from .companies import Company
from .marks import Mark, marks_of
from .turns import Row, turns_in_front

__all__ = ["Led", "Part", "led_evenly", "led_in_turns"]


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a stretch that one vehicle leads.

    Attributes
    ----------
    cut : (int, float) or None
        Where it begins; None for where the stretch does.
    order : tuple of int
        Its vehicles, the leader first.
    former : int or None
        Who led until there and falls back; None if nobody hands on the lead.
    """

    cut: Place | None
    order: tuple[int, ...]
    former: int | None


@dataclass(frozen=True, slots=True)
class Led:
    """Who leads what.

    Attributes
    ----------
    parts : mapping of int to tuple of Part
        For each stretch driven together, its parts in driving order.
    fair_m, led_m : tuple of float, (N,)
        As in `Rotation`.
    asked_m : tuple of float, (N,)
        What each is asked to lead: its fair share, if all are willing [m].
    """

    parts: Mapping[int, tuple[Part, ...]]
    fair_m: tuple[float, ...]
    led_m: tuple[float, ...]
    asked_m: tuple[float, ...]

    @property
    def rank(self) -> tuple[int, int, float]:
        """What is to be least: the greatest deviation [m], changes, and the sum of squares."""
        away = [one - other for one, other in zip(self.asked_m, self.led_m, strict=True)]
        changes = sum(part.former is not None for own in self.parts.values() for part in own)
        return round(max(map(abs, away), default=0.0)), changes, sum(one * one for one in away)


MOST_TRIED = 40
"""Of more companies than this the later ones are not tried without a change."""

MOST_TRIES = 150
"""So many times at most the whole plan is led anew."""


def led_evenly(
    net: RoadNetwork,
    stretches: Sequence[Stretch],
    companies: Sequence[Company],
    willing: Sequence[float],
    least_m: float,
    longer_m: float,
) -> Led:
    """Return who leads what, so that all lead about what they are asked to.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges they name.
    stretches : sequence of Stretch
        Of the plan.
    companies : sequence of Company
        Each after those its vehicles come from.
    willing : sequence of float, (N,)
        What part of its fair share each leads, in [0, 1].
    least_m : float
        Nobody leads less before it hands on the lead [m].
    longer_m : float
        By how much an edge has to be longer than a share for places within it [m].

    Returns
    -------
    Led
        The best of those tried.
    """
    marks = []
    for company in companies:
        own = [stretches[k] for k in company.stretches]
        even_m = sum(one.length_m for one in own) / len(own[0].vehicles)
        marks.append(marks_of(net, own, even_m, longer_m))

    def led(some: frozenset[int]) -> Led:
        return led_in_turns(stretches, companies, marks, willing, least_m, some)

    held: frozenset[int] = frozenset()
    best = led(held)
    improved = True
    tries = 0
    while improved and tries < MOST_TRIES:
        improved = False
        tries += min(len(companies), MOST_TRIED)
        for number in range(min(len(companies), MOST_TRIED)):
            other = led(held ^ {number})
            if other.rank < best.rank:
                best, held, improved = other, held ^ {number}, True
    return best


def led_in_turns(
    stretches: Sequence[Stretch],
    companies: Sequence[Company],
    marks: Sequence[Sequence[Mark]],
    willing: Sequence[float],
    least_m: float,
    held: Collection[int] = (),
) -> Led:
    """Return who leads what.

    Parameters
    ----------
    stretches : sequence of Stretch
        Of the plan.
    companies : sequence of Company
        Each after those its vehicles come from.
    marks : sequence of sequence of Mark
        For each company, where it may hand on the lead.
    willing : sequence of float, (N,)
        What part of its fair share each leads, in [0, 1].
    least_m : float
        Nobody leads less before it hands on the lead [m].
    held : collection of int
        Positions of companies within which the lead does not change.

    Returns
    -------
    Led
        The greatest deviation in each company is the least, given what was led before.
    """
    fair, asked, led = ([0.0] * len(willing) for _ in range(3))
    row_after: dict[int, tuple[int, ...]] = {}
    since_after: dict[int, float] = {}
    parts: dict[int, tuple[Part, ...]] = {}
    for number, company in enumerate(companies):
        row, since_m = _row(company, row_after, since_after)
        own = [stretches[k] for k in company.stretches]
        length_m = sum(one.length_m for one in own)
        shares = _shares(row, willing, length_m)
        for vehicle, share in zip(row, shares, strict=True):
            fair[vehicle] += length_m / len(row)
            asked[vehicle] += share
        places = () if number in held else marks[number]
        turns = turns_in_front(
            Row(
                tuple(asked[one] - led[one] for one in row),
                tuple(one in company.goes_on for one in row),
                since_m,
            ),
            [mark.at_m for mark in places],
            length_m,
            least_m,
        )
        for turn in turns:
            led[row[turn.place]] += turn.end_m - turn.begin_m
        at = {mark.at_m: mark for mark in places}
        begins = [(at.get(turn.begin_m), turn.place) for turn in turns]
        parts |= _parts(company, row, begins, since_m > 0)
        last = turns[-1]
        row_after[company.stretches[-1]] = (*row[last.place :], *row[: last.place])
        since_after[company.stretches[-1]] = (
            last.end_m - last.begin_m + (since_m if last.place == 0 else 0.0)
        )
    return Led(parts, tuple(fair), tuple(led), tuple(asked))


def _row(
    company: Company,
    row_after: Mapping[int, tuple[int, ...]],
    since_after: Mapping[int, float],
) -> tuple[tuple[int, ...], float]:
    """Return the row in which a company sets out, and how long its first has led already [m]."""
    row: list[int] = []
    for some, last in zip(company.rows, company.before, strict=True):
        known = some if last is None else row_after[last]
        row += [one for one in known if one in some]
    last = company.before[0]
    if last is None or row_after[last][0] != row[0]:
        return tuple(row), 0.0
    return tuple(row), since_after[last]


def _shares(row: Sequence[int], willing: Sequence[float], length_m: float) -> list[float]:
    """Return how much each of a row is asked to lead [m]."""
    own = [willing[one] for one in row]
    even = length_m / len(row)
    if not sum(own):
        return [even] * len(row)
    left = length_m - even * sum(own)
    # Those who lead all of their share take what the others leave.
    full = sum(one == 1.0 for one in own)
    if full:
        return [even * one + (left / full if one == 1.0 else 0.0) for one in own]
    return [length_m * one / sum(own) for one in own]


def _parts(
    company: Company, row: tuple[int, ...], begins: Sequence[tuple[Mark | None, int]], led: bool
) -> dict[int, tuple[Part, ...]]:
    """Return the parts of the stretches of a company."""
    found: dict[int, tuple[Part, ...]] = {}
    former: int | None = row[0] if led else None
    place = 0
    for number, stretch in enumerate(company.stretches):
        own: list[Part] = []
        for mark, after in begins:
            if (0 if mark is None else mark.stretch) != number:
                continue
            cut = None if mark is None else mark.cut
            if cut is not None and not own:
                own.append(Part(None, _turned(row, place), None))
            first = row[after]
            own.append(Part(cut, _turned(row, after), None if former == first else former))
            place, former = after, first
        found[stretch] = tuple(own or [Part(None, _turned(row, place), None)])
    return found


def _turned(row: tuple[int, ...], place: int) -> tuple[int, ...]:
    return (*row[place:], *row[:place])
