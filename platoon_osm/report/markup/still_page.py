"""Pages without a live map: static HTML with a style sheet, and a script only where it helps."""

from __future__ import annotations

from collections.abc import Sequence

from .fragments import Markup, compact_asset, fill, fill_page, join
from .security import policy

__all__ = ["still_page"]


def still_page(title: str, body: Markup, styles: Sequence[str], scripts: Sequence[str] = ()) -> str:
    """Return a whole page.

    Parameters
    ----------
    title : str
        Of the page.
    body : Markup
        Of the page.
    styles, scripts : sequence of str
        Names of files under report/assets.

    Returns
    -------
    str
        HTML.
    """
    style = "".join(compact_asset(name) for name in styles)
    code = join(compact_asset(name) for name in scripts)
    return fill_page(
        "still.html",
        policy=policy([code] if code else [], [style]),
        title=title,
        style=style,
        body=body,
        script=fill("still-script", code=code) if code else "",
    )
