"""What `platoon-osm study` does: runs, figures, tables and the report."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager
from dataclasses import fields
from pathlib import Path
from typing import Any

from ..atomic_file import all_or_none, filled_folder, whole_file
from ..errors import ScenarioError, brief
from ..output_paths import Output, check_outputs
from ..shown_text import well_formed
from .monte_carlo import StudyResult, run_study
from .options import StudyOptions
from .parts import kept_folder, part_path
from .settings import Study
from .workers import workers

__all__ = ["run_command", "studies_of", "write_results"]

HOLDS = ("figure-*", "comparison.csv", "results.parquet", "report.html", "runs")
"""What a study writes into its folder."""

MARKS = "<!-- study:begin -->", "<!-- study:end -->"


def studies_of(options: StudyOptions) -> list[Study]:
    """Return one study for each reading of how vehicles are placed.

    Parameters
    ----------
    options : StudyOptions
        What was chosen.

    Returns
    -------
    list of Study
        By spawning, then by diameter; by diameter alone on a real network.

    Raises
    ------
    ScenarioError
        An option out of range.
    """
    from .random_network import RandomNetwork

    grid = options.grid
    if grid < 1:
        raise ScenarioError(f"--grid {grid}: give 1 or more values of tau and of xi")
    axis = tuple(round(k / max(grid - 1, 1), 12) for k in range(grid))
    shared: dict[str, Any] = {
        "runs": options.runs, "case": options.case, "methods": _list(options.method),
        "mixings": _list(options.mixing), "terms": _list(options.terms), "tau": axis, "xi": axis,
    }  # fmt: skip
    default = "200" if options.network else "1,200,400,600"
    diameters = [_km("--diameter-km", part) for part in _list(options.diameter_km or default)]
    if options.network:
        return [Study(network=trips, **shared) for trips in _road_trips(options, diameters)]
    if options.flows:
        raise ScenarioError("--flows: flows belong to a real network; give --network too")
    km = 1000.0
    placings = _list(options.spawning)
    if not placings or not diameters:
        raise ScenarioError("--spawning, --diameter-km: give at least one of each")
    return [
        Study(
            network=RandomNetwork(
                width_m=options.area_km * km, height_m=options.area_km * km, nodes=options.nodes,
                edges=options.edges, dropout=options.dropout, spawn_diameter_m=diameter,
                min_route_m=options.min_route_km * km, vehicles=options.vehicles,
                pruning=options.pruning, directed=options.directed, connected=options.connected,
                spawning=spawning, access_nodes=options.access_nodes,
                route_length=options.route_length,
            ),
            **shared,
        )
        for spawning in placings
        for diameter in diameters
    ]  # fmt: skip


def _road_trips(options: StudyOptions, diameters: Sequence[float]) -> Iterator[Any]:
    from ..sources.load import load_network
    from .road_trips import RoadTrips, read_flows

    net = load_network(
        options.network, _list(options.classes), country=options.country,
        infer_links=options.infer_links,
    )  # fmt: skip
    flows = read_flows(options.flows, net) if options.flows else None
    for diameter in diameters:
        yield RoadTrips(net, options.vehicles, diameter, options.min_route_km * 1000, flows)


def _list(text: str) -> tuple[Any, ...]:
    return tuple(part.strip() for part in text.split(",") if part.strip())


def _km(option: str, text: str) -> float:
    try:
        return float(text) * 1000
    except ValueError:
        raise ScenarioError(f"{option} {brief(text)}: give numbers of km, with commas") from None


def run_command(
    options: StudyOptions,
    say: Callable[[str], None],
    counted: Callable[[int], AbstractContextManager[Callable[[int], None]]],
) -> None:
    """Run all readings, write everything, and say what came out.

    Parameters
    ----------
    options : StudyOptions
        What was chosen.
    say : callable
        Prints a line.
    counted : callable
        Shows how many of so many networks are done: a context that gives a function to count with.

    Raises
    ------
    ScenarioError
        An option out of range, or a file where the folder should be.
    """
    studies = studies_of(options)
    if options.table is not None:
        _marked(options.table)
    if options.workers is not None and options.workers < 1:
        raise ScenarioError(f"--workers {options.workers}: give 1 or more")
    check_outputs(*_written(options))
    with kept_folder(options.output):
        results = _run(studies, options, counted)
        with all_or_none():
            with filled_folder(options.output) as draft:
                files, paragraph, table = write_results(results, draft, _command(options))
            written = [options.output / file.name for file in files]
            if options.table is not None:
                _renew(options.table, table)
                written.append(options.table)
    say(paragraph)
    for path in written:
        say(f"Written: {path}")


def _run(
    studies: Sequence[Study],
    options: StudyOptions,
    counted: Callable[[int], AbstractContextManager[Callable[[int], None]]],
) -> list[StudyResult]:
    """Run all readings; who interrupts it hears how many runs are kept, and where."""
    folder = options.output / "runs"
    networks = sum(study.runs for study in studies)
    try:
        with workers(options.workers) as executor, counted(networks) as advance:
            return [run_study(study, options.seed, executor, folder, advance) for study in studies]
    except KeyboardInterrupt:
        kept = sum(
            part_path(folder, study.key(options.seed), run).is_file()
            for study in studies
            for run in range(study.runs)
        )
        raise KeyboardInterrupt(
            f"{kept:,} of {networks:,} runs are kept in {folder}, and the same command goes on "
            "from there"
            if kept
            else f"none of {networks:,} runs was finished, and nothing is kept"
        ) from None


def _written(options: StudyOptions) -> tuple[list[Output], list[Path]]:
    """Return what a study writes and which files it reads."""
    outputs = [Output("-o", options.output, holds=HOLDS)]
    if options.table is not None:
        outputs.append(Output("--table", options.table))
    read = [Path(options.network)] if options.network else []
    if options.flows is not None:
        read += [options.flows, options.flows.with_name("segments.csv")]
    return outputs, read


def write_results(
    results: Sequence[StudyResult], output: Path, command: str
) -> tuple[list[Path], str, str]:
    """Write figures, tables and report.

    Parameters
    ----------
    results : sequence of StudyResult
        Of all readings, the first of which the figures of costs show.
    output : Path
        Folder that exists.
    command : str
        What to type for the same numbers.

    Returns
    -------
    written : list of Path
        Files, in the order in which they were written.
    paragraph : str
        The verdict.
    table : str
        The comparison as Markdown.
    """
    from . import figures, tables
    from .answer import answer_of
    from .comparison import compare, network_label
    from .example import example_of
    from .page import Picture, StudyPage, write_page
    from .parameters import parameters_in_words
    from .shown_tables import CALLED, MIXED, markdown, shown_tables
    from .verdict import verdict

    rows = compare(results)
    first = results[0]
    study = first.study
    examples = [(network_label(r), example_of(r)) for r in _to_draw(results)]
    path = output / "figure-1-network"
    tables.write_network(path.with_suffix(".csv"), examples)
    drawn = [(path, figures.save_figure(figures.network_figure(examples), path),
              "Networks and the longest platoon",
              "Roads grey, the longest platoon red, other routes coloured, spawn points as dots, "
              f"with time counted in full (tau = 100 %) and xi = 18 %.{_credit(results)}",
              f"{len(examples)} road networks, each with the routes of its vehicles from nearby "
              "starts and the longest platoon among them.")]  # fmt: skip
    path = output / "figure-2-costs"
    tables.write_costs(path.with_suffix(".csv"), results)
    drawn.append((path, figures.save_figure(figures.cost_figure(first), path),
                  "What a vehicle costs alone and together",
                  f"Mean cost over the weights tau and xi by {CALLED[study.methods[0]]}; terms "
                  f"{study.terms[0].replace('+', ' + ')}, vehicles at {network_label(first)}. "
                  "The ring marks tau = 100 %, xi = 18 %.",
                  "Surfaces over tau and xi: the cost alone is level, the joint cost lies below "
                  "it; Table 4 has the least and the greatest values."))  # fmt: skip
    for number, method in ((3, "dijkstra"), (4, "astar"), (5, "astar-closed-once")):
        if method in study.methods:
            path = output / f"figure-{number}-involvement-{method}"
            tables.write_involvement(path.with_suffix(".csv"), results, method)
            drawn.append((
                path, figures.save_figure(figures.involvement_figure(results, method), path),
                f"Members that join a platoon, {CALLED[method]}",
                f"Rates tau and xi {MIXED[study.mixings[0]]}; terms "
                f"{study.terms[0].replace('+', ' + ')}. A column for each placing of the vehicles.",
                f"Shares of members over tau and xi, for {len(results)} placings; Table 3 has "
                "their means.",
            ))  # fmt: skip
    tables.write_comparison(output / "comparison.csv", rows)
    tables.write_parquet(output / "results.parquet", results)
    shown, paragraph = shown_tables(results, rows), verdict(rows, results)
    pictures = [Picture(title, caption, alt, files[1]) for _, files, title, caption, alt in drawn]
    plain = {"seed": first.seed, "studies": [r.study.to_dict() for r in results]}
    write_page(output / "report.html", StudyPage(
        answer_of(rows, results), paragraph, pictures, shown, parameters_in_words(results), plain,
        command,
    ))  # fmt: skip
    written = [file for path, files, *_ in drawn for file in (path.with_suffix(".csv"), *files)]
    written += [output / name for name in ("comparison.csv", "results.parquet", "report.html")]
    how = f"Measured by `{command}`. Brackets hold 95 % bootstrap intervals over networks."
    return written, paragraph, markdown(shown, paragraph, how)


def _to_draw(results: Sequence[StudyResult]) -> list[StudyResult]:
    """Choose the first placing, and one with a wide circle to look at beside it."""
    wide = [r for r in results[1:] if r.study.network.spawn_diameter_m >= 4e5]
    return [results[0], *wide[:1]]


def _credit(results: Sequence[StudyResult]) -> str:
    """Return whose map the trips were drawn on; random networks are nobody's."""
    from .road_trips import RoadTrips

    sources = dict.fromkeys(
        f"{net.source.attribution}, {net.source.licence}"
        for r in results
        if isinstance(r.study.network, RoadTrips)
        and (net := r.study.network.net).source.attribution
    )
    return f" Roads: {'; '.join(sources)}." if sources else ""


