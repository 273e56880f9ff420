"""What each member pays, as a step function of the moment at which a master leaves: the kernels.

A member's entries and exits stand in a row, by their position on the route, exits before entries
where both stand at one: so what stands left of something merges strictly before it. A tree over
the row holds in each node the least E of its open entries, the least X of its open exits, and the
least E + X of an entry left of an exit. An event changes one leaf and the nodes above it, so n
events take O(n log n). A second tree of the same shape holds entries at which waiting has begun to
cost something; its values are for t0 = 0, and grow by the price of waiting.

Openings come before closings of the same moment: an entry counts from its moment on, an exit up to
its own. These are plain functions of numbers and arrays; `kernels.py` compiles them when it pays.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["met_on_route", "steps_of_members"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
Bytes = NDArray[np.int8]


def steps_of_members(
    entry_first: Longs, entry_at: Longs, entry_value: Floats, opens: Floats, fades: Floats,
    exit_first: Longs, exit_at: Longs, exit_value: Floats, closes: Floats,
    alone: Floats, slack: Floats, along_m: Floats, begin: float, end: float, price: float,
    with_pairs: bool,
) -> tuple[Longs, Floats, Bytes, Floats, Floats, Longs, Longs]:  # fmt: skip
    """Return the steps of all members, one member after the other.

    Parameters
    ----------
    entry_first : ndarray of int, (M + 1,)
        Where each member's entries begin in the arrays after it.
    entry_at : ndarray of int
        Positions on the route, ascending for each member.
    entry_value : ndarray of float
        E_i = D(o, r_i) - P_i.
    opens : ndarray of float
        From which departure on an entry can be used [s].
    fades : ndarray of float
        From which departure on an entry costs waiting [s]; empty if none does.
    exit_first, exit_at : ndarray of int
        As for entries.
    exit_value : ndarray of float
        X_j = P_j + D(r_j, g).
    closes : ndarray of float
        Until which departure an exit can be used [s].
    alone : ndarray of float, (M,)
        Cost alone.
    slack : ndarray of float, (M,)
        How far costs may differ and be equal.
    along_m : ndarray of float, (K + 1,)
        Metres along the route up to each position.
    begin, end : float
        Departures of the master between which steps are wanted [s].
    price : float
        Of a second's waiting.
    with_pairs : bool
        Whether the positions are wanted too; costs equal, they may change without the cost.

    Returns
    -------
    member : ndarray of int, (S,)
        Whose step it is; steps of one member are in order, the first from `begin` on.
    since : ndarray of float, (S,)
        The departure from which on it holds [s].
    after : ndarray of int8, (S,)
        0 if it holds at that departure too, 1 if only after it.
    level : ndarray of float, (S,)
        Least cost in company or alone, without entries that cost waiting.
    sloped : ndarray of float, (S,)
        Least cost with these for a departure at 0; inf if there are none.
    merge, leave : ndarray of int, (S,)
        Positions of the level cost, -1 for alone; empty unless wanted.
    """
    members = len(alone)
    waits = len(fades) > 0
    events = len(opens) + len(fades) + len(closes)
    of = np.empty(events + members, np.int64)
    since = np.empty(events + members)
    after = np.empty(events + members, np.int8)
    level = np.empty(events + members)
    sloped = np.empty(events + members)
    merge = np.empty(events + members if with_pairs else 0, np.int64)
    leave = np.empty(events + members if with_pairs else 0, np.int64)
    found = 0
    widest = 1
    for m in range(members):
        row = (entry_first[m + 1] - entry_first[m]) + (exit_first[m + 1] - exit_first[m])
        widest = max(widest, row)
    most = 1
    while most < widest:
        most *= 2
    least_e = np.empty(2 * most)
    least_x = np.empty(2 * most)
    pair = np.empty(2 * most)
    slope_e = np.empty(2 * most if waits else 0)
    slope_pair = np.empty(2 * most if waits else 0)
    e_leaf = np.empty(widest, np.int64)
    x_leaf = np.empty(widest, np.int64)
    moments = np.empty(2 * widest)
    what = np.empty(2 * widest, np.int64)
    for m in range(members):
        e0, x0 = entry_first[m], exit_first[m]
        ne, nx = entry_first[m + 1] - e0, exit_first[m + 1] - x0
        size = 1
        while size < ne + nx:
            size *= 2
        # Exits before entries of the same position.
        e, x = 0, 0
        for leaf in range(ne + nx):
            if x < nx and (e >= ne or exit_at[x0 + x] <= entry_at[e0 + e]):
                x_leaf[x] = size + leaf
                x += 1
            else:
                e_leaf[e] = size + leaf
                e += 1
        least_e[: 2 * size] = np.inf
        least_x[: 2 * size] = np.inf
        pair[: 2 * size] = np.inf
        if waits:
            slope_e[: 2 * size] = np.inf
            slope_pair[: 2 * size] = np.inf
        count = 0
        for e in range(ne):
            if opens[e0 + e] <= begin:
                if waits and fades[e0 + e] <= begin:
                    slope_e[e_leaf[e]] = entry_value[e0 + e] - price * fades[e0 + e]
                else:
                    least_e[e_leaf[e]] = entry_value[e0 + e]
            elif opens[e0 + e] <= end:
                moments[count], what[count] = opens[e0 + e], e
                count += 1
        if waits:
            for e in range(ne):
                if begin < fades[e0 + e] <= end:
                    moments[count], what[count] = fades[e0 + e], ne + nx + e
                    count += 1
        openings = count
        for x in range(nx):
            if closes[x0 + x] >= begin:
                least_x[x_leaf[x]] = exit_value[x0 + x]
                if closes[x0 + x] < end:
                    moments[count], what[count] = closes[x0 + x], ne + x
                    count += 1
        for node in range(size - 1, 0, -1):
            left, right = 2 * node, 2 * node + 1
            least_e[node] = min(least_e[left], least_e[right])
            least_x[node] = min(least_x[left], least_x[right])
            pair[node] = min(min(pair[left], pair[right]), least_e[left] + least_x[right])
            if waits:
                slope_e[node] = min(slope_e[left], slope_e[right])
                slope_pair[node] = min(
                    min(slope_pair[left], slope_pair[right]), slope_e[left] + least_x[right]
                )
        # Stable, and openings stand first: they come before closings of the same moment.
        order = np.argsort(moments[:count], kind="mergesort")
        at = -1
        while at < count:
            touched = at < 0
            now, kind = begin, 0
            if at < 0:
                at = 0
            else:
                now, kind = moments[order[at]], 0 if order[at] < openings else 1
                while (
                    at < count
                    and moments[order[at]] == now
                    and (0 if order[at] < openings else 1) == kind
                ):
                    event = what[order[at]]
                    at += 1
                    partner = np.inf
                    own = 0.0
                    if event < ne:
                        node = e_leaf[event]
                        own = entry_value[e0 + event]
                        least_e[node] = own
                    elif event < ne + nx:
                        node = x_leaf[event - ne]
                        own = exit_value[x0 + event - ne]
                        least_x[node] = np.inf
                    else:
                        node = e_leaf[event - ne - nx]
                        own = entry_value[e0 + event - ne - nx]
                        least_e[node] = np.inf
                        slope_e[node] = own - price * fades[e0 + event - ne - nx]
                    while node > 1:
                        is_left = node % 2 == 0
                        node //= 2
                        left, right = 2 * node, 2 * node + 1
                        if with_pairs:
                            if event >= ne and event < ne + nx:
                                if not is_left:
                                    partner = min(partner, least_e[left])
                            elif is_left:
                                partner = min(partner, least_x[right])
                        least_e[node] = min(least_e[left], least_e[right])
                        least_x[node] = min(least_x[left], least_x[right])
                        pair[node] = min(
                            min(pair[left], pair[right]), least_e[left] + least_x[right]
                        )
                        if waits:
                            slope_e[node] = min(slope_e[left], slope_e[right])
                            slope_pair[node] = min(
                                min(slope_pair[left], slope_pair[right]),
                                slope_e[left] + least_x[right],
                            )
                    if with_pairs and own + partner <= min(alone[m], level[found - 1]) + slack[m]:
                        touched = True
            value = min(alone[m], pair[1])
            tilted = slope_pair[1] if waits else np.inf
            if not (
                touched
                or value != level[found - 1]
                or tilted != sloped[found - 1]
            ):  # fmt: skip
                continue
            of[found], since[found], after[found] = m, now, kind
            level[found], sloped[found] = value, tilted
            if with_pairs:
                # The longest platoon, then the earliest merging point, as `tie_rule` has it.
                merge[found], leave[found] = -1, -1
                if pair[1] <= alone[m] + slack[m]:
                    limit, longest = pair[1] + slack[m], -1.0
                    lead, e = np.inf, 0
                    for x in range(nx):
                        while e < ne and e_leaf[e] < x_leaf[x]:
                            lead = min(lead, least_e[e_leaf[e]])
                            e += 1
                        if lead + least_x[x_leaf[x]] > limit:
                            continue
                        y = 0
                        while least_e[e_leaf[y]] + least_x[x_leaf[x]] > limit:
                            y += 1
                        i, j = entry_at[e0 + y], exit_at[x0 + x]
                        together = along_m[j] - along_m[i]
                        if together > longest or (together == longest and i < merge[found]):
                            merge[found], leave[found], longest = i, j, together
                    if not (longest > 0 or pair[1] < alone[m] - slack[m]):
                        merge[found], leave[found] = -1, -1
            found += 1
    return (
        of[:found], since[:found], after[:found], level[:found], sloped[:found],
        merge[:found] if with_pairs else merge, leave[:found] if with_pairs else leave,
    )  # fmt: skip


def met_on_route(member: Longs, merge: Longs, leave: Longs, gain: Floats, members: int) -> Floats:
    """Return what the master gains after each of some changes, for it gains once an edge.

    Parameters
    ----------
    member : ndarray of int, (S,)
        Who changes, in order of time.
    merge, leave : ndarray of int, (S,)
        Its new positions, -1 for alone.
    gain : ndarray of float, (K,)
        What the master saves on each edge where it has company.
    members : int
        How many there are; at first all are alone.

    Returns
    -------
    ndarray of float, (S,)
        The sum over the edges on which somebody is there.
    """
    users = np.zeros(len(gain), np.int64)
    first = np.full(members, -1, np.int64)
    last = np.full(members, -1, np.int64)
    total = np.empty(len(member))
    now = 0.0
    for change in range(len(member)):
        m = member[change]
        for edge in range(first[m], last[m]):
            users[edge] -= 1
            if users[edge] == 0:
                now -= gain[edge]
        first[m], last[m] = merge[change], leave[change]
        for edge in range(first[m], last[m]):
            users[edge] += 1
            if users[edge] == 1:
                now += gain[edge]
        total[change] = now
    return total
