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
    results: Sequence[StudyResult], output: Path, command: str, language: str | None = None
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
    language : str or None
        Of report and figures, such as "de"; None for that which is spoken already. Tables of data
        are in English.

    Returns
    -------
    written : list of Path
        Files, in the order in which they were written.
    paragraph : str
        The verdict, in English.
    table : str
        The comparison as Markdown, in English.
    """
    from ..report.language.speech import speaking
    from . import tables
    from .comparison import compare, network_label
    from .example import example_of
    from .shown_tables import markdown, shown_tables
    from .verdict import verdict
    from .written_page import draw_figures, write_report

    rows = compare(results)
    drawn = [(result, example_of(result)) for result in _to_draw(results)]
    with speaking(language):
        pictures = draw_figures(results, drawn, output)
    written = []
    for picture in pictures:
        data = picture.file.with_suffix(".csv")
        if picture.shows == "network":
            tables.write_network(data, [(network_label(one), example) for one, example in drawn])
        elif picture.shows == "costs":
            tables.write_costs(data, results)
        else:
            tables.write_involvement(data, results, picture.shows)
        written += [data, picture.file.with_suffix(".png"), picture.file]
    tables.write_comparison(output / "comparison.csv", rows)
    tables.write_parquet(output / "results.parquet", results)
    with speaking(language):
        write_report(output / "report.html", results, rows, pictures, command)
    written += [output / name for name in ("comparison.csv", "results.parquet", "report.html")]
    with speaking("en"):
        paragraph = verdict(rows, results)
        how = f"Measured by `{command}`. Brackets hold 95 % bootstrap intervals over networks."
        return written, paragraph, markdown(shown_tables(results, rows), paragraph, how)


def _to_draw(results: Sequence[StudyResult]) -> list[StudyResult]:
    """Choose the first placing, and one with a wide circle to look at beside it."""
    wide = [r for r in results[1:] if r.study.network.spawn_diameter_m >= 4e5]
    return [results[0], *wide[:1]]


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
