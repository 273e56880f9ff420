"""`platoon-osm demo`: a corridor on a bundled map, planned and drawn."""

from __future__ import annotations

from dataclasses import replace
from importlib import resources
from pathlib import Path

import click

from ...costs.presets import PRESETS
from ...driving.rules import RULES
from ...output_paths import Output, check_outputs
from ..exit_status import end_if_unmet
from ..language import language_options
from ..options import objective_named, rules_named
from ..outputs import output_kind, write_all
from ..progress import steps
from ..time_worth import time_worth

__all__ = ["verb"]

SCENARIOS = {
    "italy-motorways": ("po-valley-a", "po-valley-b", "po-valley-d", "four-to-the-south"),
    "california-corridor": ("san-diego-to-redding",),
}
"""By map. Case C comes last: its plan is the one that is written."""

LAW = {"italy-motorways": "eu561", "california-corridor": "us395"}
"""The driving rules that hold there."""

MONEY = {"italy-motorways": "eu", "california-corridor": "us"}
"""The objective whose money is paid there."""


@click.command("demo", short_help="plan cases A to D on the bundled map and draw them")
@click.option(
    "-o", "--output", type=output_kind("-o", holds=("demo.html", "demo.gpkg")), metavar="FOLDER",
    default="out", help="Folder to write into.",
)  # fmt: skip
@click.option(
    "--map", "network", type=click.Choice(tuple(SCENARIOS)), default="italy-motorways",
    help="Bundled map to plan on; that of Italy if not given.",
)  # fmt: skip
@click.option(
    "--rules", type=rules_named, metavar="TEXT",
    help=f"Driving rules by which breaks and rests are planned: {', '.join(RULES)}; those of the "
    "map's country if not given.",
)  # fmt: skip
@click.option(
    "--objective",
    type=objective_named,
    metavar="TEXT",
    help=f"What is to be least: {', '.join(PRESETS)}; money of the map's country if not given.",
)
@language_options
def verb(output: Output, network: str, rules: str | None, objective: str | None) -> None:
    """Plan trips in Italy in cases A to D, on the bundled map.

    Case C is four trucks to Roma and Napoli; with --map california-corridor it is three trucks up
    the I 5, on a true extract of OpenStreetMap. Breaks and rests are those of the law there: of
    Regulation (EC) 561/2006, or of 49 CFR 395.3; with --rules spread-rest the paper's, with --rules
    none there are none. Costs are euros or dollars; with --objective paper the weights of the
    paper, and the 18 % that it assumes.

    Writes demo.html, a page to open in any browser, and demo.gpkg, for a GIS; both show case C.
    """
    from ...planning.scenario import read_scenario
    from ...report.exporters import EXPORTERS
    from ...sources.load import load_network

    assert output.path is not None  # a folder is no stream
    folder = resources.files("platoon_osm.scenarios")
    files = {name: output.path / f"demo{EXPORTERS[name].suffix}" for name in ("html", "gpkg")}
    if output.path.is_dir():
        check_outputs([Output("-o", file) for file in files.values()])
    names = SCENARIOS[network]
    with steps(3 + len(names)) as begin:
        begin(f"loading {network}")
        net = load_network(network)
        plans = []
        for name in names:
            with resources.as_file(folder / f"{name}.toml") as path:
                scenario = read_scenario(path)
            begin(f"planning {scenario.title}")
            scenario = replace(
                scenario, options={**scenario.options, "rules": rules or LAW[network]}
            )
            chosen = objective or MONEY[network]
            if scenario.preset != chosen:
                scenario = replace(scenario, preset=chosen, costs={})
            plans.append((scenario.title, scenario.plan(net)))
        title, plan = plans[-1]
        begin("working out what the hour is worth")
        more = time_worth(scenario, net, plan)

        def write(into: Path) -> None:
            for name, file in files.items():
                own = EXPORTERS[name]
                known = {key: more[key] for key in own.takes if key in more}
                own.write(plan, net, into / file.name, title=title, **known)

        write_all([(output, write)], begin)
    click.echo(repr(net)[1:-1])
    for title, plan in plans:
        click.echo(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    click.echo(f"\nMap: {files['html']}\nGIS: {files['gpkg']}")
    end_if_unmet([plan for _, plan in plans])