def _command(options: StudyOptions) -> str:
    """Return what to type for the same numbers; paths and workers do not change them."""
    typed = ["platoon-osm study"]
    for field in sorted(fields(options), key=lambda field: field.name):
        name, value = field.name, getattr(options, field.name)
        if name in ("output", "workers", "table"):
            continue
        if value == field.default and name not in ("runs", "seed"):
            continue
        shown = Path(value).name if isinstance(value, Path) or name == "network" else value
        typed.append(f"--{name.replace('_', '-')}" + ("" if value is True else f" {shown}"))
    return well_formed(" ".join(typed))


def _marked(path: Path) -> str:
    try:
        document = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{path}: cannot be read ({error}); name a Markdown file") from None
    if MARKS[0] not in document or MARKS[1] not in document:
        raise ScenarioError(f"{path}: has no lines {MARKS[0]} and {MARKS[1]}")
    return document


def _renew(path: Path, text: str) -> None:
    pattern = re.compile(re.escape(MARKS[0]) + ".*?" + re.escape(MARKS[1]), re.DOTALL)
    section = f"{MARKS[0]}\n{text}\n{MARKS[1]}"
    document = pattern.sub(lambda _: section, _marked(path), count=1)
    with whole_file(path) as draft:
        draft.write_text(document, encoding="utf-8")
