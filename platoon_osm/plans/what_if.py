"""What if a figure were another: plans made anew for each of its values, and what that is worth.

Every row is a plan of its own. Beside it stands what the plan as asked, the kept plan, would cost
at that value: less what the new plan costs, that is what planning anew is worth. It is below 0
where the kept plan costs less in all, as it may where each member pays least itself; never by more
than the new plan's own distance from what no plan undercuts.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from .plan import Plan
from .plan_change import Change
from .proof import Proof
from .row_table import Row, RowTable

__all__ = ["Threshold", "Value", "WhatIf", "WhatIfRow", "WhatIfs"]

Value = float | str


@dataclass(frozen=True, slots=True)
class WhatIfRow:
    """The plan for one value of a figure.

    Attributes
    ----------
    value : float or str
        Of the figure.
    alone, joint : float
        What all pay alone and as planned, in the unit of the study.
    most_saved : float or None
        No plan under the conditions of the proof saves more; None if nothing is proved.
    platoon_m : float
        Length driven in company, that of each vehicle counted [m].
    saved_l : float
        Fuel saved [l].
    saved_kg : tuple of float, (2,), or None
        CO2e saved, tank to wheel and well to wheel [kg]; None where costs are no money.
    leads : tuple of str
        Who leads anywhere.
    company : tuple of str
        Who drives in company anywhere, in the order of the trips.
    changes : tuple of Change
        Against the plan as asked; empty if it is the same.
    kept : float or None
        What the plan as asked would cost; None if it may not be driven.
    kept_note : str
        Why it may not be.
    proof : Proof
        Of the plan.
    """

    value: Value
    alone: float
    joint: float
    most_saved: float | None
    platoon_m: float
    saved_l: float
    saved_kg: tuple[float, float] | None
    leads: tuple[str, ...]
    company: tuple[str, ...]
    changes: tuple[Change, ...]
    kept: float | None
    kept_note: str
    proof: Proof

    @property
    def saved(self) -> float:
        """What the plan saves, in the unit of the study."""
        return self.alone - self.joint

    @property
    def saved_share(self) -> float:
        """What it saves as a share of what all pay alone."""
        return self.saved / self.alone if self.alone else 0.0

    @property
    def worth(self) -> float | None:
        """What planning anew is worth: what the kept plan costs, less the new one."""
        return None if self.kept is None else self.kept - self.joint


@dataclass(frozen=True, slots=True)
class Threshold:
    """Where company begins, or ends, to pay as a figure rises.

    Attributes
    ----------
    below, above : float
        Two values, `below` the lesser: at one of them the plan has company, at the other not.
    from_above : bool
        Whether company pays at `above`, not at `below`.
    is_proved : bool
        Whether it is proved that company pays at all values asked from there on, and under the
        conditions of the proofs at none before.
    """

    below: float
    above: float
    from_above: bool
    is_proved: bool

    @property
    def pays_at(self) -> float:
        """The value of both at which company pays."""
        return self.above if self.from_above else self.below


@dataclass(frozen=True, slots=True, repr=False)
class WhatIf(RowTable):
    """Plans made anew for values of one figure.

    Attributes
    ----------
    figure : str
        Its name, that of a parameter of the objective, or "task_relief".
    figure_unit : str
        Of its values; empty if they have none.
    asked : float or str
        Its value in the problem.
    plan : Plan
        The plan as asked.
    values : tuple of WhatIfRow
        One a value, in the order asked for.
    threshold : Threshold or None
        Where company begins to pay; None where all rows agree, or values are names.
    """

    figure: str
    figure_unit: str
    asked: Value
    plan: Plan
    values: tuple[WhatIfRow, ...]
    threshold: Threshold | None = None

    @property
    def unit(self) -> str:
        """Of all costs: that of the plans."""
        return self.plan.unit

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        return f"<WhatIf of {self.figure}: {len(self):,} values, as asked {self.asked}>"

    def rows(self) -> Iterator[Row]:
        """Yield what is known of each value.

        Yields
        ------
        dict
            Numbers by columns with their unit; who leads and who drives in company with semicolons
            between names.
        """
        unit = "m_eq" if self.unit == "m" else self.unit
        for row in self.values:
            kg = row.saved_kg or ("", "")
            yield {
                "figure": self.figure,
                "value": row.value,
                "figure_unit": self.figure_unit,
                f"alone_{unit}": row.alone,
                f"planned_{unit}": row.joint,
                f"saved_{unit}": row.saved,
                "saved_share": row.saved_share,
                f"most_saved_{unit}": "" if row.most_saved is None else row.most_saved,
                "platoon_km": row.platoon_m / 1000,
                "saved_l": row.saved_l,
                "saved_to_wheel_kg": kg[0],
                "saved_from_well_kg": kg[1],
                "leads": "; ".join(row.leads),
                "company": "; ".join(row.company),
                "changes": "; ".join(one.text for one in row.changes),
                f"kept_plan_{unit}": "" if row.kept is None else row.kept,
                f"worth_{unit}": "" if row.worth is None else row.worth,
                "proof": row.proof.kind,
                "gap_share": "" if row.proof.gap is None else row.proof.gap,
            }


@dataclass(frozen=True, slots=True)
class WhatIfs(RowTable):
    """Several figures, each varied by itself.

    Attributes
    ----------
    studies : tuple of WhatIf
        Of one problem.
    """

    studies: tuple[WhatIf, ...]

    def rows(self) -> Iterator[Row]:
        """Yield what is known of each value of each figure.

        Yields
        ------
        dict
            As `WhatIf.rows`.
        """
        for one in self.studies:
            yield from one.rows()
