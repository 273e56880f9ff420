"""The nearest valid shares to any amounts, bucket by bucket.

With v the amounts of n trucks, C the price of a platoon and h what its leader saves, shares of
regime (i) nearest to v are, if any number may be in a platoon or n <= Q, the projection on a
simplex, s = max(0, v - f) with f such that they sum to C. With a limit Q the valid ones are those
with a level t >= 0 such that Q t + sum of max(0, s - t) <= C; the nearest have

    s = v - f + t where v >= f;  t where t <= v <= f;  v below,    f = t + d,
    Q t + sum of max(0, v - f) = C,    sum of min(d, max(0, v - t)) = Q d  (or t = 0),

which is solved for f by halving; those below t are raised to it for nothing. In regime (ii) the
truck of the greatest amount has C + x and others -x. Only lowering counts, so x is where

    max v - C - x = sum of max(0, v + x) over the others,

held to [0, h], found by Newton's method from above. The nearer of the two is taken.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled, made_known

__all__ = ["project", "projected"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

HALVINGS = 14
"""How often the span of a threshold is halved; what is left of it only moves shares a little."""


def _on_simplex(v: Floats, n: int, price: float) -> None:
    """Put v at its nearest point with v >= 0 and sum price."""
    total = 0.0
    for i in range(n):
        total += v[i]
    threshold = (total - price) / n
    left = n
    while True:
        total = 0.0
        above = 0
        for i in range(n):
            if v[i] > threshold:
                total += v[i]
                above += 1
        if above == 0 or above >= left:
            break
        left = above
        threshold = (total - price) / above
    for i in range(n):
        v[i] = max(v[i] - threshold, 0.0)


def _with_limit(v: Floats, n: int, price: float, most: int, work: Floats) -> None:
    """Put v at valid shares of platoons of at most `most` vehicles that are near to it."""
    active = 0
    high = 0.0
    for i in range(n):
        if v[i] > 0.0:
            work[active] = v[i]
            active += 1
            high = max(high, v[i])
        else:
            v[i] = 0.0
    if high <= price / most:
        for i in range(n):
            v[i] = price / most
        return
    low = 0.0
    top = high
    for _ in range(HALVINGS):
        threshold = 0.5 * (low + top)
        above = 0.0
        clipped = 0.0
        for i in range(active):
            if work[i] > threshold:
                above += work[i] - threshold
        if above > price:
            low = threshold
            continue
        level = (price - above) / most
        if level >= threshold:
            # Nothing need fall, and more may be raised.
            low = threshold
            continue
        for i in range(active):
            if work[i] > level:
                clipped += min(work[i], threshold) - level
        if clipped > most * (threshold - level):
            low = threshold
            # Levels rise with thresholds: what lies below this one never counts again.
            kept = 0
            for i in range(active):
                if work[i] > level:
                    work[kept] = work[i]
                    kept += 1
            active = kept
        else:
            top = threshold
    threshold = top
    above = 0.0
    for i in range(n):
        if v[i] > threshold:
            above += v[i] - threshold
    level = max((price - above) / most, 0.0)
    for i in range(n):
        v[i] = max(v[i] - threshold, 0.0) + level


def _with_leader(v: Floats, n: int, price: float, leader: float, work: Floats) -> None:
    """Put v, the projection of the amounts work[n:2n] on regime (i), on regime (ii) if nearer."""
    first = 0
    near = 0.0
    for i in range(n):
        # Raising is free: what lies below valid shares is valid.
        near += max(work[n + i] - v[i], 0.0) ** 2
        if work[n + i] > work[n + first]:
            first = i
    greatest = work[n + first]
    x = leader
    while True:
        total = greatest - price
        count = 1
        for i in range(n):
            if i != first and work[n + i] > -x:
                total -= work[n + i]
                count += 1
        lower = total / count
        if lower >= x or x <= 0.0:
            break
        x = max(lower, 0.0)
    far = max(greatest - price - x, 0.0) ** 2
    for i in range(n):
        if i != first:
            far += max(work[n + i] + x, 0.0) ** 2
    if far < near:
        for i in range(n):
            v[i] = -x
        v[first] = price + x


def project(v: Floats, n: int, price: float, leader: float, most: int, work: Floats) -> None:
    """Put the amounts of a bucket at valid shares near to them.

    Parameters
    ----------
    v : ndarray of float64
        The amounts, then the shares, of the first n [grains].
    n : int
        How many trucks the bucket has.
    price, leader : float
        What a platoon costs once, and what its leader saves [grains].
    most : int
        Vehicles of the largest platoon, 0 for any.
    work : ndarray of float64
        Room for 2 n numbers.
    """
    if n == 1:
        v[0] = price + leader
        return
    if leader > 0.0:
        for i in range(n):
            work[n + i] = v[i]
    if most and n > most:
        _with_limit(v, n, price, most, work)
    else:
        _on_simplex(v, n, price)
    if leader > 0.0:
        _with_leader(v, n, price, leader, work)


for _helper in (_on_simplex, _with_limit, _with_leader, project):
    made_known(_helper)


@compiled
def projected(
    share: Floats, first_member: Ints, entry: Ints, extra: Floats, leader: Floats, most: int
) -> None:
    """Put the shares of all buckets at valid ones near to them.

    Parameters
    ----------
    share : ndarray of float64, (S,)
        Any amounts, then valid shares [grains].
    first_member, entry : ndarray of int64
        As in `Buckets`.
    extra, leader : ndarray of float64, (B,)
        As in `Buckets` [grains].
    most : int
        Vehicles of the largest platoon, 0 for any.
    """
    widest = 1
    for b in range(len(extra)):
        widest = max(widest, first_member[b + 1] - first_member[b])
    v = np.empty(widest)
    work = np.empty(2 * widest)
    for b in range(len(extra)):
        low = first_member[b]
        n = first_member[b + 1] - low
        if n == 0:
            continue
        for i in range(n):
            v[i] = share[entry[low + i]]
        project(v, n, extra[b], leader[b], most, work)
        for i in range(n):
            share[entry[low + i]] = v[i]
