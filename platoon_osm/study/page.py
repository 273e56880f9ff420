"""The report of a study in one file that asks for nothing: the answer first, then its grounds."""

from __future__ import annotations

import base64
import hashlib
import html
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

from .._version import __version__
from ..atomic_file import whole_file
from ..report.language.speech import say, spoken
from ..shown_text import well_formed
from .answer import Answer
from .page_style import style
from .shown_tables import ShownTable

__all__ = ["Picture", "StudyPage", "write_page"]

READINGS = (
    ("study-readings.vehicles", "study-readings.vehicles-means"),
    ("study-readings.rates", "study-readings.rates-means"),
    ("study-readings.terms", "study-readings.terms-means"),
    ("study.astar", "study-readings.again-means"),
    ("study.astar-once", "study-readings.once-means"),
    ("study-readings.members", "study-readings.members-means"),
    ("study-readings.counted", "study-readings.counted-means"),
    ("study-readings.brackets", "study-readings.brackets-means"),
)
"""What is told of each choice: its name and its meaning."""

PAPER = "Adas et al., Joint Travel Route Optimization Framework for Platooning, IFAC 2025"


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
    shows : str
        "network", "costs", or the method by which members take part.
    """

    title: str
    caption: str
    alt: str
    file: Path
    shows: str = ""


@dataclass(frozen=True, slots=True)
class StudyPage:
    """What the page of a study shows.

    Attributes
    ----------
    answer : Answer
        What it comes to.
    sentences : sequence of str
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
    sentences: Sequence[str]
    pictures: Sequence[Picture]
    tables: Sequence[ShownTable]
    parameters: Sequence[tuple[str, str]]
    plain: dict[str, Any]
    command: str


