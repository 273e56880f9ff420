"""`platoon-osm plan`: a scenario becomes a table, a map, and files for other programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ...costs.fuel import FUEL_SAVINGS
from ...costs.presets import PRESETS
from ...driving.rules import RULES
from ...output_paths import check_outputs
from ...report.exporters import EXPORTERS, Exporter
from ..asked import asked_options, asked_scenario
from ..exit_status import end_if_unmet
from ..language import language_options
from ..options import FILE, SectionOption, Sections
from ..outputs import existing_files, output_kind, speaker, tell_written, write_all
from ..progress import steps
from ..time_worth import time_worth

if TYPE_CHECKING:
    from ...network.road_network import RoadNetwork
    from ...plans.plan import Plan

__all__ = ["verb"]


class _WithExporters(Sections):
    """A verb with an option for each exporter; its help lists what names there are."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        own = super().get_params(ctx)
        taken = {word for parameter in own for word in parameter.opts}
        outputs = [_output(number, exporter) for number, exporter in enumerate(EXPORTERS.values())]
        return [*own, *(option for option in outputs if option.opts[0] not in taken)]

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section('Savings by position, for positions = "..." under [objective]'):
            formatter.write_dl([(table.name, table.source) for table in FUEL_SAVINGS.values()])
        with formatter.section('Objectives, for --objective and preset = "..." under [objective]'):
            formatter.write_dl([(preset.name, preset.about) for preset in PRESETS.values()])
        with formatter.section('Driving rules, for --rules and rules = "..."'):
            formatter.write_dl([(rules.name, rules.about) for rules in RULES.values()])
        super().format_epilog(ctx, formatter)


def _output(number: int, exporter: Exporter) -> click.Option:
    # Known to the verb by a number, for an exporter's name may be no name in Python.
    return SectionOption(
        [f"--{exporter.name}", f"output_{number}"],
        "What to write",
        type=output_kind(
            f"--{exporter.name}",
            (exporter.suffix, *exporter.also) if exporter.suffix else (),
            holds=exporter.holds if exporter.is_folder else (),
            is_text=exporter.is_text,
        ),
        metavar="FOLDER" if exporter.is_folder else "FILE",
        help=exporter.about[:1].upper() + exporter.about[1:] + ".",
    )


@click.command(
    "plan",
    cls=_WithExporters,
    short_help="plan a scenario or a table of trips, write map and tables",
    epilog="""\b
Examples:
  platoon-osm plan corridor.toml --html plan.html --gpkg plan.gpkg
  platoon-osm plan --network italy-motorways --trips trips.csv --case C
  platoon-osm plan corridor.toml --case best --json plan.json
""",
)
@click.argument("scenario", type=FILE, required=False)
@asked_options
@language_options
def verb(scenario: Path | None, **given: Any) -> None:
    """Plan SCENARIO, print who joins whom and what each saves, and write what is asked for.

    SCENARIO is a TOML file, such as `platoon-osm scenario --example` prints. Options come before
    what it says; with --trips and --network there need be none.
    The name - writes HTML, JSON or CSV to standard output, and the summary to standard error.
    """
    from ...sources.load import load_network

    if scenario is None and given["trips"] is None:
        raise click.UsageError("SCENARIO is required, or --trips with --network")
    asked = asked_scenario(scenario, given)
    chosen = [
        (exporter, output)
        for number, exporter in enumerate(EXPORTERS.values())
        if (output := given.get(f"output_{number}"))
    ]
    outputs = [output for _, output in chosen]
    check_outputs(outputs, [*asked.files, *existing_files(asked.network["source"])])
    with steps(2 + len(outputs)) as begin:
        begin(f"loading {asked.network['source']}")
        net = load_network(**asked.network)
        begin("planning")
        plan = asked.plan(net)
        takes = {name for exporter, _ in chosen for name in exporter.takes}
        more = time_worth(asked, net, plan) if takes else {}
        write = partial(partial, _write, plan, net, asked.title, more)
        write_all([(output, write(exporter)) for exporter, output in chosen], begin)
    say = speaker(outputs)
    say(plan.summary())
    tell_written(outputs, say)
    end_if_unmet([plan])


def _write(
    plan: Plan,
    net: RoadNetwork,
    title: str,
    more: Mapping[str, object],
    exporter: Exporter,
    path: Path,
) -> None:
    told = {name: value for name, value in more.items() if name in exporter.takes}
    write: Callable[..., object] = exporter.write
    write(plan, net, path, title=title, **told)
