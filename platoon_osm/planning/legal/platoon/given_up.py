"""When a master is given up: what all pay at least is no less than a plan that is known.

Members choose by their own cost, and what the master gains from company is counted after. So a
search is given up at what the plan costs more than the master's least, which is what it pays alone
less all that it could gain.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .spans import SpanSearch
from .star_searches import StarSearches, departures_of

__all__ = ["leaves", "most_gained"]


def most_gained(search: SpanSearch) -> float:
    """Return what a master saves if it has company wherever that could pay.

    Parameters
    ----------
    search : SpanSearch
        Of a star.

    Returns
    -------
    float
        No plan saves it more.
    """
    pairs, some = search.values.pairs, search.numbers
    own = slice(int(pairs.first[some.master]))
    merge, separate = pairs.merge[own], pairs.separate[own]
    # How many pairs have begun and not ended before each edge of the route.
    begun = np.zeros(len(some.pos) + 1, np.int64)
    np.add.at(begun, merge, 1)
    np.add.at(begun, separate, -1)
    met = np.cumsum(begun)[some.first_node :][: len(search.star.gain)] > 0
    return float(np.maximum(search.star.gain, 0.0)[met].sum())


def leaves(searches: StarSearches, needs: tuple[int, int], more: int) -> bool:
    """Tell whether a master can drive at all, whoever comes along.

    Parameters
    ----------
    searches : StarSearches
        Of its star.
    needs : (int, int)
        Stops and daily rests that its driving takes.
    more : int
        Daily rests that are allowed beyond these.

    Returns
    -------
    bool
        Whether it has a legal timetable with the stops that are searched.
    """
    star, none = searches.star, slice(0)
    nobody = replace(
        star, approach_s=star.approach_s[none], onward_s=star.onward_s[none],
        entry=star.entry[none], leave=star.leave[none], platoon=star.platoon[none],
        alone=star.alone[none], alone_s=star.alone_s[none], windows=(), member_rules=(),
    )  # fmt: skip
    by_itself = StarSearches(
        nobody, searches.real, extra_stops=searches.extra_stops, lengths=searches.lengths
    )
    search = by_itself.search(needs, more)
    if search is None:
        return False
    search.run(*departures_of(star))
    return search.found is not None
