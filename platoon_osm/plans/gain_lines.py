"""Who gets what a plan saves as text: shares, payments, and why all can say yes."""

from __future__ import annotations

from math import ceil

from .gain import GainShare, GainSharing
from .money_text import money
from .plan import Plan
from .text_table import named

__all__ = ["gain_lines"]

RULES = {
    "equal": "equal parts of the leader's loss",
    "shapley": "the Shapley value",
    "least-core": "the least core",
}


def gain_lines(plan: Plan) -> list[str]:
    """Return who has what of the gain, and what groups could gain by themselves.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of str
        Empty where nothing is shared.
    """
    gain = plan.gain
    if gain is None or not gain.is_told:
        return []
    shares = ", ".join(
        f"{named(trip.vehicle)} {_share(one, gain.currency)}"
        for trip, one in zip(plan.trips, gain.vehicles, strict=True)
    )
    lines = [f"Of the gain have, by {RULES.get(gain.rule, gain.rule)}: {shares}."]
    lines += _asked(gain)
    if gain.remark:
        lines.append(f"Of the shares: {gain.remark}.")
    return lines


def _share(one: GainShare, currency: str) -> str:
    paid = one.payment_cents
    told = money(one.share_cents, currency)
    if paid == 0:
        return told
    return f"{told} ({'receives' if paid > 0 else 'pays'} {abs(paid) / 100:,.2f})"


def _asked(gain: GainSharing) -> list[str]:
    """Return whether anybody is worse off, and what groups could gain."""
    content = gain.nobody_is_worse_off
    worse = "Nobody is worse off than alone" if content else "Somebody is worse off than alone"
    if gain.worst_cents is None:
        return [f"{worse}."]
    groups = "no group" if not gain.coalitions else f"none of {gain.coalitions:,} groups"
    if gain.worst_cents < 1:
        could = "could gain a cent by itself"
    else:
        could = f"could gain more than {money(ceil(gain.worst_cents), gain.currency)} by itself"
    return [f"{worse}{', and ' if content else '; '}{groups} {could} ({gain.manner})."]
