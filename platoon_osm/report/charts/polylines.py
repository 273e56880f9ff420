"""Points of a chart's line as text, without those that add nothing."""

from __future__ import annotations

from collections.abc import Iterable

from ..drawing.lines import Point

__all__ = ["line_text"]

NEAR = 0.25
"""A point this near to the straight line between its neighbours adds nothing, in pixels."""


def line_text(points: Iterable[Point]) -> str:
    """Return a line as the points of a polyline.

    Parameters
    ----------
    points : iterable of tuple of float
        In pixels, from left to right.

    Returns
    -------
    str
        To a tenth of a pixel, those left out that lie between two others.
    """
    kept: list[Point] = []
    between: list[Point] = []
    for point in points:
        if len(kept) and between and not all(_is_near(kept[-1], one, point) for one in between):
            kept.append(between[-1])
            between = []
        if kept:
            between.append(point)
        else:
            kept.append(point)
    kept += between[-1:]
    return " ".join(f"{round(x, 1):g},{round(y, 1):g}" for x, y in kept)


def _is_near(a: Point, b: Point, c: Point) -> bool:
    """Return whether `b` lies near the straight line from `a` to `c`, and between them."""
    along = c[0] - a[0], c[1] - a[1]
    length = (along[0] ** 2 + along[1] ** 2) ** 0.5
    if length < NEAR:
        return abs(b[0] - a[0]) < NEAR and abs(b[1] - a[1]) < NEAR
    across = along[0] * (b[1] - a[1]) - along[1] * (b[0] - a[0])
    ahead = (b[0] - a[0]) * along[0] + (b[1] - a[1]) * along[1]
    return bool(abs(across) / length < NEAR and 0 <= ahead <= length * length)
