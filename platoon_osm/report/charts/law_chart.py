"""The law's clocks along each vehicle's day, as shares of what is allowed, and the most of each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import attrgetter

from ..document.model import Document
from ..document.model_law import Clocks, Law
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
    """Return the clocks of all vehicles, a row each, and a table of the most of each clock.

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
                _table_row(index, vehicle, clocks)
                for index, (vehicle, clocks) in enumerate(vehicles)
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
    bottom = TOP + ROW * len(law.vehicles)
    ticks = day_scale(schedule.clock, begin, end, lambda at: zero + at * per_second, (0.0, WIDTH))
    two = any(tick.below for tick in ticks)
    named = list(zip(document.vehicles, law.vehicles, strict=True))
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
                _row(index, vehicle, clocks, zero, per_second, TOP + ROW * index)
                for index, (vehicle, clocks) in enumerate(named)
            ),
            "title": say("law.title", who="; ".join(_told(*one) for one in named[:MOST_SPOKEN])),
        },
    )


def _told(vehicle: Vehicle, clocks: Clocks) -> str:
    return say(
        "law.row",
        vehicle=vehicle.letter,
        spell=clock_span(clocks.spell_s),
        day=clock_span(clocks.day_s),
        duty=clock_span(clocks.duty_s),
    )


def _row(
    index: int, vehicle: Vehicle, clocks: Clocks, zero: float, per_second: float, y: float
) -> Piece:
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


def _table_row(index: int, vehicle: Vehicle, clocks: Clocks) -> Piece:
    facts = [say("law.driving", time=clock_span(clocks.driving_s))]
    if clocks.breaks_s:
        facts.append(say("law.breaks", time=clock_span(clocks.breaks_s)))
    if clocks.rests_s:
        facts.append(say("law.rests", time=clock_span(clocks.rests_s)))
    if clocks.drivers > 1:
        facts.append(say("law.two-drivers"))
    cells = {}
    for name, counted in zip(CLOCKS, (clocks.spell_s, clocks.day_s, clocks.duty_s), strict=True):
        allowed = clocks.allowed[name]
        beyond = any(one.clock == name for one in clocks.excess)
        cells[name] = Piece(
            "law-cell",
            {
                "sign": " loss" if beyond else "",
                "counted": clock_span(counted),
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
