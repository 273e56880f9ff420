"""The report of a study in one file that asks for nothing: the answer first, then its grounds."""

from __future__ import annotations

import base64
import hashlib
import html
import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

from .._version import __version__
from ..atomic_file import whole_file
from ..shown_text import well_formed
from .answer import Answer
from .page_style import style
from .shown_tables import ShownTable

__all__ = ["Picture", "StudyPage", "write_page"]

READINGS = (
    ("Vehicles",
     "How wide the circle is in which all start, and whether they start at any point in it or at "
     "nodes of the network."),
    ("Tau and xi",
     "Weights of time and of fuel in a platoon, 0 to 100 %. As printed, xi = 18 % counts 18 % of "
     "the fuel; as gains, it saves 18 % of it."),
    ("Terms", "What a road costs: distance, time and fuel, or some of them."),
    ("A*, nodes opened again",
     "The paper's condition to the letter: a node that was explored comes back when a cheaper way "
     "to it is found."),
    ("A*, each node once",
     "The shorter form that is often programmed: such ways are lost, and routes are dearer. Both "
     "inflate the heuristic by fatigue, so neither finds the best route for sure."),
    ("Members, with master",
     "Costs of those who join alone, or of the vehicle they join too."),
    ("Joined; merges and separates; inside the master's route",
     "Who takes part: whoever joins; who also drives roads alone before and after; who does so "
     "while the master is under way before and after too."),
    ("Numbers in brackets", "95 % bootstrap intervals over networks."),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure of the page.

    Attributes
    ----------
    title : str
        Its heading.
    caption : str
        What is to be seen.
    alt : str
        What it shows, for who cannot see it.
    file : Path
        SVG.
    """

    title: str
    caption: str
    alt: str
    file: Path


@dataclass(frozen=True, slots=True)
class StudyPage:
    """What the page of a study shows.

    Attributes
    ----------
    answer : Answer
        What it comes to.
    paragraph : str
        The same in full.
    pictures : sequence of Picture
        The figures.
    tables : sequence of ShownTable
        The comparison.
    parameters : sequence of (str, str)
        In words.
    plain : dict
        The parameters in plain JSON types.
    command : str
        What to type to get the same.
    """

    answer: Answer
    paragraph: str
    pictures: Sequence[Picture]
    tables: Sequence[ShownTable]
    parameters: Sequence[tuple[str, str]]
    plain: dict[str, Any]
    command: str


def write_page(path: Path, page: StudyPage) -> None:
    """Write the report.

    Parameters
    ----------
    path : Path
        The file to write.
    page : StudyPage
        What it shows.

    Raises
    ------
    ScenarioError
        The file cannot be written.
    """
    css = style()
    digest = base64.b64encode(hashlib.sha256(css.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; img-src data:; style-src 'sha256-{digest}'; base-uri 'none'; "
        "form-action 'none'"
    )
    lines = [
        "<!doctype html>", '<html lang="en" dir="ltr">', "<head>", '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{html.escape(policy)}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="referrer" content="no-referrer">',
        "<title>Platoon study</title>", f"<style>{css}</style>", "</head>", "<body>",
        '<a class="skip" href="#answer">Skip to the answer</a>',
        "<header>", "<h1>The paper’s experiment, and ours beside it</h1>",
        '<p class="sub">Adas et al., Joint Travel Route Optimization Framework for Platooning, '
        "IFAC 2025</p>",
        '<nav aria-label="Parts of this page"><ul>',
        *(f'<li><a href="#{to}">{name}</a></li>' for to, name in PARTS),
        "</ul></nav>", "</header>", "<main>",
        *_answer(page.answer, page.paragraph), *_pictures(page.pictures), *_tables(page.tables),
        *_readings(), *_parameters(page.parameters, page.plain), "</main>",
        f"<footer><p>Made by platoon_osm {html.escape(__version__)} with "
        f"<code>{html.escape(page.command)}</code>; the same command gives the same numbers.</p>"
        "</footer>",
        "</body>", "</html>",
    ]  # fmt: skip
    with whole_file(path) as draft:
        draft.write_text(well_formed("\n".join(lines)) + "\n", encoding="utf-8")


PARTS = (
    ("answer", "Answer"), ("figures", "Figures"), ("comparison", "Tables"),
    ("readings", "How to read them"), ("parameters", "Parameters"),
)  # fmt: skip


def _section(name: str, title: str, inside: Iterator[str]) -> Iterator[str]:
    yield f'<section id="{name}" aria-labelledby="h-{name}"><h2 id="h-{name}">{title}</h2>'
    yield from inside
    yield "</section>"


def _answer(answer: Answer, paragraph: str) -> Iterator[str]:
    text = html.escape

    def inside() -> Iterator[str]:
        yield f'<p class="verdict agrees-{answer.standing}">{text(answer.verdict)}</p>'
        yield f"<p>{_unbroken(answer.asked)} {_unbroken(answer.found)}</p>"
        yield _box("t-answer", "The paper's numbers and ours", short=True)
        yield (
            '<table><thead><tr><th scope="col" class="label">Number</th><th scope="col">Paper</th>'
            '<th scope="col">Ours</th><th scope="col">95 % interval</th><th scope="col">Agrees</th>'
            "</tr></thead><tbody>"
        )
        for number in answer.numbers:
            mark = ("yes", "yes") if number.agrees else ("no", "no")
            yield (
                f'<tr><th scope="row" class="label">{text(number.label)}</th>'
                f"<td>{text(number.paper)}</td><td>{text(number.ours)}</td>"
                f"<td>{text(number.interval) or '–'}</td>"
                f'<td><span class="mark {mark[0]}">{mark[1]}</span></td></tr>'
            )
        yield f'</tbody></table></div><p class="caption">{_unbroken(answer.reading)}</p>'
        yield "<h3>In full</h3><ul>"
        yield from (f"<li>{_unbroken(sentence)}</li>" for sentence in _sentences(paragraph))
        yield "</ul>"

    return _section("answer", "The answer", inside())


def _unbroken(text: str) -> str:
    """Return a text as HTML in which no line ends between a number and its sign."""
    return html.escape(text).replace(" %", "&nbsp;%")


def _sentences(paragraph: str) -> list[str]:
    """Return the sentences of a paragraph; one ends at a stop before a capital letter."""
    return re.split(r"(?<=\.) (?=[A-Z])", paragraph)


def _pictures(pictures: Sequence[Picture]) -> Iterator[str]:
    def inside() -> Iterator[str]:
        for number, picture in enumerate(pictures, 1):
            data = base64.b64encode(picture.file.read_bytes()).decode()
            title = html.escape(f"Figure {number}. {picture.title}")
            yield f'<figure aria-labelledby="f-{number}"><h3 id="f-{number}">{title}</h3>'
            yield f'<div class="sheet" tabindex="0" role="region" aria-label="{title}">'
            yield f'<img src="data:image/svg+xml;base64,{data}" alt="{html.escape(picture.alt)}">'
            yield f"</div><figcaption>{html.escape(picture.caption)}</figcaption></figure>"

    return _section("figures", "Figures", inside())


def _tables(tables: Sequence[ShownTable]) -> Iterator[str]:
    def inside() -> Iterator[str]:
        for number, table in enumerate(tables, 1):
            title = html.escape(f"Table {number}. {table.title}")
            yield f'<div class="entry"><h3 id="t-{number}">{title}</h3>'
            yield f'<p class="caption" id="c-{number}">{html.escape(table.caption)}</p>'
            yield _box(f"t-{number}")
            yield f'<table aria-labelledby="t-{number}" aria-describedby="c-{number}">'
            yield from _head(table)
            yield "<tbody>"
            parts = _parts(table)
            for row in table.rows:
                cells = [
                    _cell(cell, column < table.labels, column in parts)
                    for column, cell in enumerate(row)
                ]
                yield f"<tr>{''.join(cells)}</tr>"
            yield "</tbody></table></div></div>"

    return _section("comparison", "Every printed number beside ours", inside())


def _box(named_by: str, name: str = "", *, short: bool = False) -> str:
    """Return the beginning of a box that scrolls, by keys too."""
    label = f'aria-label="{html.escape(name)}"' if name else f'aria-labelledby="{named_by}"'
    return f'<div class="box{" short" if short else ""}" tabindex="0" role="region" {label}>'


def _parts(table: ShownTable) -> set[int]:
    """Return the columns at which a group of columns begins."""
    heads = table.heads
    return {
        column
        for column in range(1, len(heads))
        if heads[column][0] != heads[column - 1][0] and heads[column][0]
    }


def _head(table: ShownTable) -> Iterator[str]:
    text = html.escape
    is_grouped = any(group for group, _ in table.heads)
    yield "<thead>"
    above: list[str] = []
    below: list[str] = []
    column = 0
    for group, members in groupby(table.heads, key=lambda head: head[0]):
        own = [name for _, name in members]
        if group:
            above.append(
                f'<th scope="colgroup" colspan="{len(own)}" class="part">{text(group)}</th>'
            )
        for number, name in enumerate(own):
            kind = "label" if column < table.labels else "part" if group and not number else ""
            span = ' rowspan="2"' if is_grouped and not group else ""
            head = f'<th scope="col"{span}{f" class={chr(34)}{kind}{chr(34)}" if kind else ""}>'
            (below if group else above).append(f"{head}{text(name)}</th>")
            column += 1
    yield f"<tr>{''.join(above)}</tr>"
    if below:
        yield f"<tr>{''.join(below)}</tr>"
    yield "</thead>"


def _cell(cell: str, is_label: bool, begins: bool) -> str:
    if is_label:
        return f'<th scope="row" class="label">{html.escape(cell)}</th>'
    value, bracket, rest = cell.partition(" [")
    if not bracket:
        value, bracket, rest = cell.partition(" (")
    small = f" <small>{html.escape(bracket.strip() + rest)}</small>" if bracket else ""
    return f"<td{' class=part' if begins else ''}>{html.escape(value)}{small}</td>"


def _readings() -> Iterator[str]:
    def inside() -> Iterator[str]:
        yield "<p>A reading fixes what the paper leaves open. None was tuned, and none is left out."
        yield "</p><dl>"
        for term, meaning in READINGS:
            yield f"<dt>{html.escape(term)}</dt><dd>{html.escape(meaning)}</dd>"
        yield "</dl>"

    return _section("readings", "How to read the tables", inside())


def _parameters(words: Sequence[tuple[str, str]], plain: dict[str, Any]) -> Iterator[str]:
    shown = json.dumps(plain, indent=1, sort_keys=True, ensure_ascii=False)

    def inside() -> Iterator[str]:
        yield _box("", "What was varied and what was kept", short=True)
        yield '<table><thead><tr><th scope="col" class="label">What</th>'
        yield '<th scope="col" class="label">Value</th></tr></thead><tbody>'
        for label, value in words:
            yield f'<tr><th scope="row" class="label">{html.escape(label)}</th>'
            yield f'<td class="text">{html.escape(value)}</td></tr>'
        yield "</tbody></table></div>"
        yield "<details><summary>All parameters as JSON</summary>"
        yield '<pre tabindex="0" role="region" aria-label="All parameters as JSON">'
        yield f"{html.escape(shown)}</pre></details>"

    return _section("parameters", "Parameters", inside())
