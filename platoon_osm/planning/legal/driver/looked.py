"""How much searches for real trips have done: a count that is the same on every machine."""

from __future__ import annotations

import threading

__all__ = ["LOOKED", "SEARCH_LABELS"]

SEARCH_LABELS = 200
"""What beginning a search counts for, in labels."""


class _Looked(threading.local):
    """What searches of this thread have done so far.

    Attributes
    ----------
    labels : int
        Labels that they kept, and `SEARCH_LABELS` for each search.
    """

    labels = 0


LOOKED = _Looked()
