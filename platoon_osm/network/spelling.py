"""Names as people remember them: how two spellings of one name are found to be the same."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

__all__ = ["bracket_apart", "fold", "plain", "road_keys"]

LETTERS = str.maketrans({"ł": "l", "ø": "o", "đ": "d", "ð": "d", "ı": "i", "æ": "ae", "œ": "oe"})
"""Letters that people without them on the keyboard write so; Unicode does not decompose them."""


def plain(text: str) -> str:
    """Return a text in small letters, without accents, blanks as single spaces.

    Parameters
    ----------
    text : str
        As the map or a person writes it.

    Returns
    -------
    str
        With its punctuation.
    """
    apart = unicodedata.normalize("NFKD", text.casefold())
    bare = "".join(c for c in apart if not unicodedata.combining(c))
    return " ".join(bare.translate(LETTERS).split())


def fold(text: str) -> str:
    """Reduce a name to what people remember of it: no case, accents, punctuation or spaces.

    Parameters
    ----------
    text : str
        A name as the map or a person writes it.

    Returns
    -------
    str
        Words in lower case, a blank between them. A name of signs alone, such as "+++", stays as it
        is.
    """
    own = plain(text)
    return re.sub(r"[\W_]+", " ", own).strip() or own


def bracket_apart(text: str) -> tuple[str, str]:
    """Take a name and what stands in brackets at its end apart.

    Parameters
    ----------
    text : str
        Such as "Novara Est (A4)".

    Returns
    -------
    name, bracket : str
        The bracket is empty if there is none; there is none without a name before it.
    """
    own = text.strip()
    opened = own.rfind("(")
    if not own.endswith(")") or opened <= 0 or ")" in own[opened:-1]:
        return own, ""
    name = own[:opened].strip()
    return (name, own[opened + 1 : -1].strip()) if name else (own, "")


def road_keys(refs: Iterable[str]) -> set[str]:
    """Return road numbers as they are compared: "A 4;E 64" is the a4 and the e64.

    Parameters
    ----------
    refs : iterable of str
        Road numbers as the map or a person writes them.

    Returns
    -------
    set of str
        Folded, without spaces.
    """
    return {fold(part).replace(" ", "") for ref in refs for part in re.split("[;/]", ref)} - {""}
