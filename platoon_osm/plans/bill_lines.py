"""The bill of a plan as text: what is paid for, what is saved of it, fuel and CO2e."""

from __future__ import annotations

from .bill import Bill
from .plan import Plan
from .text_table import named

__all__ = ["bill_lines", "money"]

NAMES = {
    "fuel": "fuel",
    "driver": "driver",
    "toll": "toll",
    "co2": "CO2",
    "waiting": "waiting",
    "delay": "delay",
}


def money(cents: int, currency: str) -> str:
    """Return an amount with its currency.

    Parameters
    ----------
    cents : int
        The amount.
    currency : str
        ISO 4217 code.

    Returns
    -------
    str
        As "1,234.50 EUR".
    """
    return f"{cents / 100:,.2f} {currency}"


def bill_lines(plan: Plan) -> list[str]:
    """Return what a plan costs and saves in money.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of str
        Empty where costs are no money.
    """
    bill = plan.bill
    if bill is None:
        return []
    lines = [_terms(bill), _saved(bill)]
    if plan.gain is not None:
        shares = ", ".join(
            f"{named(trip.vehicle)} {money(one.share_cents, bill.currency)}"
            for trip, one in zip(plan.trips, plan.gain.vehicles, strict=True)
        )
        lines.append(f"Of the gain have: {shares}.")
    return lines


def _terms(bill: Bill) -> str:
    told = []
    for term in bill.terms:
        alone, joint = bill.of_term(term)
        if alone or joint:
            told.append(f"{NAMES.get(term, term)} {joint / 100:,.2f} (alone {alone / 100:,.2f})")
    return f"Paid for [{bill.currency}]: {', '.join(told)}."


def _saved(bill: Bill) -> str:
    to_wheel, from_well = bill.saved_kg
    return (
        f"Saved: {money(bill.saved_cents, bill.currency)}, {bill.saved_fuel_l:,.1f} l of fuel, "
        f"{from_well:,.0f} kg CO2e well to wheel ({to_wheel:,.0f} kg tank to wheel)."
    )
