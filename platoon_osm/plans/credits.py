"""Who is to be named with a plan: who made its map, and whose other facts it uses."""

from __future__ import annotations

from ..network.load_report import Source
from ..shown_text import fitted, shown
from .plan import Plan
from .records import NetworkIdentity

__all__ = ["UNKNOWN_SOURCE", "credits_of"]

UNKNOWN_SOURCE = "map: its source was not told"


def credits_of(plan: Plan, source: Source | None = None) -> tuple[str, ...]:
    """Return who is to be named, on every page and in every file that is made of a plan.

    Each map is credited to those who made it, in the words of its source; nobody is named for
    what is not theirs.

    Parameters
    ----------
    plan : Plan
        It names its network's source, and further credits, as for the names of towns.
    source : Source, optional
        That of the network at hand, if it says it in other words.

    Returns
    -------
    tuple of str
        One line for each, at least one.
    """
    sources: list[Source | NetworkIdentity] = [plan.network]
    if source is not None:
        sources.insert(0, source)
    lines = [
        ", ".join(text for text in (shown(one.attribution), shown(one.licence)) if text)
        for one in sources
    ]
    own = [fitted(line) for line in lines if line] or [UNKNOWN_SOURCE]
    return tuple(dict.fromkeys([*own, *(fitted(line) for line in plan.credits)]))
