"""How a network keeps what the map restricts: tags as text, to be judged for the vehicle that asks.

An edge passes through one or more *layers*: the road, a barrier on it, a turn that leads onto it.
Each layer is a set of OpenStreetMap tags as they hold in the direction of travel, and all of them
hold at once. The text is "hgv=destination maxheight=3.8 | barrier=gate access=private": pairs with
blanks between them, keys in alphabetical order, layers with " | " between them, other characters
than the harmless ones as %hex. Equal restrictions are equal texts, so each is judged only once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from urllib.parse import quote, unquote

__all__ = ["Layer", "decode", "encode"]

Layer = Mapping[str, str]
"""Tags of one thing that is passed."""

HARMLESS = "@:;,.()+<>/*'!&~$\"[]{}^"
BETWEEN = " | "


def encode(layers: Iterable[Layer]) -> str:
    """Return layers as the text that a network keeps.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        Tags by key; empty layers are left out, and so are repeated ones.

    Returns
    -------
    str
        Empty if nothing is restricted.
    """
    texts = (
        " ".join(f"{_quoted(key)}={_quoted(layer[key])}" for key in sorted(layer))
        for layer in layers
    )
    return BETWEEN.join(sorted({text for text in texts if text}))


def decode(text: str) -> tuple[dict[str, str], ...]:
    """Return the layers of a text.

    Parameters
    ----------
    text : str
        As `encode` made it.

    Returns
    -------
    tuple of dict of str to str
        Tags by key; none for the empty text.
    """
    return tuple(
        {unquote(key): unquote(value) for key, _, value in pairs}
        for part in text.split(BETWEEN)
        if (pairs := [pair.partition("=") for pair in part.split(" ") if pair])
    )


def _quoted(text: str) -> str:
    return quote(text, safe=HARMLESS, errors="replace")
