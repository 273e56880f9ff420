"""Scales of charts: hours of the clock and kilometres whose labels are never cut nor overlap.

Of the steps that people read, the finest is taken at which all labels stand beside one another; a
label that would leave the picture is moved inside. Widths are estimates, rather too wide.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ...plans.clock import Clock
from ..drawing.ticks import MOST_HOURS, hour_ticks, round_step
from ..language.speech import clock_time, number
from ..maps.map_texts import text_width

__all__ = [
    "GAP",
    "SIZE",
    "WIDTH",
    "Tick",
    "day_scale",
    "letter_type",
    "number_scale",
    "plain",
    "text_width",
]

WIDTH = 344.0
"""Of every chart, in its own pixels; a page shows them at about 0.95 to 1.05 of that."""

SIZE = 12.0
"""Of the type of charts: it stays above 11 pixels on a telephone 390 wide."""

GAP = 8.0
"""Least blank between labels of a scale."""

MOST_LETTER, LEAST_LETTER, LETTER_ROOM = 12.0, 9.7, 19.0
"""Type of a letter in a disc of radius 10, and how wide it may be; two wide ones are smaller."""


@dataclass(frozen=True, slots=True)
class Tick:
    """A mark on a scale.

    Attributes
    ----------
    at : float
        Where it belongs, in the scale's unit.
    place : float
        Middle of its label, in pixels.
    text : str
        Its label; empty if there is no room for one.
    below : str
        A second line: the day where it is another one, or the offset of an hour read twice.
    strong : bool
        Whether it is midnight.
    """

    at: float
    place: float
    text: str
    below: str = ""
    strong: bool = False

    @property
    def texts(self) -> tuple[str, ...]:
        """The text and what is below it, a line each."""
        return tuple(text for text in (self.text, self.below) if text)


def letter_type(letter: str) -> str:
    """Return the type size at which a vehicle's letter fits its disc in a chart.

    Parameters
    ----------
    letter : str
        One letter or more.

    Returns
    -------
    str
        In pixels.
    """
    fits = LETTER_ROOM / text_width(letter, 1.0, True)
    # Three letters come with the 703rd vehicle.
    least = LEAST_LETTER if len(letter) < 3 else 0.0
    return f"{min(MOST_LETTER, max(fits, least)):.1f}"


def day_scale(
    clock: Clock,
    begin_s: float,
    end_s: float,
    position: Callable[[float], float],
    limits: tuple[float, float] | None = None,
    size: float = SIZE,
) -> list[Tick]:
    """Return hours of the clock along a line.

    Parameters
    ----------
    clock : Clock
        What turns seconds into times of day.
    begin_s, end_s : float
        Ends of the scale.
    position : callable
        Turns a moment into pixels.
    limits : tuple of float, or None
        Between which labels stand side by side; None for a scale from top to bottom, where they
        stand one below the other.
    size : float
        Of the type.

    Returns
    -------
    list of Tick
        In order.
    """
    most = MOST_HOURS
    if limits is None:
        # Two lines each, and a blank.
        most = max(int(abs(position(end_s) - position(begin_s)) / (2.7 * size)), 1)
    found: list[Tick] = []
    for count in range(most, 0, -1):
        found = _told(clock, hour_ticks(clock, begin_s, end_s, count), position)
        if limits is None:
            break
        found = [_inside(tick, limits, size) for tick in found]
        if _apart(found, size):
            return found
    return found if limits is None else _thinned(found, size)


def number_scale(
    last: float,
    per_unit: float,
    zero: float,
    limits: tuple[float, float],
    unit: str,
    size: float = SIZE,
) -> list[Tick]:
    """Return round numbers along a scale that begins at 0, the last one with its unit.

    Parameters
    ----------
    last : float
        Where the scale ends, in its unit.
    per_unit : float
        Pixels.
    zero : float
        Where it begins, in pixels.
    limits : tuple of float
        Between which labels stand, in pixels.
    unit : str
        Of the numbers.
    size : float
        Of the type.

    Returns
    -------
    list of Tick
        In order, the first of them 0.
    """
    found: list[Tick] = []
    for most in range(6, 0, -1):
        step = round_step(last / most)
        count = int(last / step + 1e-9)
        # Multiples of a tenth have no last digits to show.
        values = [round(k * step, 6) for k in range(count + 1)]
        found = [
            Tick(value, zero + value * per_unit, plain(value) + f" {unit}" * (value == values[-1]))
            for value in values
        ]
        found = [_inside(tick, limits, size) for tick in found]
        if _apart(found, size):
            return found
    return _thinned(found, size)


def plain(value: float) -> str:
    """Return a number of a scale with the decimals it has.

    Parameters
    ----------
    value : float
        A round number.

    Returns
    -------
    str
        In the form of the language.
    """
    return number(value, len(f"{value:g}".partition(".")[2]))


def _told(
    clock: Clock, moments: Sequence[tuple[float, str]], position: Callable[[float], float]
) -> list[Tick]:
    """Return ticks that name a day once, where it begins."""
    found: list[Tick] = []
    today = ""
    for moment, _ in moments:
        # The time itself holds no plain blank; the day and the offset follow after one.
        time, _, rest = clock_time(clock, moment).partition(" ")
        words = rest.split(" UTC")
        day, twice = words[0], "UTC" + words[1] if len(words) > 1 else ""
        if rest.startswith("UTC"):
            day, twice = "", rest
        below = [day] * (day != today) + [twice] * bool(twice)
        shown = clock.moment(moment)
        midnight = shown.hour == shown.minute == 0
        found.append(Tick(moment, position(moment), time, " ".join(filter(None, below)), midnight))
        today = day
    return found


def _width(tick: Tick, size: float) -> float:
    return max((text_width(text, size) for text in tick.texts), default=0.0)


def _inside(tick: Tick, limits: tuple[float, float], size: float) -> Tick:
    half = _width(tick, size) / 2
    low, high = limits[0] + half, limits[1] - half
    place = min(max(tick.place, low), high) if low <= high else sum(limits) / 2
    return Tick(tick.at, place, tick.text, tick.below, tick.strong)


def _apart(ticks: Sequence[Tick], size: float) -> bool:
    return len(_thinned(ticks, size)) == sum(bool(tick.texts) for tick in ticks)


def _thinned(ticks: Sequence[Tick], size: float) -> list[Tick]:
    """Return ticks whose labels are apart, from the first on."""
    kept: list[Tick] = []
    for tick in ticks:
        half = _width(tick, size) / 2
        last = kept[-1].place + _width(kept[-1], size) / 2 + GAP if kept else float("-inf")
        if tick.texts and tick.place - half >= last:
            kept.append(tick)
    return kept
