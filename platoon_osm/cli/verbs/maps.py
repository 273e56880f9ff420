"""`platoon-osm maps`: which maps there are, and what one holds."""

from __future__ import annotations

from typing import Any

import click

from ...errors import ScenarioError
from ..options import network_options, was_given

__all__ = ["verb"]


@click.command("maps", short_help="list maps and kinds of file, or report on one map")
@click.argument("source", required=False)
@network_options
def verb(source: str | None, **loading: Any) -> None:
    """List the bundled maps and the files that can be read; or load SOURCE and report on it.

    The report counts what was kept, what was dropped, and what had to be assumed.

    SOURCE is a bundled map's name or a file to report on.
    """
    from ...sources.catalog import BUNDLED_MAPS
    from ...sources.load import load_network
    from ...sources.readers import READERS

    if source is None:
        for option in (ctx := click.get_current_context()).command.params:
            if option.name and was_given(ctx, option.name):
                raise ScenarioError(f"{option.opts[0]}: is for loading a map; name one beside it")
        for bundled in BUNDLED_MAPS.values():
            click.echo(f"{bundled.name}: {bundled.about} ({bundled.licence})")
        click.echo("\nFiles that can be read:")
        for reader in READERS.values():
            click.echo(f"{', '.join(reader.suffixes) or reader.name}: {reader.about}")
        return
    net = load_network(source, **loading)
    click.echo(f"{repr(net)[1:-1]}\n{net.report()}")
