"""Names of files made of names of vehicles: readable, and safe on every system."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from itertools import dropwhile

__all__ = ["file_stems"]

MOST_BYTES = 120
"""Of a stem in UTF-8; file systems allow 255 for a whole name, and some tools add to it."""

NAMELESS = "vehicle"

DEVICES = frozenset(
    ["con", "prn", "aux", "nul", "conin$", "conout$", "clock$"]
    + [f"{port}{number}" for port in ("com", "lpt") for number in range(10)]
)
"""Names that Windows keeps for devices, whatever suffix follows."""


def file_stems(names: Sequence[str]) -> list[str]:
    """Return a file name without suffix for each of some names, no two alike.

    Letters and digits of any script stay, in lower case; all else becomes a hyphen. A name of a
    device of Windows, and a name without letters or digits, has "vehicle" in front of it, or
    instead. Of names that would share a file, the first keeps it and the others are numbered from
    2, past numbers that stand in other names; so "torino-2" belongs to a vehicle of that name.

    Parameters
    ----------
    names : sequence of str
        Of vehicles; anybody's text.

    Returns
    -------
    list of str
        In the same order.
    """
    plain = [_slug(name) for name in names]
    own = {_key(stem) for stem in plain}
    taken: set[str] = set()
    found = []
    for stem in plain:
        number = 2
        name = stem
        while _key(name) in taken or (name != stem and _key(name) in own):
            name = f"{stem}-{number}"
            number += 1
        taken.add(_key(name))
        found.append(name)
    return found


def _slug(name: str) -> str:
    text = unicodedata.normalize("NFKC", name).lower()
    kept = "".join(c if _is_letter(c) else " " for c in text)
    # A mark without a letter before it would stand on its neighbour.
    words = ["".join(dropwhile(lambda c: not c.isalnum(), word)) for word in kept.split()]
    # Cut by bytes, never inside a letter.
    joined = "-".join(filter(None, words)).encode("utf-8", "ignore")
    short = joined[:MOST_BYTES].decode("utf-8", "ignore")
    stem = unicodedata.normalize("NFC", short).strip("-")
    if not stem:
        return NAMELESS
    return f"{NAMELESS}-{stem}" if stem in DEVICES else stem


def _is_letter(character: str) -> bool:
    # Marks are half of many letters: vowels of Hindi, accents that have no letter of their own.
    return character.isalnum() or unicodedata.category(character).startswith("M")


def _key(stem: str) -> str:
    """Return what is alike for names that some file system takes for one."""
    return unicodedata.normalize("NFKD", unicodedata.normalize("NFKC", stem).casefold())
