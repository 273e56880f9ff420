"""What one plan has otherwise than another, one thing at a time and in words."""

from __future__ import annotations

from dataclasses import dataclass

from .text_table import named

__all__ = ["Change"]

WIDEST = 80
"""Columns that a list of names may take."""


@dataclass(frozen=True, slots=True)
class Change:
    """What is otherwise than in the plan as asked.

    Attributes
    ----------
    kind : {"leads", "lead", "joins", "alone", "company", "merge", "separation", "road", "leaves"}
        "leads", "lead": it, or several, leads instead of `before`. "joins": it drives with `now`
        and drove alone. "alone": it drives alone and did not. "company": it drives with `now`
        instead of `before`. "merge", "separation": it does so at `now` instead of `before`. "road":
        it takes another road. "leaves": it leaves at `now` instead of `before`.
    vehicle : str
        Its name.
    now, before : str
        Names, or times of day; empty where the kind needs none.
    """

    kind: str
    vehicle: str
    now: str = ""
    before: str = ""

    @property
    def text(self) -> str:
        """What is otherwise, such as "B merges at Brescia Est instead of Bergamo"."""
        who, now, before = (named(one, WIDEST) for one in (self.vehicle, self.now, self.before))
        instead = f" instead of {before}" if before else ""
        return {
            "leads": f"{who} leads{instead}",
            "lead": f"{who} lead{instead}",
            "joins": f"{who} drives with {now}",
            "alone": f"{who} stays alone",
            "company": f"{who} drives with {now}{instead}",
            "merge": f"{who} merges at {now}{instead}",
            "separation": f"{who} separates at {now}{instead}",
            "road": f"{who} takes another road",
            "leaves": f"{who} leaves at {now}{instead}",
        }[self.kind]
