"""`platoon-osm warmup`: the fast engine is compiled before anybody waits for it."""

from __future__ import annotations

from pathlib import Path

import click

from ..options import FILE
from ..progress import steps

__all__ = ["verb"]


@click.command("warmup", short_help="compile the fast engine once, and prepare networks for it")
@click.argument("networks", type=FILE, nargs=-1)
def verb(networks: tuple[Path, ...]) -> None:
    """Compile the fast engine, which takes about half a minute once, so that no plan waits for it.

    NETWORKS are saved networks (.platoon), from `prepare`, whose hierarchy is built too.
    """
    from ...network.saved.store import open_network
    from ...search.engine import prepare, warm_up

    with steps(1 + len(networks)) as begin:
        begin("compiling")
        seconds = warm_up()
        for path in networks:
            begin(f"preparing {path.name}")
            prepare(open_network(path, verify=True))
    click.echo(f"The fast engine is ready ({seconds:.1f} s).")
