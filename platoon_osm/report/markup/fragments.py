"""Pieces of HTML and SVG as data, written as text once, with every text escaped.

This is the only place where text from outside meets markup. What a page shows is a tree of pieces,
each the name of a fragment and what stands for its placeholders; `written` turns it into text. A
value is escaped unless it is a piece, pieces one after another, or `Markup`, and `Markup` is made
here alone, but for style_classes.py, which makes it from `Markup`.
"""

from __future__ import annotations

import functools
import html
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from string import Template
from typing import TypeAlias

from ..language.languages import Language
from ..language.speech import spoken
from .security import json_for_html

__all__ = [
    "NOTHING",
    "Markup",
    "Piece",
    "Tree",
    "asset",
    "compact_asset",
    "page_data",
    "page_texts",
    "written",
    "written_page",
]

FRAGMENT_FILES = (
    "panel.html",
    "money.html",
    "legend.html",
    "map.svg.html",
    "charts.html",
    "schedule.html",
    "time_distance.html",
    "comparison.html",
    "flows.html",
    "sheets.html",
    "notebook.html",
    "what_if.html",
    "fleet.html",
)

_FRAGMENT = re.compile(r"^<!-- fragment: ([\w-]+)[^>]*-->\n", re.MULTILINE)
_PLACEHOLDER = re.compile(r"\$(\w+|\{\w+\})")
_TEXT = re.compile(r"@\{([\w.-]+)\}")


class Markup(str):
    """Text that is markup already; only this file and style_classes.py make it."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Piece:
    """A fragment of markup before it is written.

    Attributes
    ----------
    fragment : str
        Its name.
    values : mapping of str to object
        What stands for each placeholder: pieces, or a text that is escaped when it is written.
    """

    fragment: str
    values: Mapping[str, object] = field(default_factory=dict)


Tree: TypeAlias = "Piece | Markup | tuple[Tree, ...]"
"""What a page shows: a piece, or pieces one after another, a line each."""

NOTHING: Tree = ()
"""Stands where a page has nothing to say."""


def asset(name: str) -> str:
    """Return the text of a file under report/assets.

    Parameters
    ----------
    name : str
        Of the file.

    Returns
    -------
    str
        All of it.
    """
    return (files("platoon_osm.report") / "assets" / name).read_text("utf-8")


@functools.cache
def compact_asset(name: str) -> Markup:
    """Return a script or style sheet without comments and blanks that say nothing.

    Parameters
    ----------
    name : str
        Of a file under report/assets.

    Returns
    -------
    Markup
        Our own code, as it is.
    """
    import rcssmin
    import rjsmin

    smaller = rjsmin.jsmin if name.endswith(".js") else rcssmin.cssmin
    return Markup(smaller(asset(name)) + "\n")


@functools.cache
def _fragments(language: Language) -> Mapping[str, tuple[str, ...]]:
    """Read all fragment files: each fragment begins with a comment that names it.

    Its text stands cut at its placeholders: every second part is the name of one. Words are put in
    from the catalogue of a language.
    """
    found: dict[str, tuple[str, ...]] = {}
    for name in FRAGMENT_FILES:
        parts = _FRAGMENT.split(asset(name))
        for label, body in zip(parts[1::2], parts[2::2], strict=True):
            texts = _PLACEHOLDER.split(body.strip("\n"))
            texts[0::2] = (_worded(text, language) for text in texts[0::2])
            texts[1::2] = (text.strip("{}") for text in texts[1::2])
            found[label] = tuple(texts)
    return found


def _worded(text: str, language: Language) -> str:
    """Put words of a language in for @{their.key}."""
    return _TEXT.sub(lambda found: html.escape(language.say(found[1]), quote=True), text)


def written(tree: Tree) -> Markup:
    """Write a tree as markup, each value escaped unless it is a piece, pieces or `Markup`.

    Values are put in once and not read again, so a `$` in them stays what it is.

    Parameters
    ----------
    tree : Tree
        What is shown.

    Returns
    -------
    Markup
        Its text; of pieces one after another, one a line.

    Raises
    ------
    KeyError
        A fragment that does not exist, or a placeholder without a value.
    """
    out: list[str] = []
    _write(tree, _fragments(spoken()), out)
    return Markup("".join(out))


def _write(value: object, fragments: Mapping[str, tuple[str, ...]], out: list[str]) -> None:
    """Append the text of a value: no other line of the package decides what is escaped."""
    if isinstance(value, Piece):
        text, *rest = fragments[value.fragment]
        out.append(text)
        for name, after in zip(rest[::2], rest[1::2], strict=True):
            _write(value.values[name], fragments, out)
            out.append(after)
    elif isinstance(value, tuple):
        for place, part in enumerate(value):
            if place:
                out.append("\n")
            _write(part, fragments, out)
    else:
        out.append(value if isinstance(value, Markup) else html.escape(str(value), quote=True))


def page_texts() -> Markup:
    """Return the texts that the script of a page uses, in the language that is spoken.

    Returns
    -------
    Markup
        JSON for elements.js: `language`, `clock` and `texts`.
    """
    language = spoken()
    data = {"language": language.code, "clock": language.clock, "texts": language.of_script}
    return Markup(json_for_html(data))


def page_data(data: object) -> Markup:
    """Return what the script of a page works on.

    Parameters
    ----------
    data : dict, list, str, float, int, bool or None
        Plain JSON types.

    Returns
    -------
    Markup
        JSON that cannot leave its element.
    """
    return Markup(json_for_html(data))


def written_page(
    name: str, /, *, title: str, body: Tree, policy: str, extra: str = "", **parts: str
) -> str:
    """Write a whole page from a file.

    Parameters
    ----------
    name : str
        Of a file under report/assets.
    title : str
        Of the page; it is escaped.
    body : Tree
        Of the page.
    policy : str
        What the page may do.
    extra : str
        Markup that follows the body, from folium.
    **parts : str
        Our own code, as it is.

    Returns
    -------
    str
        HTML.
    """
    text = f"{written(body)}\n{extra.strip()}".strip()
    return Template(asset(name)).substitute(
        lang=spoken().code, title=html.escape(title, quote=True), body=text, policy=policy, **parts
    )
