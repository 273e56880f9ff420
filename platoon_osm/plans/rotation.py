"""How the lead is handed on in a plan: where, from whom to whom, and how even it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .records import PlatoonPoint

__all__ = ["LeadChange", "Rotation"]


@dataclass(frozen=True, slots=True)
class LeadChange:
    """A place where one vehicle of a company takes the lead from another.

    Attributes
    ----------
    stretch : int
        The stretch that begins with it; its first vehicle takes the lead.
    former : int
        The vehicle that led until there and falls back, position in the plan.
    point : PlatoonPoint
        Where; its `km` counts on the way of the one that takes the lead.
    """

    stretch: int
    former: int
    point: PlatoonPoint


@dataclass(frozen=True, slots=True)
class Rotation:
    """The lead of a plan, handed on so that each vehicle leads its fair share.

    Attributes
    ----------
    least_m : float
        Nobody leads less than this before it hands on the lead [m].
    changes : tuple of LeadChange
        In the order of their stretches.
    fair_m, led_m : tuple of float, (N,)
        How much each vehicle would lead if all stretches were shared evenly by those who drive
        them, and how much it leads [m].
    spared : tuple of int
        Vehicles that lead less than their share, for otherwise they would pay more than alone.
    """

    least_m: float
    changes: tuple[LeadChange, ...]
    fair_m: tuple[float, ...]
    led_m: tuple[float, ...]
    spared: tuple[int, ...] = ()

    @property
    def worst_m(self) -> float:
        """The greatest difference between what a vehicle leads and its fair share [m]."""
        pairs = zip(self.fair_m, self.led_m, strict=True)
        return max((abs(fair - led) for fair, led in pairs), default=0.0)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Rotation:
        """Rebuild a rotation from plain JSON types.

        Parameters
        ----------
        data : mapping
            As `dataclasses.asdict` gives it.

        Returns
        -------
        Rotation
            The same.
        """
        changes = (
            LeadChange(**{**item, "point": PlatoonPoint(**item["point"])})
            for item in data["changes"]
        )
        return cls(
            data["least_m"], tuple(changes), tuple(data["fair_m"]), tuple(data["led_m"]),
            tuple(data["spared"]),
        )  # fmt: skip
