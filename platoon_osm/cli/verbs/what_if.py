"""`platoon-osm what-if`: a scenario planned anew for each value of a figure, or of several."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ...costs.fuel import FUEL_SAVINGS
from ...costs.presets import PRESETS
from ...errors import ScenarioError, brief
from ...output_paths import PAGES, Output, check_outputs
from ..asked import asked_options, asked_scenario
from ..exit_status import end_if_unmet
from ..language import language_options
from ..options import FILE, SectionOption, Sections
from ..outputs import STREAM, existing_files, speaker, tell_written, write_all
from ..progress import steps
from ..value_lists import values_of

if TYPE_CHECKING:
    from ...planning.scenario.record import Scenario
    from ...plans.what_if import WhatIfs

__all__ = ["verb"]

Run = TypeVar("Run", bound=Callable[..., Any])

TASK_RELIEF = "task_relief"

FIGURES = {
    "price": ("fuel_per_l", "Price of a litre of fuel, such as 1.4:2.2:0.1."),
    "wage": ("driver_per_h", "A driver's hour, and waiting with it: 20:40:5."),
    "toll": ("toll", "Toll, as a multiple of that of today: 0,0.5,1,2."),
    "co2": ("co2_per_t", "Price of a tonne of CO2e: 0:200:50."),
    "relief": (TASK_RELIEF, "How much a follower's clock slows under --rules: 0:1:0.5."),
    "positions": ("positions", f"What places save: {','.join(FUEL_SAVINGS)}."),
}
"""What is varied by options of its own: the figure, and help."""

VARIED = "What to vary, each by itself: FROM:TO:STEP, or values with commas"
DEFAULT = "eu"
"""What a scenario is paid in that does not say."""

TABLE, DRAWN = (".csv",), (".svg", ".png", ".pdf")
HELD = ("what-if.csv", "what-if.svg", "what-if.html")
"""What a folder gets."""


def _output(text: Any) -> Output:
    """Return what -o names: a file by its suffix, else a folder."""
    if isinstance(text, Output):  # click reads defaults twice
        return text
    if not str(text):
        raise ScenarioError("-o: empty; give a name to write to")
    path = Path(text)
    suffix = path.suffix.lower()
    if text == STREAM:
        made = Output("-o", None, TABLE, is_text=True)
    elif not suffix or path.is_dir():
        made = Output("-o", path, holds=HELD)
    elif suffix in (*TABLE, *DRAWN, *PAGES):
        made = Output("-o", path, (suffix,))
    else:
        raise ScenarioError(
            f"-o {text}: ends in {brief(path.suffix)}; use .csv, .svg, .png, .pdf, .html, or none"
        )
    check_outputs([made])
    return made


def _varied(run: Run) -> Run:
    """Add the options that vary a figure."""
    for name, (_, about) in reversed(FIGURES.items()):
        run = click.option(
            f"--{name}", cls=SectionOption, section=VARIED, metavar="VALUES", help=about
        )(run)
    return run


@click.command(
    "what-if",
    cls=Sections,
    short_help="plan a scenario for other prices, tolls, rules of the clock",
    epilog="""\b
Examples:
  platoon-osm what-if corridor.toml --objective eu --price 1.4:2.2:0.1
  platoon-osm what-if corridor.toml --wage 20:40:5 --toll 0,0.5,1,2 -o what-if.html
  platoon-osm what-if corridor.toml --figure co2_per_t=0:200:50 -o - > table.csv
