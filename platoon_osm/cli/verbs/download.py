"""`platoon-osm download`: the motorways of a place, from Overpass."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ..options import FOLDER, classes_option, output_option, truck_options
from ..progress import steps

__all__ = ["verb"]


@click.command("download", short_help="fetch the motorways of a place from Overpass")
@click.argument("place")
@output_option(help="file.graphml or file.platoon to write.")
@classes_option
@click.option("--cache", type=FOLDER, default="cache", help="Folder of answers to keep.")
@click.option("--overpass-url", help="Another Overpass server.")
@truck_options
def verb(
    place: str,
    output: Path,
    classes: tuple[str, ...],
    cache: Path,
    overpass_url: str | None,
    **truck: Any,
) -> None:
    """Fetch the motorways of PLACE, a name or west,south,east,north in degrees, from Overpass."""
    from ...sources.overpass.download import download
    from ...sources.truck import TruckRules

    rules = TruckRules(**truck)
    with steps(1) as begin:
        begin(f"asking Overpass for {place}")
        path = download(
            place, output, classes=classes, cache_dir=cache, overpass_url=overpass_url, rules=rules
        )
    click.echo(f"Saved: {path} (© OpenStreetMap contributors, ODbL)")
