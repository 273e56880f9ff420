"""`platoon-osm prepare`: a map is read once and saved in a form that opens fast."""

from __future__ import annotations

from typing import Any

import click

from ...output_paths import SAVED, Output, check_outputs
from ..options import network_options, output_option
from ..outputs import existing_files, write_all
from ..progress import steps

__all__ = ["verb"]


@click.command("prepare", short_help="read a map once, save it in a form that opens fast")
@click.argument("source")
@output_option("file.platoon to write.", SAVED)
@network_options
def verb(source: str, output: Output, **loading: Any) -> None:
    """Read SOURCE, a bundled map's name or a file, and save it in a form that opens fast."""
    from ...sources.load import load_network

    check_outputs([output], existing_files(source))
    with steps(2) as begin:
        begin(f"reading {source}")
        net = load_network(source, **loading)
        write_all([(output, net.save)], begin)
    click.echo(f"{repr(net)[1:-1]}\n{net.report()}\nSaved: {output.path}")