def write_page(path: Path, page: StudyPage) -> None:
    """Write the report, in the language that is spoken and that its texts were made in.

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
        "<!doctype html>", f'<html lang="{spoken().code}" dir="ltr">',
        "<head>", '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{html.escape(policy)}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="referrer" content="no-referrer">',
        f"<title>{_said('study.title')}</title>", f"<style>{css}</style>", "</head>", "<body>",
        f'<a class="skip" href="#answer">{_said("study.skip")}</a>',
        "<header>", f"<h1>{_said('study.heading')}</h1>",
        f'<p class="sub" lang="en">{PAPER}</p>',
        f'<nav aria-label="{_said("study.parts")}"><ul>',
        *(f'<li><a href="#{to}">{_said(name)}</a></li>' for to, name in PARTS),
        "</ul></nav>", "</header>", "<main>",
        *_answer(page.answer, page.sentences), *_pictures(page.pictures), *_tables(page.tables),
        *_readings(), *_parameters(page.parameters, page.plain), "</main>",
        f"<footer><p>{_made(page.command)}</p></footer>",
        "</body>", "</html>",
    ]  # fmt: skip
    with whole_file(path) as draft:
        draft.write_text(well_formed("\n".join(lines)) + "\n", encoding="utf-8")


PARTS = (
    ("answer", "study.part-answer"), ("figures", "study.part-figures"),
    ("comparison", "study.part-tables"), ("readings", "study.part-readings"),
    ("parameters", "study.part-parameters"),
)  # fmt: skip


def _said(key: str, **fields: object) -> str:
    """Return a text of the catalogue as HTML."""
    return html.escape(say(key, **fields))


def _made(command: str) -> str:
    """Return who made the page with what, as HTML; the command is set apart as code."""
    before, after = say("study.made", version=__version__, command="\0").split("\0")
    code = f'<code translate="no">{html.escape(command)}</code>'
    return f"{html.escape(before)}{code}{html.escape(after)}"


def _section(name: str, title: str, inside: Iterator[str]) -> Iterator[str]:
    yield f'<section id="{name}" aria-labelledby="h-{name}"><h2 id="h-{name}">{_said(title)}</h2>'
    yield from inside
    yield "</section>"


COLUMNS = (
    "study-answer.paper", "study-answer.ours", "study-answer.interval", "study-answer.agree",
)  # fmt: skip


def _answer(answer: Answer, sentences: Sequence[str]) -> Iterator[str]:
    text = html.escape

    def inside() -> Iterator[str]:
        yield f'<p class="verdict agrees-{answer.standing}">{text(answer.verdict)}</p>'
        yield f"<p>{_unbroken(answer.asked)} {_unbroken(answer.found)}</p>"
        heads = "".join(f'<th scope="col">{_said(key)}</th>' for key in COLUMNS)
        yield _box("t-answer", say("study-answer.table"), short=True)
        yield (
            f'<table><thead><tr><th scope="col" class="label">{_said("study-answer.number")}</th>'
            f"{heads}</tr></thead><tbody>"
        )
        for number in answer.numbers:
            mark = ("yes", "study-answer.yes") if number.agrees else ("no", "study-answer.no")
            yield (
                f'<tr><th scope="row" class="label">{text(number.label)}</th>'
                f"<td>{text(number.paper)}</td><td>{text(number.ours)}</td>"
                f"<td>{text(number.interval) or '–'}</td>"
                f'<td><span class="mark {mark[0]}">{_said(mark[1])}</span></td></tr>'
            )
        yield f'</tbody></table></div><p class="caption">{_unbroken(answer.reading)}</p>'
        yield f"<h3>{_said('study-answer.in-full')}</h3><ul>"
        yield from (f"<li>{_unbroken(sentence)}</li>" for sentence in sentences)
        yield "</ul>"

    return _section("answer", "study.answer", inside())


def _unbroken(text: str) -> str:
    """Return a text as HTML in which no line ends between a number and its sign."""
    return html.escape(text).replace(" %", "&nbsp;%")


def _pictures(pictures: Sequence[Picture]) -> Iterator[str]:
    def inside() -> Iterator[str]:
        for number, picture in enumerate(pictures, 1):
            data = base64.b64encode(picture.file.read_bytes()).decode()
            title = _said("study.figure", number=number, title=picture.title)
            yield f'<figure aria-labelledby="f-{number}"><h3 id="f-{number}">{title}</h3>'
            yield f'<div class="sheet" tabindex="0" role="region" aria-label="{title}">'
            yield f'<img src="data:image/svg+xml;base64,{data}" alt="{html.escape(picture.alt)}">'
            yield f"</div><figcaption>{html.escape(picture.caption)}</figcaption></figure>"

    return _section("figures", "study.part-figures", inside())


def _tables(tables: Sequence[ShownTable]) -> Iterator[str]:
    def inside() -> Iterator[str]:
        for number, table in enumerate(tables, 1):
            title = _said("study.table", number=number, title=table.title)
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

    return _section("comparison", "study.tables", inside())


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
        yield f"<p>{_said('study-readings.what')}</p><dl>"
        for term, meaning in READINGS:
            yield f"<dt>{_said(term)}</dt><dd>{_said(meaning)}</dd>"
        yield "</dl>"

    return _section("readings", "study.readings", inside())


def _parameters(words: Sequence[tuple[str, str]], plain: dict[str, Any]) -> Iterator[str]:
    shown = json.dumps(plain, indent=1, sort_keys=True, ensure_ascii=False)

    def inside() -> Iterator[str]:
        yield _box("", say("study-parameters.table"), short=True)
        heads = (_said("study-parameters.what"), _said("study-parameters.value"))
        yield "<table><thead><tr>"
        yield from (f'<th scope="col" class="label">{head}</th>' for head in heads)
        yield "</tr></thead><tbody>"
        for label, value in words:
            yield f'<tr><th scope="row" class="label">{html.escape(label)}</th>'
            yield f'<td class="text">{html.escape(value)}</td></tr>'
        yield "</tbody></table></div>"
        name = _said("study-parameters.json")
        yield f"<details><summary>{name}</summary>"
        yield f'<pre tabindex="0" role="region" translate="no" aria-label="{name}">'
        yield f"{html.escape(shown)}</pre></details>"

    return _section("parameters", "study.part-parameters", inside())
