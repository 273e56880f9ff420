"""Sharing by its definitions: sets of players, all orders, all ways to split; no tables of bits."""

from itertools import chain, combinations, permutations
from statistics import fmean

from hypothesis import strategies as st

__all__ = ["as_table", "coalitions", "games", "saved_by_company", "shapley_by_orders", "split_best"]

gains = st.integers(0, 40).map(lambda k: k / 4)
"""Quarters, so that ties occur and sums are exact."""


def coalitions(n):
    """Return every set of players, nobody and everybody among them."""
    every = range(n)
    return map(frozenset, chain.from_iterable(combinations(every, k) for k in range(n + 1)))


def as_table(n, value):
    """Return the values of sets of players where tables have them."""
    table = [0.0] * 2**n
    for one in coalitions(n):
        table[sum(2**player for player in one)] = value(one)
    return table


def games(least=1, most=5):
    """Draw a number of players and a value for every set of them."""
    return st.integers(least, most).flatmap(
        lambda n: st.lists(gains, min_size=2**n - 1, max_size=2**n - 1).map(
            lambda drawn: (n, dict(zip(coalitions(n), [0.0, *drawn], strict=True)))
        )
    )


def saved_by_company(follow, lead, group):
    """Return what a group saves if the one leads with whom most is saved; alone nothing."""
    if len(group) < 2:
        return 0.0
    return max(lead[one] + sum(follow[other] for other in group - {one}) for one in group)


def shapley_by_orders(n, value):
    """Return the mean of what each adds, order by order of all n! orders."""
    added = [[] for _ in range(n)]
    for order in permutations(range(n)):
        for place, player in enumerate(order):
            before = frozenset(order[:place])
            added[player].append(value(before | {player}) - value(before))
    return [fmean(own) for own in added]


def split_best(group, value):
    """Return the most that a group is worth over all ways to split it, part by part."""
    if not group:
        return 0.0
    first, *rest = sorted(group)
    return max(
        value(frozenset({first, *others})) + split_best(group - {first, *others}, value)
        for k in range(len(rest) + 1)
        for others in combinations(rest, k)
    )
