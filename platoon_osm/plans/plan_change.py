"""What one plan has otherwise than another, one thing at a time and in words."""

from __future__ import annotations

from dataclasses import dataclass

from .text_table import listed, named

__all__ = ["Change"]


@dataclass(frozen=True, slots=True)
class Change:
    """What is otherwise than in the plan as asked.

    Attributes
    ----------
    kind : {"leads", "joins", "alone", "company", "merge", "separation", "road", "leaves"}
        "leads": `now` lead instead of `before`. "joins": it drives with `now` and drove alone.
        "alone": it drives alone and did not. "company": it drives with `now` instead of `before`.
        "merge", "separation": it does so at `now` instead of `before`. "road": it takes another
        road. "leaves": it leaves at `now` instead of `before`.
    vehicle : str
        Its name; empty for "leads".
    now, before : tuple of str
        Names of vehicles, or of a place, or a time of day; empty where the kind needs none.
    """

    kind: str
    vehicle: str
    now: tuple[str, ...] = ()
    before: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """What is otherwise, such as "B merges at Brescia Est instead of Bergamo"."""
        who, now, before = named(self.vehicle), listed(self.now), listed(self.before)
        instead = f" instead of {before}" if before else ""
        return {
            "leads": f"{now} lead{'s' if len(self.now) == 1 else ''}{instead}",
            "joins": f"{who} drives with {now}",
            "alone": f"{who} stays alone",
            "company": f"{who} drives with {now}{instead}",
            "merge": f"{who} merges at {now}{instead}",
            "separation": f"{who} separates at {now}{instead}",
            "road": f"{who} takes another road",
            "leaves": f"{who} leaves at {now}{instead}",
        }[self.kind]
