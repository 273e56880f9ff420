"""`platoon-osm check`: a finished plan, looked at for violations of driving rules."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ...errors import ScenarioError
from ...inspection.activities import clock_span
from ...inspection.rule_sets import RULE_SETS, rule_set
from ...shown_text import fitted
from ..exit_status import UNMET
from ..options import FILE

if TYPE_CHECKING:
    from ...inspection.verdict import Found
    from ...plans.clock import Clock

__all__ = ["verb"]


@click.command(
    "check",
    short_help="look for violations of driving rules in a plan",
    epilog="""\b
Examples:
  platoon-osm check plan.json
  platoon-osm check plan.json --rules eu561
""",
)
@click.argument("plan", type=FILE)
@click.option(
    "--rules",
    type=click.Choice(list(RULE_SETS)),
    help="Which rules; by default those that the plan was made by.",
)
@click.option(
    "--article-12",
    is_flag=True,
    help="Mark what (EC) 561/2006 art. 12 would excuse on the way to a weekly rest.",
)
def verb(plan: Path, rules: str | None, article_12: bool) -> None:
    """Look at the times of PLAN, a file that `platoon-osm plan --json` wrote, and nothing else.

    Prints one line for each violation of driving rules, with vehicle, driver, article, local time
    and minutes, and for whatever in the plan contradicts itself. Ends with 1 if there is any.
    """
    from ...inspection.verdict import driving_of, inspect_plan
    from ...plans.plan import Plan

    made = Plan.read_json(plan)
    if made.timetable is None:
        raise ScenarioError(f"{plan}: names no times; give its trips times and plan again")
    chosen = rule_set(made.timetable.rules if rules is None else rules)
    found = inspect_plan(made, chosen.name, article_12=article_12)
    for one in found:
        click.echo(_line(one, made.timetable.clock))
    if found:
        raise click.exceptions.Exit(UNMET)
    drivers, driven_s = driving_of(made)
    who = "1 driver" if drivers == 1 else f"{drivers:,} drivers"
    driven = clock_span(round(driven_s / 60) * 60)
    click.echo(f"no violation of {chosen.title} by {who} over {driven} of driving")
    if chosen.name == "none":
        click.echo("no driving rules were looked at; name some, such as --rules eu561")


def _line(found: Found, clock: Clock) -> str:
    vehicle, driver, violation = found
    who = fitted(vehicle) + (f", driver {driver}" if driver else "")
    moment = clock.moment(violation.at_s).strftime("%Y-%m-%d %H:%M")
    minutes = f"{violation.minutes_over:,.0f} min"
    if violation.minutes_over < 1:
        minutes = "less than a minute"
    excuse = "; Art. 12 would excuse it" if violation.excusable else ""
    return f"{who}: {violation.article}, {moment}, {minutes}: {violation.text}{excuse}"
