"""Who gets what a plan saves: what each saves by itself, what it is to have, and what is paid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

__all__ = ["GainShare", "GainSharing"]


@dataclass(frozen=True, slots=True)
class GainShare:
    """One vehicle's part of the gain.

    Attributes
    ----------
    saved_cents : int
        What it saves as planned, before anything is paid.
    share_cents : int
        What it is to have of the gain.
    """

    saved_cents: int
    share_cents: int

    @property
    def payment_cents(self) -> int:
        """What it receives from the others; below 0 if it pays."""
        return self.share_cents - self.saved_cents


@dataclass(frozen=True, slots=True)
class GainSharing:
    """How a plan's gain is shared, and that everybody can say yes.

    Attributes
    ----------
    rule : str
        "equal": equal parts of the leader's loss; "shapley"; "least-core".
    currency : str
        ISO 4217 code.
    vehicles : tuple of GainShare, (N,)
        In the order of the plan's trips; payments sum to 0.
    coalitions : int
        How many groups of vehicles were asked what they could gain by themselves.
    worst_cents : float or None
        The most that any of them could gain beyond its shares; 0 or less if none has a reason to
        leave. Where many vehicles are linked, a bound for all groups, none being asked one by one.
        None if it was not worked out.
    manner : str
        How their gains were worked out: "planned anew" or "on the planned roads".
    remark : str
        What else a reader should know; empty if nothing.
    """

    rule: str
    currency: str
    vehicles: tuple[GainShare, ...]
    coalitions: int = 0
    worst_cents: float | None = None
    manner: str = ""
    remark: str = ""

    @property
    def is_told(self) -> bool:
        """Whether there is anything to tell: somebody saves, or is to have, something."""
        return any(one.saved_cents or one.share_cents for one in self.vehicles)

    @property
    def gain_cents(self) -> int:
        """What there is to share."""
        return sum(one.share_cents for one in self.vehicles)

    @property
    def nobody_is_worse_off(self) -> bool:
        """Whether everybody has 0 or more."""
        return all(one.share_cents >= 0 for one in self.vehicles)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> GainSharing:
        """Rebuild it from plain JSON types.

        Parameters
        ----------
        data : mapping
            Its fields by name.

        Returns
        -------
        GainSharing
            The same.
        """
        return cls(**{**data, "vehicles": tuple(GainShare(**one) for one in data["vehicles"])})
