"""`platoon-osm compare`: a scenario planned in several ways, side by side on one page."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ...errors import ScenarioError, brief
from ...output_paths import PAGES, Output, check_outputs
from ..exit_status import end_if_late
from ..language import language_options
from ..options import FILE, output_option
from ..outputs import existing_files, speaker, write_all
from ..progress import steps

if TYPE_CHECKING:
    from ...planning.scenario import Scenario

__all__ = ["verb"]


@click.command(
    "compare",
    short_help="plan a scenario in several ways, side by side",
    epilog="""\b
Examples:
  platoon-osm compare corridor.toml --cases A,B,C -o compare.html
  platoon-osm compare cautious.toml hopeful.toml -o compare.html
""",
)
@click.argument("scenario", type=FILE, nargs=-1, required=True)
@click.option("--cases", help="Such as A,B,C: each scenario in each of these cases.")
@output_option("page.html to write.", PAGES, is_text=True)
@click.option(
    "--baseline",
    metavar="PLAN",
    help="The plan that others of the same trips are set against: its number, from 1, or its "
    "title; by default the first.",
)
@language_options
def verb(
    scenario: tuple[Path, ...], cases: str | None, output: Output, baseline: str | None
) -> None:
    """Plan each SCENARIO, in one case or several, and write a page that shows them side by side.

    Several scenarios must name one network; they may differ in anything else, as in [costs]. Plans
    of the same trips are compared; plans of other trips stand apart on the page, which says so.
    """
    from ...planning.scenario import read_scenario
    from ...report.pages.comparison import write_comparison
    from ...sources.load import load_network

    scenarios = [read_scenario(path) for path in scenario]
    first = scenarios[0]
    for other in scenarios[1:]:
        if other.network != first.network:
            raise ScenarioError(
                f"{other.file}: names another network than {first.file}; compare plans on one"
            )
    files = [file for each in scenarios for file in each.files]
    check_outputs([output], [*files, *existing_files(first.network["source"])])
    variants = [variant for each in scenarios for variant in _in_cases(each, cases)]
    titles = [title for title, _ in variants]
    base = _baseline(baseline, titles)
    with steps(2 + len(variants)) as begin:
        begin(f"loading {first.network['source']}")
        net = load_network(**first.network)
        plans = []
        for title, each in variants:
            begin(f"planning {title}")
            plans.append(each.plan(net))
        # The title of the page names all plans; cases of one scenario have that in common.
        write = partial(write_comparison, plans, net, titles=titles, baseline=base)
        write_all([(output, write)], begin)
    say = speaker([output])
    for title, plan in zip(titles, plans, strict=True):
        say(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    if output.path is not None:
        say(f"\nWritten: {output.path}")
    end_if_late(plans)


def _baseline(asked: str | None, titles: list[str]) -> int:
    """Return the position of the plan that others are set against."""
    if asked is None:
        return 0
    if asked in titles:
        return titles.index(asked)
    if asked.isdecimal() and 1 <= int(asked) <= len(titles):
        return int(asked) - 1
    raise ScenarioError(
        f"--baseline: {brief(asked)} is no plan; give 1 to {len(titles)}, or a title as it is shown"
    )


def _in_cases(scenario: Scenario, cases: str | None) -> Iterator[tuple[str, Scenario]]:
    """Yield a scenario in each of some cases, with a title; as it stands if none are given."""
    if cases is None:
        yield scenario.title, scenario
        return
    names = [part.strip() for part in cases.split(",") if part.strip()]
    if not names:
        raise ScenarioError("--cases: empty; give cases such as A,B,C")
    for case in names:
        options = {**scenario.options, "case": case}
        yield f"{scenario.title}, case {case}", replace(scenario, options=options)
