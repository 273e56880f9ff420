"""The report of a study put together: its figures with what is said of them, and the page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ..report.language.speech import say
from .answer import answer_of
from .comparison import Row, placing
from .example import Example
from .figures import cost_figure, involvement_figure, network_figure, save_figure
from .monte_carlo import StudyResult
from .page import Picture, StudyPage, write_page
from .parameters import parameters_in_words
from .shown_tables import shown_tables
from .verdict import conclusions
from .wording import called, mixed, summed

__all__ = ["draw_figures", "write_report"]


def draw_figures(
    results: Sequence[StudyResult], drawn: Sequence[tuple[StudyResult, Example]], output: Path
) -> list[Picture]:
    """Draw all figures, with titles and captions in the language that is spoken.

    Parameters
    ----------
    results : sequence of StudyResult
        Of all readings, the first of which the figures of costs show.
    drawn : sequence of (StudyResult, Example)
        The runs to be drawn as networks.
    output : Path
        Folder that exists.

    Returns
    -------
    list of Picture
        In the order in which the page shows them; a PNG lies beside each.
    """
    first = results[0]
    study = first.study
    shown = [(placing(result), example) for result, example in drawn]
    network = Picture(
        say("study-figures.network"),
        say("study-figures.network-caption") + _credit(results),
        say("study-figures.network-alt", n=len(drawn)),
        save_figure(network_figure(shown), output / "figure-1-network")[1],
        "network",
    )
    costs = Picture(
        say("study-figures.costs"),
        say(
            "study-figures.costs-caption",
            method=called(study.methods[0]),
            terms=summed(study.terms[0]),
            place=placing(first),
        ),
        say("study-figures.costs-alt"),
        save_figure(cost_figure(first), output / "figure-2-costs")[1],
        "costs",
    )
    involved = [
        Picture(
            say("study-figures.involved", method=called(method)),
            say(
                "study-figures.involved-caption",
                mixing=mixed(study.mixings[0]),
                terms=summed(study.terms[0]),
            ),
            say("study-figures.involved-alt", n=len(results)),
            save_figure(
                involvement_figure(results, method),
                output / f"figure-{number}-involvement-{method}",
            )[1],
            method,
        )
        for number, method in enumerate(("dijkstra", "astar", "astar-closed-once"), 3)
        if method in study.methods
    ]
    return [network, costs, *involved]


def write_report(
    path: Path,
    results: Sequence[StudyResult],
    rows: Sequence[Row],
    pictures: Sequence[Picture],
    command: str,
) -> None:
    """Write the page of a study in the language that is spoken.

    Parameters
    ----------
    path : Path
        The file to write.
    results : sequence of StudyResult
        Of all readings.
    rows : sequence of Row
        Of `compare`.
    pictures : sequence of Picture
        Of `draw_figures`.
    command : str
        What to type for the same numbers.
    """
    plain = {"seed": results[0].seed, "studies": [result.study.to_dict() for result in results]}
    page = StudyPage(
        answer_of(rows, results),
        conclusions(rows, results),
        pictures,
        shown_tables(results, rows),
        parameters_in_words(results),
        plain,
        command,
    )
    write_page(path, page)


def _credit(results: Sequence[StudyResult]) -> str:
    """Return whose map the trips were drawn on; random networks are nobody's."""
    from .road_trips import RoadTrips

    sources = dict.fromkeys(
        f"{net.source.attribution}, {net.source.licence}"
        for r in results
        if isinstance(r.study.network, RoadTrips)
        and (net := r.study.network.net).source.attribution
    )
    return " " + say("study-figures.roads", credits="; ".join(sources)) if sources else ""
