"""What pages say, and what of an English page is left in one of another language."""

from __future__ import annotations

import re
from html.parser import HTMLParser

HASH = re.compile(r"[0-9a-f]{8,64}…?[0-9a-f]*")

READ_ALOUD = ("aria-label", "title", "alt", "aria-valuetext", "placeholder", "summary")

SAME_EVERYWHERE = re.compile(
    r"(?<!\w)(?:platoon_osm|sha256|Graph|A\*|Platoons?|OpenStreetMap contributors|Leaflet|"
    r"GeoPackage|GPX|CSV|JSON|GeoJSON|ICS|iCal|Case|UTC|EUR|km/h|km|min|eq|h|l|d|m|T|MP|SP)(?!\w)"
)
"""Words that are the same in other languages too."""


class Texts(HTMLParser):
    """All that a page shows or is read aloud from it, but scripts and styles."""

    def __init__(self) -> None:
        super().__init__()
        self.found: set[str] = set()
        self.silent = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.silent += tag in ("script", "style")
        self.found |= {value for name, value in attrs if name in READ_ALOUD and value}

    def handle_endtag(self, tag: str) -> None:
        self.silent -= tag in ("script", "style")

    def handle_data(self, data: str) -> None:
        if not self.silent:
            self.found.add(" ".join(data.split()))


def texts_of(html: str) -> set[str]:
    texts = Texts()
    texts.feed(html)
    return texts.found


ENGLISH = re.compile(
    r"\b(the|of|and|at|with|points|nodes|circle|fuel|printed|members|master|paper|vehicles?)\b"
)
"""Words that no German or Italian sentence about a study holds, wherever they came from."""


def told_by_study(html: str) -> set[str]:
    """Return the texts of a study's page but the paper's title, the command and the JSON."""
    same = r'<(p|code|pre)\b[^>]*(?:lang="en"|translate="no")[^>]*>.*?</\1>'
    return texts_of(re.sub(same, "", html, flags=re.DOTALL))


def left_over(english: set[str], other: set[str], names: set[str]) -> set[str]:
    """Return texts of both languages that hold a word which is no name and no unit."""
    found = set()
    for text in english & other:
        rest = text
        for name in sorted(names, key=len, reverse=True):
            rest = rest.replace(name, " ")
        rest = SAME_EVERYWHERE.sub(" ", rest)
        # Parameters of costs are called as in a scenario, networks by the digits of a hash.
        if re.search(r"[A-Za-z]{3,}", rest) and " = " not in text and not HASH.fullmatch(text):
            found.add(text)
    return found
