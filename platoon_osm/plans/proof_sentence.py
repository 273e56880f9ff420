"""What is proved about a plan, and for what, in a sentence that can be read aloud."""

from __future__ import annotations

from ..shown_text import fitted
from .plan import Plan
from .proof import NOTHING_LEFT

__all__ = ["proof_sentence"]


def proof_sentence(plan: Plan) -> str:
    """Return how good a plan is known to be, and under which conditions.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    str
        Never that it is optimal without saying for what.
    """
    proof = plan.proof
    conditions = fitted("; ".join(proof.conditions))
    if proof.kind == "exact":
        return f"Proved optimal for: {conditions or 'these trips'}.{_beyond(plan)}"
    if proof.kind == "bound":
        saved = 1 - (proof.bound or 0.0) / plan.solo_cost if plan.solo_cost else 0.0
        return (
            f"At most {proof.gap or 0.0:.1%} dearer than the best there can be, which saves no "
            f"more than {saved:.1%} ({conditions})."
        )
    excess = proof.excess or 0.0
    side = "above" if excess >= 0 else "below"
    return (
        f"Found by the paper's inflated A*: {abs(excess):.2%} {side} the optimum ({conditions}); "
        f"its routes alone cost {proof.solo_excess or 0.0:.2%} above the least."
    )


def _beyond(plan: Plan) -> str:
    """Return what other routes and companies could save at most, where that is more."""
    least = plan.proof.any_plan
    if (
        least is None
        or not plan.solo_cost
        or plan.proof.cost - least <= (NOTHING_LEFT * plan.proof.cost)
    ):
        return ""
    return (
        f" Any other routes and company for these trips save at most "
        f"{1 - least / plan.solo_cost:.1%}."
    )
