"""Who works until which share of a search's course: the bound, the plan, or the exact model."""

from __future__ import annotations

__all__ = ["COURSE", "CROWD", "CROWDED_COURSE", "Phases", "phases_of"]

Phases = tuple[tuple[str, float], ...]

COURSE = (
    ("bound", 0.05), ("construct", 0.05), ("bound", 0.15), ("construct", 0.15), ("exact", 0.40),
    ("bound", 0.40), ("construct", 0.40), ("plan", 0.66), ("bound", 0.77), ("plan", 1.0),
)  # fmt: skip
"""Who works until which share of the course."""

CROWDED_COURSE = (
    ("bound", 0.34), ("construct", 0.34), ("plan", 0.68), ("bound", 0.79), ("plan", 1.0),
)  # fmt: skip
"""The same from `CROWD` trucks on, where the first construction is worth waiting for."""

CROWD = 10_000
"""So many trucks are a crowd."""


def phases_of(trucks: int) -> Phases:
    """Return who works until which share of the course.

    Parameters
    ----------
    trucks : int
        How many there are.

    Returns
    -------
    tuple of (str, float)
        One after the other.
    """
    return CROWDED_COURSE if trucks >= CROWD else COURSE
