"""How the page of a study looks: the colours of all pages, light and dark, screen and paper."""

from __future__ import annotations

import re
from importlib import resources

__all__ = ["style"]

SHEETS = (("report", "assets", "theme.css"), ("study", "page.css"))
"""The colours of all pages, and what is this page's own."""


def style() -> str:
    """Return the style sheet of the page.

    Returns
    -------
    str
        Without comments.
    """
    package = resources.files("platoon_osm")
    text = "".join(package.joinpath(*where).read_text(encoding="utf-8") for where in SHEETS)
    return re.sub(r"/\*.*?\*/\s*", "", text, flags=re.DOTALL)
