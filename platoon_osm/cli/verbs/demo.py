"""`platoon-osm demo`: a corridor in northern Italy, planned in every case and drawn."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import click

from ..options import FOLDER
from ..progress import steps

__all__ = ["verb"]

SCENARIOS = ("po-valley-a", "po-valley-b", "po-valley-d", "po-valley-c")
"""Case C comes last: its map is the one that is written."""


@click.command("demo", short_help="plan cases A to D on the bundled map and draw them")
@click.option("-o", "--output", type=FOLDER, default="out", help="Folder to write into.")
def verb(output: Path) -> None:
    """Plan a corridor in northern Italy in cases A to D, on the bundled map.

    Writes demo.html, a page to open in any browser, and demo.gpkg, for a GIS; both show case C.
    """
    from ...planning.scenario import read_scenario
    from ...report.exporters import EXPORTERS
    from ...sources.load import load_network

    output.mkdir(parents=True, exist_ok=True)
    folder = resources.files("platoon_osm.scenarios")
    files = {name: output / f"demo{EXPORTERS[name].suffix}" for name in ("html", "gpkg")}
    with steps(1 + len(SCENARIOS) + len(files)) as begin:
        begin("loading italy-motorways")
        net = load_network("italy-motorways")
        plans = []
        for name in SCENARIOS:
            with resources.as_file(folder / f"{name}.toml") as path:
                scenario = read_scenario(path)
            begin(f"planning {scenario.title}")
            plans.append((scenario.title, scenario.plan(net)))
        title, plan = plans[-1]
        for name, file in files.items():
            begin(f"writing {file}")
            EXPORTERS[name].write(plan, net, file, title=title)
    click.echo(repr(net)[1:-1])
    for title, plan in plans:
        click.echo(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    click.echo(f"\nMap: {files['html']}\nGIS: {files['gpkg']}")
