"""`platoon-osm plan`: a scenario becomes a table, a map, and files for other programs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import click

from ...costs.fuel import FUEL_SAVINGS
from ...report.exporters import EXPORTERS
from ..options import FILE, SectionOption, Sections, new_file
from ..progress import steps

__all__ = ["verb"]


class _WithExporters(Sections):
    """A verb with an option for each exporter; its help lists the fuel tables too."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        own = super().get_params(ctx)
        return [*own, *(_option(name) for name in EXPORTERS if name not in {p.name for p in own})]

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section('Fuel tables, for positions = "..." under [costs]'):
            formatter.write_dl([(table.name, table.source) for table in FUEL_SAVINGS.values()])
        super().format_epilog(ctx, formatter)


def _option(name: str) -> click.Option:
    exporter = EXPORTERS[name]
    about = exporter.about[:1].upper() + exporter.about[1:] + "."
    return SectionOption(
        [f"--{name}"],
        "What to write",
        type=FILE if exporter.is_folder else new_file,
        metavar="FOLDER" if exporter.is_folder else "FILE",
        help=about,
    )


@click.command(
    "plan",
    cls=_WithExporters,
    short_help="plan a scenario (TOML) and write its map and tables",
    epilog="""\b
Examples:
  platoon-osm plan corridor.toml --html plan.html --gpkg plan.gpkg
  platoon-osm plan corridor.toml --case best --json plan.json
""",
)
@click.argument("scenario", type=FILE)
@click.option("--case", help="A, B, C, D or best, instead of the scenario's.")
def verb(scenario: Path, case: str | None, **paths: Path | None) -> None:
    """Plan SCENARIO, print who joins whom and what each saves, and write what is asked for.

    SCENARIO is a TOML file such as those in examples/.
    """
    from ...planning.scenario import read_scenario
    from ...sources.load import load_network

    asked = read_scenario(scenario)
    if case:
        asked = replace(asked, options={**asked.options, "case": case})
    outputs = [(EXPORTERS[name], path) for name in EXPORTERS if (path := paths.get(name))]
    with steps(2 + len(outputs)) as begin:
        begin(f"loading {asked.network['source']}")
        net = load_network(**asked.network)
        begin("planning")
        plan = asked.plan(net)
        for exporter, path in outputs:
            begin(f"writing {path}")
            if exporter.is_folder:
                path.mkdir(parents=True, exist_ok=True)
            exporter.write(plan, net, path, title=asked.title)
    click.echo(plan.summary())
    for _, path in outputs:
        click.echo(f"Written: {path}")
