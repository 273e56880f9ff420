"""`platoon-osm certify`: a fleet's plan and the bound on it, worked out anew."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..exit_status import UNMET, tell
from ..options import FILE

if TYPE_CHECKING:
    from ...inspection.certificate.belief import Belief

__all__ = ["verb"]


@click.command(
    "certify",
    short_help="check what is claimed of a fleet's plan",
    epilog="""\b
Example:
  platoon-osm certify fleet.json
""",
)
@click.argument("fleet", type=FILE)
def verb(fleet: Path) -> None:
    """Work out saving and bound of FLEET anew, a file that `platoon-osm fleet` wrote.

    Whole numbers are all it uses, and nothing of the planner's code; docs/certificate.md tells the
    mathematics. Prints what is believed, and ends with 1 if something in the file is not so.
    """
    from ...inspection.certificate.belief import certify
    from ...inspection.certificate.faults import FaultError

    try:
        belief, plan = certify(fleet)
    except FaultError as fault:
        tell(f"{fleet}: refused: {fault}")
        raise click.exceptions.Exit(UNMET) from None
    for line in _lines(belief, plan.unit):
        click.echo(line)
    if plan.fleet is not None and plan.fleet.exact_bound is not None:
        most = f"{plan.fleet.exact_bound:,.2f} {plan.unit}"
        click.echo(f"not looked at: by the exact model's solver no plan saves more than {most}")


def _lines(belief: Belief, unit: str) -> list[str]:
    alone = belief.alone * belief.grain
    rows = [
        ("alone", _figure(alone, unit)),
        ("saved", f"{_figure(belief.saving, unit)}, {_share(belief.saving, alone)}"),
        ("at most", f"{_figure(belief.bound, unit)}, {_share(belief.bound, alone)}"),
        ("gap", f"{belief.gap:.3%} of what could be saved at most"),
    ]
    trucks = "1 truck" if belief.trucks == 1 else f"{belief.trucks:,} trucks"
    lines = [
        f"believed, of {trucks}: {belief.pairs:,} pairs of a truck and a lane, "
        f"{belief.shares:,} shares",
        *(f"  {name:8} {figure}" for name, figure in rows),
        "proved for: " + "; ".join(belief.conditions),
    ]
    if belief.dearer:
        less = _figure(belief.dearer * belief.grain, unit)
        lines.append(f"ways alone are not the cheapest in time: they could cost {less} less")
    lines.append("taken as told: lanes, what they cost and take, and what trips ask for")
    return lines


def _figure(value: Decimal, unit: str) -> str:
    return f"{value:,.2f} {unit}"


def _share(part: Decimal, whole: Decimal) -> str:
    return f"{float(part / whole) if whole else 0.0:.4%}"
