"""What the tags of a barrier close, and whether the map says which road it stands on."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping

from ..network.restrictions import Layer
from ..vehicles.access import BARRIERS, CHAIN, Way, barrier_way
from .restricting_tags import is_restriction, restricting

__all__ = ["barrier_layer", "is_barrier_tag", "is_obeyed"]

BARRIER_TAGS = ("barrier", "locked")


def is_barrier_tag(key: str) -> bool:
    """Tell whether a tag of a node says something about a barrier there.

    Parameters
    ----------
    key : str
        Of the tag.

    Returns
    -------
    bool
        Whether it does.
    """
    return key in BARRIER_TAGS or is_restriction(key)


def barrier_layer(tags: Mapping[str, str]) -> Layer:
    """Return what a barrier closes.

    Parameters
    ----------
    tags : mapping of str to str
        Of its node.

    Returns
    -------
    Layer
        Empty for a barrier that everybody passes.
    """
    restricted = restricting(tags, Counter())
    if not restricted and barrier_way(tags) == Way.OPEN:
        return {}
    own = {key: tags[key].strip() for key in (*CHAIN, *BARRIER_TAGS) if key in tags}
    return {**own, **restricted}


def is_obeyed(kind: str, layer: Layer, meeting: Callable[[], int], counts: Counter[str]) -> bool:
    """Tell whether a barrier closes a road, and count what becomes of it.

    Parameters
    ----------
    kind : str
        Value of `barrier`.
    layer : Layer
        What it closes.
    meeting : callable
        Returns how many roads meet at its node: of more than two it may stand on any.
    counts : Counter
        Counts barriers read, and what became of them.

    Returns
    -------
    bool
        Whether nobody passes it whom the layer closes it to.
    """
    counts["barriers on roads read"] += 1
    if kind.strip().lower() not in BARRIERS:
        counts["barriers of a kind not in the table, taken as open"] += 1
    if not layer:
        counts["barriers that close nothing"] += 1
        return False
    if meeting() > 2:
        counts["barriers where roads meet, not obeyed"] += 1
        return False
    counts["barriers obeyed"] += 1
    return True
