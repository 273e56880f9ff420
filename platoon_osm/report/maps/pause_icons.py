"""Icons of breaks, rests, bans, changes of drivers and waits, as far as a page shows any."""

from __future__ import annotations

from collections.abc import Iterable

from ..document.model import Document
from ..markup.fragments import Piece, Tree

__all__ = ["NOUNS", "PAUSE_KINDS", "pause_icons", "pause_kinds"]

PAUSE_KINDS = ("rest", "break", "ban", "change", "wait")
"""In the order in which they are told."""

NOUNS = {
    "merge": ("script.mark-merge", "script.mark-merges"),
    "separation": ("script.mark-separation", "script.mark-separations"),
    "rest": ("script.mark-rest", "script.mark-rests"),
    "break": ("script.mark-break", "script.mark-breaks"),
    "ban": ("script.mark-ban", "script.mark-bans"),
    "change": ("script.mark-change", "script.mark-changes"),
    "wait": ("script.mark-wait", "script.mark-waits"),
}
"""What an event of a kind is called, and several."""


def pause_kinds(document: Document) -> tuple[str, ...]:
    """Return for what vehicles stand.

    Parameters
    ----------
    document : Document
        Whose events they are.

    Returns
    -------
    tuple of str
        Of `PAUSE_KINDS`, in that order.
    """
    here = {event.kind for event in document.events}
    return tuple(kind for kind in PAUSE_KINDS if kind in here)


def pause_icons(documents: Iterable[Document]) -> Tree:
    """Return the icons that pages of some documents refer to.

    Parameters
    ----------
    documents : iterable of Document
        On one page.

    Returns
    -------
    Tree
        Each icon once; nothing where nobody stands.
    """
    documents = tuple(documents)
    kinds = {kind for one in documents for kind in pause_kinds(one)}
    unknown = any(not event.has_parking for one in documents for event in one.events)
    return (
        *(Piece(f"icon-{kind}") for kind in PAUSE_KINDS if kind in kinds),
        *((Piece("icon-unknown"),) if unknown else ()),
    )
