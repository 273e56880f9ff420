"""`platoon-osm compare`: a scenario planned in several ways, side by side on one page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ...driving.rules import RULES
from ...errors import ScenarioError, brief
from ...output_paths import PAGES, Output, check_outputs
from ..exit_status import end_if_unmet
from ..language import language_options
from ..options import FILE, output_option, rules_named
from ..outputs import existing_files, speaker, write_all
from ..progress import steps

if TYPE_CHECKING:
    from ...planning.scenario import Scenario

__all__ = ["verb"]

EXAMPLES = {
    "cases": "cases such as A,B,C",
    "rules": "driving rules such as none,eu561",
    "task_relief": "numbers from 0 to 1 such as 0,0.5,1",
}
"""Of each list of values, by its option."""
OPTIONS = {"cases": "case", "rules": "rules", "task_relief": "task_relief"}
"""Of scenarios."""
NAMES = {"cases": "case", "rules": "rules", "task_relief": "task relief"}
"""In titles."""


@click.command(
    "compare",
    short_help="plan a scenario in several ways, side by side",
    epilog="""\b
Examples:
  platoon-osm compare corridor.toml --cases A,B,C -o compare.html
  platoon-osm compare cautious.toml hopeful.toml -o compare.html
  platoon-osm compare corridor.toml --rules none,eu561 -o law.html
""",
)
@click.argument("scenario", type=FILE, nargs=-1, required=True)
@click.option("--cases", help="Such as A,B,C: each scenario in each of these cases.")
@click.option(
    "--rules", help=f"Each scenario under each of these driving rules: {','.join(RULES)}."
)
@click.option(
    "--task-relief", help="Such as 0,0.5,1: each with a follower's clock slowed by so much."
)
@output_option("page.html to write.", PAGES, is_text=True)
@click.option(
    "--baseline",
    metavar="PLAN",
    help="The plan that others of the same trips are set against: its number, from 1, or its "
    "title; by default the first.",
)
@language_options
def verb(
    scenario: tuple[Path, ...], output: Output, baseline: str | None, **lists: str | None
) -> None:
    """Plan each SCENARIO, in one way or several, and write a page that shows them side by side.

    Several scenarios must name one network; they may differ in anything else, as in [costs]. Plans
    of the same trips are compared; plans of other trips stand apart on the page, which says so.
    """
    from ...planning.scenario import read_scenario
    from ...report.pages.comparison import write_comparison
    from ...sources.load import load_network

    ways = _ways(lists)
    scenarios = [read_scenario(path) for path in scenario]
    first = scenarios[0]
    for other in scenarios[1:]:
        if other.network != first.network:
            raise ScenarioError(
                f"{other.file}: names another network than {first.file}; compare plans on one"
            )
    files = [file for each in scenarios for file in each.files]
    check_outputs([output], [*files, *existing_files(first.network["source"])])
    variants = [variant for each in scenarios for variant in _in_ways(each, ways)]
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
    end_if_unmet(plans)


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


def _ways(lists: Mapping[str, str | None]) -> list[dict[str, Any]]:
    """Return what to plan each scenario with: every choice of one value from each list."""
    given = {key: _listed(key, text) for key, text in lists.items() if text is not None}
    return [dict(zip(given, values, strict=True)) for values in product(*given.values())]


def _listed(key: str, text: str) -> list[Any]:
    option = f"--{key.replace('_', '-')}"
    words = [part.strip() for part in text.split(",") if part.strip()]
    if not words:
        raise ScenarioError(f"{option}: empty; give {EXAMPLES[key]}")
    if key == "rules":
        return [rules_named(word) for word in words]
    if key == "cases":
        return words
    try:
        return [float(word) for word in words]
    except ValueError:
        raise ScenarioError(f"{option}: {brief(text)}; give {EXAMPLES[key]}") from None


def _in_ways(
    scenario: Scenario, ways: Sequence[Mapping[str, Any]]
) -> Iterator[tuple[str, Scenario]]:
    """Yield a scenario in each of some ways, with a title that says which."""
    for way in ways:
        told = [f"{NAMES[key]} {_shown(value)}" for key, value in way.items()]
        options = {**scenario.options, **{OPTIONS[key]: value for key, value in way.items()}}
        yield ", ".join([scenario.title, *told]), replace(scenario, options=options)


def _shown(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
