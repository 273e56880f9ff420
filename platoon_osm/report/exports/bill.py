"""The bill of a plan as CSV: what each vehicle pays for what, burns and emits."""

from __future__ import annotations

import os
from collections.abc import Iterator

from ...csv_tables import write_table
from ...errors import ScenarioError
from ...plans.bill import CENTS
from ...plans.money_frames import bill_rows, physical_rows
from ...plans.plan import Plan
from ..document.checks import check_is_plan, check_path

__all__ = ["write_bill"]

COLUMNS = ("vehicle", "term", "unit", "alone", "joint", "saved")

DIGITS = 12
"""Enough for each amount to the cent."""


def write_bill(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Write what each vehicle pays for each term, and its fuel and CO2e, as CSV in UTF-8.

    One row for each; where a spreadsheet would run a text as a formula, it gets an apostrophe.

    Parameters
    ----------
    plan : Plan
        With costs in money.
    path : path-like
        Of the file; missing folders are made.

    Raises
    ------
    ScenarioError
        No plan, a plan without a bill, or a file that cannot be written.
    """
    check_is_plan(plan)
    path = check_path(path)
    if plan.bill is None:
        raise ScenarioError(
            "bill: the costs of the plan are no money; plan with --objective eu, or "
            'money_costs("eu")'
        )
    write_table(path, COLUMNS, _rows(plan, plan.bill.currency), DIGITS)


def _rows(plan: Plan, currency: str) -> Iterator[tuple[object, ...]]:
    for vehicle, term, alone, joint in bill_rows(plan):
        yield vehicle, term, currency, alone / CENTS, joint / CENTS, (alone - joint) / CENTS
    for vehicle, what, unit, before, after in physical_rows(plan):
        yield vehicle, what, unit, *(round(one, 3) for one in (before, after, before - after))
