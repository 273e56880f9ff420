"""`platoon-osm download`: the motorways of a place, from Overpass."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from ...errors import ScenarioError
from ...output_paths import Output
from ..options import FOLDER, classes_option, output_option, truck_options, was_given
from ..outputs import write_all
from ..progress import steps

__all__ = ["verb"]


@click.command("download", short_help="fetch the motorways of a place from Overpass")
@click.argument("place")
@output_option("file.graphml or file.platoon to write.", (".graphml", ".platoon"))
@classes_option
@click.option("--cache", type=FOLDER, default="cache", help="Folder of answers to keep.")
@click.option("--overpass-url", help="Another Overpass server.")
@truck_options
def verb(
    place: str,
    output: Output,
    classes: tuple[str, ...],
    cache: Path,
    overpass_url: str | None,
    **truck: Any,
) -> None:
    """Fetch the motorways of PLACE, a name or west,south,east,north in degrees, from Overpass."""
    from ...sources.overpass.download import download
    from ...sources.truck import TruckRules

    rules = TruckRules(**truck)
    if output.path is not None and output.path.suffix.lower() != ".platoon":
        for name, option in (("country", "--country"), ("limiter_kmh", "--limiter")):
            if was_given(click.get_current_context(), name):
                raise ScenarioError(
                    f"{option}: GraphML keeps what the map says; give it when you load the file, "
                    "or write file.platoon"
                )

    def write(path: Path) -> None:
        download(
            place, path, classes=classes, cache_dir=cache, overpass_url=overpass_url, rules=rules
        )

    with steps(1) as begin:
        write_all([(output, write)], lambda _: begin(f"asking Overpass for {place}"))
    click.echo(f"Saved: {output.path} (© OpenStreetMap contributors, ODbL)")
