"""Pages without a live map: static HTML with a style sheet, and a script only where it helps."""

from __future__ import annotations

from collections.abc import Sequence

from .fragments import Piece, Tree, compact_asset, page_texts, written, written_page
from .security import policy

__all__ = ["MONEY_STYLE", "PAGE_STYLES", "still_page"]

PAGE_STYLES = (
    "theme.css",
    "page.css",
    "panel.css",
    "map.css",
    "narrow.css",
    "touch.css",
    "print.css",
)
"""Style sheets of all pages with a map and a panel, in their order: later rules win."""

MONEY_STYLE = "money.css"
"""Of a page of a plan in money, behind those."""


def still_page(title: str, body: Tree, styles: Sequence[str], scripts: Sequence[str] = ()) -> str:
    """Return a whole page.

    Parameters
    ----------
    title : str
        Of the page.
    body : Tree
        Of the page.
    styles, scripts : sequence of str
        Names of files under report/assets.

    Returns
    -------
    str
        HTML.
    """
    style = "".join(compact_asset(name) for name in styles)
    code = tuple(compact_asset(name) for name in scripts)
    return written_page(
        "still.html",
        policy=policy(["\n".join(code)] if code else [], [style]),
        title=title,
        style=style,
        body=body,
        script=written(Piece("still-script", {"texts": page_texts(), "code": code}))
        if code
        else "",
    )
