"""Pieces of HTML and SVG in files of their own, filled once, with every text escaped.

This is the only place where text from outside meets markup. A value is escaped unless it is
`Markup`, and `Markup` is made here alone: by filling a fragment, or by joining filled ones.
"""

from __future__ import annotations

import functools
import html
import re
from collections.abc import Iterable, Mapping
from importlib.resources import files
from string import Template

__all__ = ["NOTHING", "Markup", "asset", "compact_asset", "fill", "fill_page", "join"]

FRAGMENT_FILES = (
    "panel.html",
    "legend.html",
    "map.svg.html",
    "charts.html",
    "schedule.html",
    "comparison.html",
    "flows.html",
    "notebook.html",
)

_FRAGMENT = re.compile(r"^<!-- fragment: ([\w-]+)[^>]*-->\n", re.MULTILINE)


class Markup(str):
    """Text that is markup already; only `fill`, `join` and `compact_asset` make it."""

    __slots__ = ()


NOTHING = Markup("")
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


def compact_asset(name: str) -> Markup:
    """Return a script or style sheet without its comments on lines of their own, nor indents.

    No text in our scripts runs over a line end, so nothing else changes; a test holds them to it.

    Parameters
    ----------
    name : str
        Of a file under report/assets.

    Returns
    -------
    Markup
        Our own code, as it is.
    """
    bare = re.sub(r"^[ \t]*/\*.*?\*/[ \t]*\n", "", asset(name), flags=re.DOTALL | re.MULTILINE)
    lines = (line.strip() for line in bare.splitlines())
    kept = (line for line in lines if line and not line.startswith("//"))
    return Markup("\n".join(kept) + "\n")


@functools.cache
def _fragments() -> Mapping[str, Template]:
    """Read all fragment files: each fragment begins with a comment that names it."""
    found: dict[str, Template] = {}
    for name in FRAGMENT_FILES:
        parts = _FRAGMENT.split(asset(name))
        for label, body in zip(parts[1::2], parts[2::2], strict=True):
            found[label] = Template(body.strip("\n"))
    return found


def fill(fragment: str, /, **values: object) -> Markup:
    """Fill a fragment's `$placeholders`, each value escaped unless it is `Markup`.

    Values are put in once and not read again, so a `$` in them stays what it is.

    Parameters
    ----------
    fragment : str
        Its name.
    **values : object
        What stands for each placeholder.

    Returns
    -------
    Markup
        The fragment, filled.

    Raises
    ------
    KeyError
        A fragment that does not exist, or a placeholder without a value.
    """
    safe = {name: _escaped(value) for name, value in values.items()}
    return Markup(_fragments()[fragment].substitute(safe))


def fill_page(name: str, /, *, title: str, body: Markup, policy: str, **parts: str) -> str:
    """Fill a whole page from a file.

    Parameters
    ----------
    name : str
        Of a file under report/assets.
    title : str
        Of the page; it is escaped.
    body : Markup
        Of the page.
    policy : str
        What the page may do.
    **parts : str
        Our own code, as it is.

    Returns
    -------
    str
        HTML.
    """
    return Template(asset(name)).substitute(
        title=_escaped(title), body=body, policy=policy, **parts
    )


def join(parts: Iterable[Markup]) -> Markup:
    """Join filled fragments, one a line.

    Parameters
    ----------
    parts : iterable of Markup
        Filled fragments.

    Returns
    -------
    Markup
        All of them.
    """
    return Markup("\n".join(_escaped(part) for part in parts))


def _escaped(value: object) -> str:
    return str(value) if isinstance(value, Markup) else html.escape(str(value), quote=True)
