"""`platoon-osm scenario`: an example to begin with, and whether a scenario says what it should."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import click

from ..options import FILE

__all__ = ["verb"]


@click.command(
    "scenario",
    short_help="print a commented scenario, or check some without planning",
    epilog="""\b
Examples:
  platoon-osm scenario --example > corridor.toml
  platoon-osm scenario --check corridor.toml
""",
)
@click.option("--example", is_flag=True, help="Print a commented scenario that can be planned.")
@click.option(
    "--check",
    type=FILE,
    multiple=True,
    metavar="FILE",
    help="Read a scenario or a table of trips and say what it holds; may be given several times.",
)
def verb(example: bool, check: tuple[Path, ...]) -> None:
    """Print an example of a scenario, or check scenarios without planning them.

    Places are looked for on the network only when it is planned. docs/scenario.md tells all keys.
    """
    from ...planning.scenario.checking import checked

    if example == bool(check):
        raise click.UsageError("--example or --check FILE is required, one of them")
    if example:
        text = resources.files("platoon_osm.scenarios").joinpath("example.toml")
        click.echo(text.read_text(encoding="utf-8"), nl=False)
        return
    for said in [checked(path) for path in check]:
        click.echo(said)
