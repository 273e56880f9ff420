"""The journey of one vehicle as a strip: how far alone and in company, and where that changes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..document.model_vehicle import Vehicle
from ..language.speech import say
from ..maps.map_texts import clipped, text_width
from ..maps.pause_icons import PAUSE_KINDS
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import kilometres
from .steps import Step
from .words import StepWords

__all__ = ["strip"]

WIDTH, SIDE = 720.0, 13.0
TIME_SIZE, NAME_SIZE = 12.0, 11.0
NAME_ROWS = (69.0, 83.0)
WIDEST_NAME = 150.0

Free = list[tuple[float, float]]


def strip(vehicle: Vehicle, steps: Sequence[Step], words: Sequence[StepWords], key: str) -> Piece:
    """Return the strip of a journey, by distance.

    Parameters
    ----------
    vehicle : Vehicle
        Whose journey it is.
    steps : sequence of Step
        Of it.
    words : sequence of StepWords
        The same in words.
    key : str
        Parts its names from those of other strips on a page.

    Returns
    -------
    Piece
        One SVG.
    """
    total = steps[-1].at_m or 1.0
    xs = [SIDE + (WIDTH - 2 * SIDE) * step.at_m / total for step in steps]
    return Piece(
        "sheet-strip",
        {
            "key": key,
            "label": say("sheet.strip", km=kilometres(total)),
            "parts": tuple(_parts(vehicle, steps, xs)),
            "marks": tuple(_marks(vehicle, words, xs)),
            "times": tuple(_texts([one.time for one in words], xs, (16.0,), TIME_SIZE, True)),
            "names": tuple(_texts([one.place for one in words], xs, NAME_ROWS, NAME_SIZE)),
        },
    )


def _parts(vehicle: Vehicle, steps: Sequence[Step], xs: Sequence[float]) -> Iterator[Piece]:
    for step, x, after in zip(steps, xs, xs[1:], strict=False):
        way = step.way
        if way is None:
            continue
        together = way.together
        yield Piece(
            "sheet-band" if together else "sheet-alone",
            {
                "x": f"{x:.1f}",
                "x2": f"{after:.1f}",
                "width": f"{after - x:.1f}",
                "colour": vehicle.colour,
                "dash": "0.1 6" if way.is_access else "none",
                "cap": "round" if way.is_access else "butt",
                **_count(len(way.order), x, after),
            },
        )


def _count(company: int, x: float, after: float) -> dict[str, Tree | str]:
    """Return the number of vehicles above a band, where it finds room."""
    text = say("sheet.company", n=company)
    if company < 2 or text_width(text, NAME_SIZE) > after - x - 26:
        return {"count": NOTHING}
    return {"count": Piece("sheet-count", {"x": f"{(x + after) / 2:.1f}", "text": text})}


def _marks(vehicle: Vehicle, words: Sequence[StepWords], xs: Sequence[float]) -> Iterator[Piece]:
    # Ends on top: where all is near together, they are what matters.
    order = sorted(range(len(words)), key=lambda k: words[k].kind in ("start", "end"))
    for k in order:
        kind = words[k].kind
        if kind == "road":
            continue
        ends = {"colour": vehicle.colour, "letter": vehicle.letter, "size": vehicle.letter_size}
        if kind in ("merge", "separation", *PAUSE_KINDS):
            yield Piece("sheet-strip-event", {"x": f"{xs[k]:.1f}", "icon": kind})
        else:
            yield Piece(f"sheet-strip-{kind}", {"x": f"{xs[k]:.1f}", **ends})


def _texts(
    texts: Sequence[str],
    xs: Sequence[float],
    rows: Sequence[float],
    size: float,
    bold: bool = False,
) -> Iterator[Piece]:
    """Yield texts under or over their marks, those of the ends first; none covers another."""
    taken: dict[float, Free] = {row: [] for row in rows}
    order = [0, len(texts) - 1, *range(1, len(texts) - 1)]
    for k in order:
        text = clipped(texts[k], size, bold, WIDEST_NAME)
        if not text:
            continue
        width = text_width(text, size, bold)
        left = min(max(xs[k] - width / 2, 0.0), WIDTH - width)
        for row in rows:
            if all(left > b + 8 or left + width < a - 8 for a, b in taken[row]):
                taken[row].append((left, left + width))
                anchor = "start" if k == 0 else "end" if k == len(texts) - 1 else "middle"
                x = {"start": 0.0, "end": WIDTH, "middle": left + width / 2}[anchor]
                yield Piece(
                    "sheet-label",
                    {
                        "x": f"{x:.1f}", "y": f"{row:g}", "anchor": anchor, "size": f"{size:g}",
                        "weight": "700" if bold else "400", "text": text,
                    },
                )  # fmt: skip
                break
