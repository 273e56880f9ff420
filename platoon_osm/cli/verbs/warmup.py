"""`platoon-osm warmup`: the fast engine is compiled before anybody waits for it."""

from __future__ import annotations

from pathlib import Path

import click

from ..progress import steps

__all__ = ["verb"]


@click.command("warmup", short_help="compile the fast engine once, and prepare networks for it")
@click.argument("networks", nargs=-1)
def verb(networks: tuple[str, ...]) -> None:
    """Compile the fast engine, which takes about a minute once, so that no plan waits for it.

    NETWORKS are saved networks (.platoon), from `prepare`, whose hierarchy is built too and kept
    beside them. Other maps, by file or name, are tried with it; nothing is kept beside those.
    """
    from time import perf_counter

    from ...fleets import warmth as fleets
    from ...inspection.certificate import warmth as certificate
    from ...network.saved.store import open_network
    from ...planning.legal import warmth
    from ...planning.timing import kernels
    from ...search.engine import prepare, warm_up
    from ...sources.load import load_network

    tried = []
    with steps(1 + len(networks)) as begin:
        # A slip in a name is told at once, not after a minute.
        nets = [(name, load_network(name)) for name in networks]
        begin("compiling")
        begun = perf_counter()
        warm_up()
        kernels.warm_up()
        warmth.warm_up()
        fleets.warm_up(waits=True)
        certificate.warm_up()
        seconds = perf_counter() - begun
        for name, net in nets:
            begin(f"preparing {name}")
            if net.file is None:
                tried.append(name)
                prepare(net)
            else:
                prepare(open_network(net.file, verify=True))
    click.echo(f"The fast engine is ready ({seconds:.1f} s).")
    for name in tried:
        click.echo(
            f"{name}: works with it; to keep its preparation too, save it with "
            f"platoon-osm prepare {name} -o {Path(name).name.split('.')[0] or 'map'}.platoon"
        )
