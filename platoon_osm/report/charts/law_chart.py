"""The law's clocks along each driver's day, as shares of what is allowed, and the most of each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import attrgetter
from typing import NamedTuple

from ..document.model import Document
from ..document.model_law import Clocks, DriverClocks, Law
from ..document.model_vehicle import Vehicle
from ..document.status import law_name
from ..drawing.crowd import CROWD, MOST_SPOKEN
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import clock_span, percent
from .along_chart import ticks_of
from .axes import SIZE, WIDTH, day_scale, letter_type
from .polylines import line_text

__all__ = ["law_chart"]

LEFT, RIGHT = 38.0, WIDTH - 14
ROW, HEIGHT = 44.0, 28.0
"""Of a row, and of what is allowed in it."""

TOP = 8.0
ROOM = 1.25
"""Clocks are drawn up to this share of what is allowed."""

CLOCKS = {"spell": "law.filled", "day": "law.line", "duty": "law.dots"}


def law_chart(document: Document) -> Tree:
    """Return the clocks of all drivers, a row each, and a table of the most of each clock.

    Parameters
    ----------
    document : Document
        Whose drivers are meant.

    Returns
    -------
    Tree
        A section; nothing for a plan without driving rules. A crowd has the table alone.
    """
    law = document.law
    if law is None or document.schedule is None:
        return NOTHING
    vehicles = list(zip(document.vehicles, law.vehicles, strict=True))
    crowd = len(vehicles) > CROWD
    return Piece(
        "law",
        {
            # Where the law is kept, the head of the page says so.
            "rules": NOTHING
            if law.is_kept
            else Piece("law-rules", {"text": say("law.rules", rules=law_name(law.rules))}),
            "chart": NOTHING if crowd else _chart(document, law),
            "density": " compact" if crowd else "",
            "rows": tuple(
                row
                for index, (vehicle, clocks) in enumerate(vehicles)
                for row in _table_rows(index, vehicle, clocks)
            ),
            "note": NOTHING if crowd else Piece("unit-note", {"note": " ".join(_notes(law))}),
        },
    )


def _notes(law: Law) -> Iterator[str]:
    shown = {name for one in law.vehicles for name in CLOCKS if one.allowed[name] is not None}
    yield from (say(key) for name, key in CLOCKS.items() if name in shown)
    yield say("law.scale")
    if law.task_relief:
        yield say("law.relief", share=percent(1 - law.task_relief))


def _chart(document: Document, law: Law) -> Piece:
    schedule = document.schedule
    assert schedule is not None
    begin, end = schedule.begin_s, schedule.end_s
    per_second = (RIGHT - LEFT) / max(end - begin, 1.0)
    zero = LEFT - begin * per_second
    drawn = list(_drawn(document, law))
    bottom = TOP + ROW * len(drawn)
    ticks = day_scale(schedule.clock, begin, end, lambda at: zero + at * per_second, (0.0, WIDTH))
    two = any(tick.below for tick in ticks)
    return Piece(
        "law-chart",
        {
            "height": f"{bottom + SIZE * (1 + two) + 4:g}",
            "bottom": f"{bottom:g}",
            "zero": LEFT,
            "end": f"{RIGHT:g}",
            "from": begin,
            "per_second": f"{per_second:.9g}",
            "ticks": tuple(ticks_of(ticks, zero, per_second, TOP - 4, bottom)),
            "rows": tuple(
                _row(one, zero, per_second, TOP + ROW * place) for place, one in enumerate(drawn)
            ),
            "title": say("law.title", who="; ".join(map(_told, drawn[:MOST_SPOKEN]))),
        },
    )


class _Drawn(NamedTuple):
    """A driver, of two by its number."""

    place: int
    vehicle: Vehicle
    clocks: DriverClocks
    number: str


def _drawn(document: Document, law: Law) -> Iterator[_Drawn]:
    for index, (vehicle, own) in enumerate(zip(document.vehicles, law.vehicles, strict=True)):
        for number, clocks in enumerate(own.each, 1):
            yield _Drawn(index, vehicle, clocks, str(number) if len(own.each) > 1 else "")


def _told(one: _Drawn) -> str:
    clocks, letter = one.clocks, one.vehicle.letter
    return say(
        "law.row",
        vehicle=f"{letter}, {say('law.driver', number=one.number)}:" if one.number else letter,
        spell=clock_span(clocks.spell_s),
        day=clock_span(clocks.day_s),
        duty=clock_span(clocks.duty_s),
    )


def _row(one: _Drawn, zero: float, per_second: float, y: float) -> Piece:
    index, vehicle, clocks, number = one
    base = ROW - 8.0

    def path(values: Sequence[float]) -> str:
        found: list[tuple[float, float]] = []
        for point, value in zip(clocks.points, values, strict=True):
            found.append((zero + point.at_s * per_second, base - min(value, ROOM) * HEIGHT))
        return line_text(found)

    lines = {name: path(list(map(attrgetter(name), clocks.points))) for name in CLOCKS}
    drawn: dict[str, Tree] = {
        name: Piece(f"law-{name}", {"points": lines[name]}) if clocks.allowed[name] else NOTHING
        for name in ("day", "duty")
    }
    spell = lines["spell"]
    first, last = spell.split(" ")[0], spell.rsplit(" ", 1)[-1]
    return Piece(
        "law-row",
        {
            "y": f"{y:g}",
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "driver": Piece("law-driver", {"number": number}) if number else NOTHING,
            "base": f"{base:g}",
            "most": f"{base - HEIGHT:g}",
            "left": f"{LEFT:g}",
            "right": f"{RIGHT:g}",
            "spell": f"{first.split(',')[0]},{base:g} {spell} {last.split(',')[0]},{base:g}",
            **drawn,
            "beyond": tuple(
                Piece("law-beyond", {"x": f"{zero + one.at_s * per_second:.1f}"})
                for one in clocks.excess
            ),
        },
    )


def _table_rows(index: int, vehicle: Vehicle, clocks: Clocks) -> Iterator[Piece]:
    """Yield a row for each driver; what the vehicle does stands in the first."""
    stood = []
    if clocks.breaks_s:
        stood.append(say("law.breaks", time=_in_one(clocks.breaks_s)))
    if clocks.rests_s:
        stood.append(say("law.rests", time=_in_one(clocks.rests_s)))
    if clocks.drivers > 1 and len(clocks.each) < 2:
        stood.append(say("law.two-drivers"))
    for number, own in enumerate(clocks.each, 1):
        facts = [say("law.driving", time=_in_one(own.driving_s))]
        if len(clocks.each) > 1:
            facts.insert(0, say("law.driver", number=number))
        yield _table_row(index, vehicle, own, [*facts, *stood])
        stood = []


def _in_one(seconds: float) -> str:
    """Return a time span that no line breaks within."""
    return clock_span(seconds).replace(" ", "\u00a0")


def _table_row(index: int, vehicle: Vehicle, clocks: DriverClocks, facts: Sequence[str]) -> Piece:
    cells = {}
    for name in CLOCKS:
        allowed = clocks.allowed[name]
        beyond = any(one.clock == name for one in clocks.excess)
        cells[name] = Piece(
            "law-cell",
            {
                "sign": " loss" if beyond else "",
                "counted": clock_span(clocks.most(name)),
                "allowed": "" if allowed is None else say("law.of", time=clock_span(allowed)),
            },
        )
    return Piece(
        "law-table-row",
        {
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "letter_size": vehicle.letter_size,
            "name": vehicle.called,
            "facts": ", ".join(facts),
            **cells,
        },
    )
