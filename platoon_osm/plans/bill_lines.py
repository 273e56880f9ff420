"""The bill of a plan as text: what is paid for, what is saved of it, fuel and CO2e."""

from __future__ import annotations

from .bill import Bill
from .gain_lines import gain_lines
from .money_text import money
from .plan import Plan

__all__ = ["bill_lines"]

NAMES = {"co2": "CO2"}
"""Terms that people write otherwise."""


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
    return [_terms(bill), _saved(bill), *gain_lines(plan)]


def _terms(bill: Bill) -> str:
    told = []
    for term in bill.terms:
        alone, joint = bill.of_term(term)
        if alone or joint:
            told.append(f"{NAMES.get(term, term)} {joint / 100:,.2f} (alone {alone / 100:,.2f})")
    return f"Paid for [{bill.currency}]: {', '.join(told)}."


def _saved(bill: Bill) -> str:
    # The last digits of sums of the same roads are nothing saved.
    to_wheel, from_well = (round(mass, 0) + 0.0 for mass in bill.saved_kg)
    litres = round(bill.saved_fuel_l, 1) + 0.0
    return (
        f"Saved: {money(bill.saved_cents, bill.currency)}, {litres:,.1f} l of fuel, "
        f"{from_well:,.0f} kg CO2e well to wheel ({to_wheel:,.0f} kg tank to wheel)."
    )
