"""`platoon-osm bench`: published instances planned, beside what was published of them."""

from __future__ import annotations

from pathlib import Path

import click

from ..options import FOLDER
from ..progress import counted

__all__ = ["verb"]


@click.group("bench", short_help="plan published instances, beside what was published")
def verb() -> None:
    """Plan instances that others have published, and compare."""


@verb.command(
    "dutch",
    short_help="trucks between 20 Dutch cities (Bhoopalam, Agatz and Zuidwijk 2023)",
    epilog="""\b
Examples:
  platoon-osm bench dutch --data dutch_platooning
  platoon-osm bench dutch --data 2020.0302 --set ONEDEST -o out
""",
)
@click.option(
    "--data", type=FOLDER, required=True, metavar="FOLDER",
    help="Folder of the instances: tables, or as published (doi 10.1287/ijoc.2020.0302.cd).",
)  # fmt: skip
@click.option(
    "--set", "sets", multiple=True, type=click.Choice(("UNIFORM", "ONEORIG", "ONEDEST")),
    help="Which set; may be given more than once, else all.",
)  # fmt: skip
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), metavar="FOLDER",
    help="Folder for instances.csv and cells.csv.",
)  # fmt: skip
def _dutch(data: Path, sets: tuple[str, ...], output: Path | None) -> None:
    """Plan the published instances and print savings, kilometres, gaps and seconds.

    First with departures rounded up to 15 minutes, as published, then with exact minutes.
    """
    from ...errors import ScenarioError
    from ...fleets.dutch.comparing import (
        cells_of,
        kinds_of,
        run_all,
        table_of,
        write_cells,
        write_runs,
    )
    from ...fleets.dutch.folder import read_dutch
    from ...fleets.dutch.model import GRID_MIN

    found = read_dutch(data)
    asked = kinds_of(found, sets, (GRID_MIN, 0.0))
    if not asked:
        raise ScenarioError(f"{data}: has no instance of {', '.join(sets)}; leave out --set")
    with counted("plans", len(asked)) as done:
        runs = run_all(found, asked, done)
    for grid, title in ((GRID_MIN, "Departures on a grid of 15 min"), (0.0, "Exact minutes")):
        own = [run for run in runs if run.grid_min == grid]
        click.echo(f"{title}\n\n{table_of(cells_of(found, own), own)}\n")
    click.echo(
        "Instances: A. K. Bhoopalam, N. Agatz, R. Zuidwijk, Platoon Optimization based on Truck "
        "Pairs, INFORMS Journal on Computing 2023, doi 10.1287/ijoc.2020.0302"
    )
    if output is not None:
        write_runs(runs, output / "instances.csv")
        write_cells(cells_of(found, runs), output / "cells.csv")
        click.echo(f"wrote {output / 'instances.csv'} and {output / 'cells.csv'}")
