"""`platoon-osm trips`: a day of trips is drawn, from flows or between the towns of a map."""

from __future__ import annotations

from datetime import date, datetime
from pathlib import Path
from typing import Any

import click

from ...errors import ScenarioError, brief
from ...output_paths import Output, check_outputs
from ..options import FILE, network_options, output_option
from ..outputs import existing_files, speaker, tell_written, write_all
from ..progress import steps

__all__ = ["verb"]


def _day(text: str) -> date:
    try:
        return datetime.strptime(text, "%Y-%m-%d").date()
    except ValueError:
        raise ScenarioError(f"--date {brief(text)}: give a day such as 2026-03-02") from None


@click.command(
    "trips",
    short_help="draw a day of trips, from truck flows or between towns",
    epilog="""\b
Examples:
  platoon-osm trips --network italy-motorways --number 1000 -o trips.csv
  platoon-osm trips --network de.graphml --flows traffic.csv --day peaked -o trips.csv
""",
)
@click.option("--network", required=True, metavar="TEXT", help="A bundled map's name or a file.")
@click.option(
    "--flows", type=FILE, metavar="FILE",
    help="CSV of truck volumes, origin,destination,volume; else by the towns' inhabitants.",
)  # fmt: skip
@click.option(
    "--day", type=click.Choice(("uniform", "peaked")), default="uniform",
    help="When they leave: at any time, or most of them around 6 and 18 h.",
)  # fmt: skip
@click.option("--number", type=int, default=1000, help="How many trips; else 1000.")
@click.option(
    "--flexibility", "flexibility_min", type=float, default=30.0,
    help="Minutes by which each may take longer than alone; else 30.",
)  # fmt: skip
@click.option("--min-km", type=float, default=100.0, help="Shorter ways are not drawn; else 100.")
@click.option("--date", "on", type=_day, metavar="DATE", help="The day; else 2026-03-02.")
@click.option("--seed", type=int, default=0, help="Of the draws; else 0.")
@output_option("Table of trips to write (.csv), or - for standard output.", (".csv",), is_text=True)
@network_options
def verb(network: str, flows: Path | None, output: Output, **given: Any) -> None:
    """Draw a day of trips and write them as a table that `plan --trips` and `fleet` read."""
    from ...fleets.day.draw import draw_trips
    from ...fleets.day.trip_file import write_trips
    from ...sources.load import load_network

    asked = {
        name: given.pop(name)
        for name in ("number", "day", "flexibility_min", "min_km", "on", "seed")
    }
    check_outputs([output], existing_files(network, flows))
    with steps(3) as begin:
        begin(f"loading {network}")
        net = load_network(network, **given)
        begin("drawing")
        trips = draw_trips(net, flows=flows, **asked)
        write_all([(output, lambda path: write_trips(trips, path))], begin)
    say = speaker([output])
    say(f"{len(trips)} trips on {net.source.name}")
    tell_written([output], say)
