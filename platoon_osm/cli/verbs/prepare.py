"""`platoon-osm prepare`: a map is read once and saved in a form that opens fast."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ..options import network_options, output_option
from ..progress import steps

__all__ = ["verb"]


@click.command("prepare", short_help="read a map once, save it in a form that opens fast")
@click.argument("source")
@output_option(help="file.platoon to write.")
@network_options
def verb(source: str, output: Path, **loading: Any) -> None:
    """Read SOURCE, a bundled map's name or a file, and save it in a form that opens fast."""
    from ...sources.load import load_network

    with steps(2) as begin:
        begin(f"reading {source}")
        net = load_network(source, **loading)
        begin(f"writing {output}")
        net.save(output)
    click.echo(f"{repr(net)[1:-1]}\n{net.report()}\nSaved: {output}")