""",
)
@click.argument("scenario", type=FILE, required=False)
@_varied
@click.option(
    "--figure",
    "figures",
    cls=SectionOption,
    section=VARIED,
    multiple=True,
    metavar="NAME=VALUES",
    help="Any figure of the objective; as often as needed.",
)
@click.option(
    "-o",
    "--output",
    "outputs",
    type=_output,
    multiple=True,
    metavar="PATH",
    help="Write .csv, .svg, .png, .pdf or .html, or into a folder; - is CSV to standard output.",
)
@asked_options
@language_options
def verb(
    scenario: Path | None, figures: tuple[str, ...], outputs: tuple[Output, ...], **given: Any
) -> None:
    """Plan SCENARIO anew for each value, print what changes and what planning anew is worth.

    Each figure is varied by itself, all others as asked. Costs are those of the preset eu, unless
    the scenario or --objective say otherwise. Options come before what the scenario says; with
    --trips and --network there need be none.
    """
    from ...planning.joint import solve
    from ...planning.what_if import what_if
    from ...plans.what_if import WhatIfs
    from ...plans.what_if_lines import what_if_lines
    from ...sources.load import load_network

    if scenario is None and given["trips"] is None:
        raise click.UsageError("SCENARIO is required, or --trips with --network")
    varied = _values({name: given.pop(name) for name in FIGURES}, figures)
    asked = _asked(scenario, given)
    _check_figures(asked, varied)
    check_outputs(outputs, [*asked.files, *existing_files(asked.network["source"])])
    with steps(2 + len(varied) + len(outputs)) as begin:
        begin(f"loading {asked.network['source']}")
        net = load_network(**asked.network)
        problem = asked.problem(net)
        begin("planning as asked")
        plan = solve(problem)
        studies = []
        for figure, values in varied.items():
            begin(f"planning for {len(values)} values of {figure}")
            studies.append(what_if(problem, figure, values, plan=plan))
        found = WhatIfs(tuple(studies))
        write_all([(one, partial(_write, found, asked.title, one)) for one in outputs], begin)
    say = speaker(outputs)
    say("\n\n".join("\n".join(what_if_lines(study)) for study in studies))
    tell_written(outputs, say)
    end_if_unmet([plan])


def _values(
    options: Mapping[str, str | None], figures: tuple[str, ...]
) -> dict[str, list[float | str]]:
    """Return the values of each figure, by its name in the objective."""
    found: dict[str, list[float | str]] = {}

    def add(figure: str, option: str, text: str) -> None:
        if figure in found:
            raise ScenarioError(f"{option}: {figure} is varied twice; give its values once")
        found[figure] = values_of(option, text, names=figure in ("positions", "mixing"))

    for name, text in options.items():
        if text is not None:
            add(FIGURES[name][0], f"--{name}", text)
    for text in figures:
        figure, is_told, values = text.partition("=")
        if not (is_told and figure.strip()):
            raise ScenarioError(f"--figure {brief(text)}: write NAME=VALUES, co2_per_t=0:200:50")
        add(figure.strip(), "--figure", values)
    if not found:
        raise ScenarioError("what-if: nothing to vary; give values, such as --price 1.4:2.2:0.1")
    return found


def _asked(scenario: Path | None, given: dict[str, Any]) -> Scenario:
    """Return what to plan, paid in money unless the scenario or an option says otherwise."""
    from ...planning.scenario.reading import read_scenario

    if given["preset"] is None and (scenario is None or not read_scenario(scenario).names_costs):
        given["preset"] = DEFAULT
    return asked_scenario(scenario, given)


def _check_figures(asked: Scenario, varied: Mapping[str, list[float | str]]) -> None:
    """Refuse figures that the objective has not, with those that have them."""
    own = PRESETS.find(asked.preset)
    for figure in varied:
        if figure == TASK_RELIEF or figure in own.parameters:
            continue
        others = [one.name for one in PRESETS.values() if figure in one.parameters]
        remedy = (
            f"add --objective {others[0]}"
            if others
            else f"it has {', '.join((*own.parameters, TASK_RELIEF))}"
        )
        raise ScenarioError(
            f"{asked.file}: its costs are those of {asked.preset}, which have no {brief(figure)}; "
            f"{remedy}"
        )


def _write(found: WhatIfs, title: str, output: Output, path: Path) -> None:
    from ...report.pages.what_if import write_what_if

    for target in [path / name for name in HELD] if output.holds else [path]:
        if target.suffix.lower() in TABLE:
            found.write_csv(target)
        else:
            write_what_if(found, target, title=title)
