"""`platoon-osm fleet`: a table of trips becomes platoons, with a bound on what could be saved."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ...costs.presets import PRESETS
from ...driving.rules import RULES
from ...output_paths import Output, check_outputs
from ..asked_fleet import asked_fleet, fleet_options, limits_of
from ..exit_status import tell
from ..language import language_options
from ..options import FILE, Sections
from ..outputs import existing_files, output_kind
from ..progress import searched, steps

if TYPE_CHECKING:
    from ...fleets.progress import Progress

__all__ = ["verb"]

FLEET = "fleet.json"
HOLDS = (FLEET, "assignment.csv", "platoons.csv", "vehicles.csv", "unserved.csv", "fleet.html")


class _WithObjectives(Sections):
    """A verb whose help lists what objectives and driving rules there are."""

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Objectives, for --objective"):
            formatter.write_dl([(preset.name, preset.about) for preset in PRESETS.values()])
        with formatter.section("Driving rules, for --rules"):
            formatter.write_dl([(rules.name, rules.about) for rules in RULES.values()])
        super().format_epilog(ctx, formatter)


@click.command(
    "fleet",
    cls=_WithObjectives,
    short_help="plan who drives with whom in a whole fleet, and how far from best that is",
    epilog="""\b
Examples:
  platoon-osm fleet trips.csv --network italy-motorways --flexibility 30 -o out/
  platoon-osm fleet trips.xlsx --network de.osm.pbf --max-platoon 5 --time-limit 600 -o out/
""",
)
@click.argument("trips", type=FILE)
@fleet_options
@click.option(
    "-o", "--output", required=True, metavar="FOLDER",
    type=output_kind("-o", holds=HOLDS), help="Folder to write into.",
)  # fmt: skip
@click.option(
    "--sheets/--no-sheets", default=None,
    help="A sheet for each driver; else for fleets of up to 100.",
)  # fmt: skip
@language_options
def verb(trips: Path, output: Output, sheets: bool | None, **given: Any) -> None:
    """Plan TRIPS (.csv, .xlsx or .gpkg) and write plan, tables and sheets into a folder.

    Trips that cannot be read or planned are listed in unserved.csv, the others planned. Ctrl-C ends
    the search with the best plan so far. fleet.json is written while it runs, and has the
    certificate that `platoon-osm certify` checks.
    """
    from ...fleets.fleet import plan_fleet
    from ...planning.scenario.trip_tables import read_fleet_table
    from ...report.fleet_folder import write_fleet_folder
    from ...sources.load import load_network

    table = read_fleet_table(trips, given.pop("sheet"))
    listed = (given["apart"], given["together"])
    limits = limits_of(table, given)
    asked = asked_fleet(trips, table, given)
    check_outputs([output], [*existing_files(trips, *listed, asked.network["source"])])
    assert output.path is not None
    with steps(1) as begin:
        begin(f"loading {asked.network['source']}")
        net = load_network(**asked.network)
        problem = asked.unplaced(net)
    unit = problem.objective.unit
    with searched("searching") as show:

        def told(now: Progress) -> None:
            show(now.share, f"saves {now.saving:,.0f} {unit}, gap {now.gap:.2%}")

        plan = plan_fleet(
            problem, limits, write_to=output.path / FLEET, on_progress=told,
            unserved=table.unserved,
        )  # fmt: skip
    with steps(1) as begin:
        begin(f"writing {output.path}")
        write_fleet_folder(plan, net, output.path, title=asked.title, sheets=sheets)
    click.echo(plan.summary())
    click.echo(f"Written: {output.path}")
    if plan.fleet is not None and plan.fleet.unserved:
        tell(
            f"{len(plan.fleet.unserved)} trips could not be planned; "
            f"{output.path / 'unserved.csv'} tells why"
        )
