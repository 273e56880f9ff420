"""The command `platoon-osm`: verbs only; the work is done by the package."""

from __future__ import annotations

import argparse
import logging
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from ._version import __version__
from .errors import PlatoonError, ScenarioError
from .study.options import add_study_options

if TYPE_CHECKING:
    from .network.road_network import RoadNetwork
    from .planning.scenario import Scenario
    from .plans.records import JointPlan

__all__ = ["main"]

DEMO_SCENARIOS = ("po-valley-a", "po-valley-b", "po-valley-d", "po-valley-c")
"""Case C comes last: its map is the one the demo writes."""

PLAN_OUTPUTS = ("html", "gpkg", "json", "csv", "flows", "gpx", "figures")
PLAN_FOLDERS = frozenset({"gpx", "figures"})
"""Those that are several files in a folder of their own."""

EPILOG = """examples:
  platoon-osm demo -o out                     plan a corridor in Italy and draw it
  platoon-osm download "Oberfranken, Germany" -o oberfranken.graphml
  platoon-osm prepare germany.osm.pbf --country DE -o germany.platoon
  platoon-osm plan corridor.toml --html plan.html --gpkg plan.gpkg
  platoon-osm compare corridor.toml --cases A,B,C -o compare.html
  platoon-osm study --runs 100 --seed 0 -o out/study
"""


class _Parser(argparse.ArgumentParser):
    """An argument parser that says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, _printable(f"{self.prog}: {message}; see {self.prog} --help") + "\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; return 0, or 2 when the input is wrong."""
    logging.basicConfig(format="%(levelname)s %(name)s: %(message)s", level=logging.WARNING)
    options = _parser().parse_args(arguments)
    try:
        with _ended_as_interrupted():
            options.run(options)
            sys.stdout.flush()
    except PlatoonError as error:
        return _refuse(str(error))
    except BrokenPipeError:
        # The reader of a pipe, such as head, has seen enough; the rest goes nowhere, in silence.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return _refuse(f"{where}{error.strerror or error}; check the path and its rights")
    except KeyboardInterrupt:
        return _refuse("interrupted; nothing was left half written")
    return 0


@contextmanager
def _ended_as_interrupted() -> Iterator[None]:
    """Treat a request to end, as `timeout` and schedulers send it, like Ctrl-C: clean up first."""
    if threading.current_thread() is not threading.main_thread():
        yield  # only there may a handler be set
        return
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def _refuse(message: str) -> int:
    sys.stderr.write(f"platoon-osm: {_printable(message)}\n")
    return 2


def _printable(message: str) -> str:
    # Names from maps reach messages; control characters in them must not reach the terminal.
    return "".join(c if c.isprintable() else " " for c in message)


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="platoon-osm",
        description="Plan joint routes for truck platoons on OpenStreetMap motorway networks.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"platoon-osm {__version__}")
    verbs = parser.add_subparsers(required=True, metavar="VERB", parser_class=_Parser)

    demo = verbs.add_parser("demo", help="plan cases A to D on the bundled map and draw them")
    demo.add_argument("-o", "--output", type=Path, default=Path("out"), help="folder (default out)")
    demo.set_defaults(run=_demo)

    maps = verbs.add_parser("maps", help="list the bundled maps, or report on one map")
    maps.add_argument("source", nargs="?", help="a bundled map's name or a file to report on")
    _add_network_options(maps)
    maps.set_defaults(run=_maps)

    prepare = verbs.add_parser("prepare", help="read a map once, save it in a form that opens fast")
    prepare.add_argument("source", help="a bundled map's name, or a file")
    prepare.add_argument("-o", "--output", type=Path, required=True, help="file.platoon to write")
    _add_network_options(prepare)
    prepare.set_defaults(run=_prepare)

    download = verbs.add_parser("download", help="fetch the motorways of a place from Overpass")
    download.add_argument("place", help="a place name, or west,south,east,north in degrees")
    download.add_argument(
        "-o", "--output", type=Path, required=True, help="file.graphml or file.platoon to write"
    )
    download.add_argument("--classes", default="motorway,motorway_link", help="highway values")
    download.add_argument("--cache", type=Path, default=Path("cache"), help="folder of answers")
    download.add_argument("--overpass-url", help="another Overpass server")
    _add_truck_options(download)
    download.set_defaults(run=_download)

    plan = verbs.add_parser("plan", help="plan a scenario (TOML) and write its map and tables")
    plan.add_argument("scenario", type=Path, help="scenario.toml; see examples/")
    plan.add_argument("--html", type=Path, help="self-contained map to write")
    plan.add_argument("--gpkg", type=Path, help="GeoPackage to write")
    plan.add_argument("--json", type=Path, help="plan as JSON to write")
    plan.add_argument("--csv", type=Path, help="legs as CSV to write")
    plan.add_argument("--flows", type=Path, help="page for many vehicles to write")
    plan.add_argument("--gpx", type=Path, help="folder for a GPX track of each vehicle")
    plan.add_argument("--figures", type=Path, help="folder for figures fit for a paper")
    plan.add_argument("--case", help="A, B, C, D or best, instead of the scenario's")
    plan.set_defaults(run=_plan)

    compare = verbs.add_parser("compare", help="plan a scenario in several ways, side by side")
    compare.add_argument(
        "scenario", type=Path, nargs="+",
        help="scenario.toml; several must name one network, as with other [costs]",
    )  # fmt: skip
    compare.add_argument("--cases", help="such as A,B,C: each scenario in each of these cases")
    compare.add_argument("-o", "--output", type=Path, required=True, help="page.html to write")
    compare.set_defaults(run=_compare)

    study = verbs.add_parser("study", help="repeat the paper's experiment, beside its numbers")
    add_study_options(study)
    study.set_defaults(run=_study)

    warmup = verbs.add_parser(
        "warmup", help="compile the fast engine once, and prepare networks for it",
        description="Compile the fast engine, which takes about half a minute once, so that no "
        "plan waits for it; and build the hierarchy of saved networks (.platoon).",
    )  # fmt: skip
    warmup.add_argument("networks", nargs="*", type=Path, help="saved networks, from `prepare`")
    warmup.set_defaults(run=_warmup)
    return parser


