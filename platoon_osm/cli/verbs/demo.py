"""`platoon-osm demo`: a corridor in northern Italy, planned in every case and drawn."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import click

from ...output_paths import Output, check_outputs
from ..exit_status import end_if_late
from ..language import language_options
from ..outputs import output_kind, write_all
from ..progress import steps

__all__ = ["verb"]

SCENARIOS = ("po-valley-a", "po-valley-b", "po-valley-d", "po-valley-c")
"""Case C comes last: its map is the one that is written."""


@click.command("demo", short_help="plan cases A to D on the bundled map and draw them")
@click.option(
    "-o", "--output", type=output_kind("-o", holds=("demo.html", "demo.gpkg")), metavar="FOLDER",
    default="out", help="Folder to write into.",
)  # fmt: skip
@language_options
def verb(output: Output) -> None:
    """Plan a corridor in northern Italy in cases A to D, on the bundled map.

    Writes demo.html, a page to open in any browser, and demo.gpkg, for a GIS; both show case C.
    """
    from ...planning.scenario import read_scenario
    from ...report.exporters import EXPORTERS
    from ...sources.load import load_network

    assert output.path is not None  # a folder is no stream
    folder = resources.files("platoon_osm.scenarios")
    files = {name: output.path / f"demo{EXPORTERS[name].suffix}" for name in ("html", "gpkg")}
    if output.path.is_dir():
        check_outputs([Output("-o", file) for file in files.values()])
    with steps(2 + len(SCENARIOS)) as begin:
        begin("loading italy-motorways")
        net = load_network("italy-motorways")
        plans = []
        for name in SCENARIOS:
            with resources.as_file(folder / f"{name}.toml") as path:
                scenario = read_scenario(path)
            begin(f"planning {scenario.title}")
            plans.append((scenario.title, scenario.plan(net)))
        title, plan = plans[-1]

        def write(into: Path) -> None:
            for name, file in files.items():
                EXPORTERS[name].write(plan, net, into / file.name, title=title)

        write_all([(output, write)], begin)
    click.echo(repr(net)[1:-1])
    for title, plan in plans:
        click.echo(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    click.echo(f"\nMap: {files['html']}\nGIS: {files['gpkg']}")
    end_if_late([plan for _, plan in plans])
