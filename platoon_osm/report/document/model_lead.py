"""Who leads, where the lead of a plan is handed on: turns in front, and positions on the clock."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["LeadTurn", "PositionMark"]


@dataclass(frozen=True, slots=True)
class LeadTurn:
    """A vehicle in front of others.

    Attributes
    ----------
    vehicle : int
        Its position in the document.
    name : str
        Of the place from where on it leads.
    text, detail : str
        When it begins to lead, and how far to where.
    """

    vehicle: int
    name: str
    text: str
    detail: str


@dataclass(frozen=True, slots=True)
class PositionMark:
    """A position of a vehicle in its platoon, and where on the clock it is shown.

    Attributes
    ----------
    position, size : int
        1 for the leader, and how many they are.
    begin_s, end_s : float
        Of the longest piece that it drives in this position without standing.
    """

    position: int
    size: int
    begin_s: float
    end_s: float