def _add_network_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--classes", default="motorway,motorway_link",
        help="highway values to load, with commas (default motorway,motorway_link)",
    )  # fmt: skip
    _add_truck_options(parser)
    parser.add_argument(
        "--infer-links", action="store_true",
        help="add likely connectors where the map lacks ramps; they are marked inferred",
    )  # fmt: skip


def _add_truck_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--country", help="whose truck speed limit applies: IT, DE, US-CA, ...")
    parser.add_argument(
        "--limiter", type=float, default=90.0, help="speed limiter of the trucks [km/h]"
    )


def _load_options(options: argparse.Namespace) -> dict[str, Any]:
    return {
        "classes": _classes(options.classes),
        "country": options.country,
        "limiter_kmh": options.limiter,
        "infer_links": options.infer_links,
    }


def _classes(text: str) -> tuple[str, ...]:
    classes = tuple(part.strip() for part in text.split(",") if part.strip())
    if not classes:
        raise ScenarioError("--classes: empty; give highway values such as motorway,motorway_link")
    return classes


@contextmanager
def _steps(total: int) -> Iterator[Any]:
    """Show a progress bar on a terminal; yield a function that begins the next step."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    console = Console(stderr=True)
    bar = Progress(
        TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(),
        console=console, transient=True, disable=not console.is_terminal,
    )  # fmt: skip
    with bar:
        task = bar.add_task("", total=total)
        state = {"begun": False}

        def begin(what: str) -> None:
            bar.update(task, description=what, advance=1 if state["begun"] else 0)
            state["begun"] = True

        yield begin


def _say(text: str) -> None:
    sys.stdout.write(text + "\n")


def _demo(options: argparse.Namespace) -> None:
    from .planning.scenario import read_scenario
    from .report.exports.gis import write_geopackage
    from .report.pages.page import write_html
    from .sources.load import load_network

    options.output.mkdir(parents=True, exist_ok=True)
    folder = resources.files("platoon_osm.scenarios")
    with _steps(len(DEMO_SCENARIOS) + 3) as begin:
        begin("loading italy-motorways")
        net = load_network("italy-motorways")
        plans = []
        for name in DEMO_SCENARIOS:
            with resources.as_file(folder / f"{name}.toml") as path:
                scenario = read_scenario(path)
            begin(f"planning {scenario.title}")
            plans.append((scenario.title, scenario.plan(net)))
        title, plan = plans[-1]
        html, package = options.output / "demo.html", options.output / "demo.gpkg"
        begin(f"writing {html}")
        write_html(plan, net, html, title=title)
        begin(f"writing {package}")
        write_geopackage(plan, net, package)
    _say(repr(net)[1:-1])
    for title, plan in plans:
        _say(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    _say(f"\nMap: {html}\nGIS: {package}")


def _maps(options: argparse.Namespace) -> None:
    from .sources.catalog import BUNDLED_MAPS
    from .sources.load import load_network

    if options.source is None:
        for bundled in BUNDLED_MAPS:
            _say(f"{bundled.name}: {bundled.about} ({bundled.licence})")
        return
    net = load_network(options.source, **_load_options(options))
    _say(f"{repr(net)[1:-1]}\n{net.report()}")


def _prepare(options: argparse.Namespace) -> None:
    from .sources.load import load_network

    with _steps(2) as begin:
        begin(f"reading {options.source}")
        net = load_network(options.source, **_load_options(options))
        begin(f"writing {options.output}")
        net.save(options.output)
    _say(f"{repr(net)[1:-1]}\n{net.report()}\nSaved: {options.output}")


def _download(options: argparse.Namespace) -> None:
    from .sources.overpass.download import download
    from .sources.truck import TruckRules

    rules = TruckRules(options.country, options.limiter)
    with _steps(1) as begin:
        begin(f"asking Overpass for {options.place}")
        path = download(
            options.place, options.output, classes=_classes(options.classes),
            cache_dir=options.cache, overpass_url=options.overpass_url, rules=rules,
        )  # fmt: skip
    _say(f"Saved: {path} (© OpenStreetMap contributors, ODbL)")


def _plan(options: argparse.Namespace) -> None:
    from dataclasses import replace

    from .planning.scenario import read_scenario
    from .sources.load import load_network

    scenario = read_scenario(options.scenario)
    if options.case:
        scenario = replace(scenario, options={**scenario.options, "case": options.case})
    outputs = {name: path for name in PLAN_OUTPUTS if (path := getattr(options, name))}
    _check_outputs(path for name, path in outputs.items() if name not in PLAN_FOLDERS)
    with _steps(2 + len(outputs)) as begin:
        begin(f"loading {scenario.network['source']}")
        net = load_network(**scenario.network)
        begin("planning")
        plan = scenario.plan(net)
        for name, path in outputs.items():
            begin(f"writing {path}")
            _write(name, plan, net, path, scenario.title)
    _say(plan.summary())
    for path in outputs.values():
        _say(f"Written: {path}")


def _write(name: str, plan: JointPlan, net: RoadNetwork, path: Path, title: str) -> None:
    """Write one kind of output of a plan."""
    from . import report

    if name == "json":
        plan.write_json(path)
    elif name in ("html", "flows"):
        (report.write_html if name == "html" else report.write_flows)(plan, net, path, title=title)
    else:
        writers: dict[str, Callable[..., Any]] = {
            "gpkg": report.write_geopackage,
            "csv": report.write_csv,
            "gpx": report.write_gpx,
            "figures": report.write_figures,
        }
        if name in PLAN_FOLDERS:
            path.mkdir(parents=True, exist_ok=True)
        writers[name](plan, net, path)


def _check_outputs(paths: Iterable[Path]) -> None:
    for path in paths:
        if not path.parent.is_dir():
            raise ScenarioError(f"{path}: its folder does not exist; make it first")
        if path.is_dir():
            raise ScenarioError(f"{path}: is a folder; give the name of a file to write")


def _compare(options: argparse.Namespace) -> None:
    from .planning.scenario import read_scenario
    from .report.pages.comparison import write_comparison
    from .sources.load import load_network

    scenarios = [read_scenario(path) for path in options.scenario]
    first = scenarios[0]
    for other in scenarios[1:]:
        if other.network != first.network:
            raise ScenarioError(
                f"{other.file}: names another network than {first.file}; compare plans on one"
            )
    _check_outputs([options.output])
    variants = [variant for scenario in scenarios for variant in _in_cases(scenario, options.cases)]
    with _steps(2 + len(variants)) as begin:
        begin(f"loading {first.network['source']}")
        net = load_network(**first.network)
        plans = []
        for title, scenario in variants:
            begin(f"planning {title}")
            plans.append(scenario.plan(net))
        begin(f"writing {options.output}")
        titles = [title for title, _ in variants]
        write_comparison(plans, net, options.output, titles=titles, title=first.title)
    for title, plan in zip(titles, plans, strict=True):
        _say(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    _say(f"\nWritten: {options.output}")


def _in_cases(scenario: Scenario, cases: str | None) -> list[tuple[str, Scenario]]:
    """Return a scenario in each of some cases, with a title; as it stands if there are none."""
    from dataclasses import replace

    if not cases:
        return [(scenario.title, scenario)]
    return [
        (
            f"{scenario.title}, case {case}",
            replace(scenario, options={**scenario.options, "case": case}),
        )
        for case in (part.strip() for part in cases.split(","))
        if case
    ]


def _study(options: argparse.Namespace) -> None:
    from .study.command import run_command

    run_command(options, _say)


def _warmup(options: argparse.Namespace) -> None:
    from .network.saved.store import open_network
    from .search.engine import prepare, warm_up

    with _steps(1 + len(options.networks)) as step:
        step("compiling")
        seconds = warm_up()
        for path in options.networks:
            step(f"preparing {path.name}")
            prepare(open_network(path, verify=True))
    _say(f"The fast engine is ready ({seconds:.1f} s).")


if __name__ == "__main__":
    sys.exit(main())
