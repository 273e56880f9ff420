"""A truck's lawful trips on its way that pay least: labels that may join others' companies.

A label is a legal beginning of the trip (`planning.legal.driver.label`) with what was paid so far.
At the beginning of each lane it drives on alone, as soon as its pause allows, or joins a company:
then it leaves every point of the lane at that company's instants, and stands where they stand. What
it stands is a pause of its own as far as the law has it so. Of two labels one is dropped if the
other has paid no more and is in nothing behind (`planning.legal.driver.dominance`).

Standing may have a price: w for each second by which a trip stands longer on its way than `stands`.
A label has been on its way for G, and that stays so up to a departure at M; if it goes on at T, it
has been for max(G, T - M). So a label that follows another's trip stands longer by at most
max(0, G - G', M' - M), and it is in nothing behind if it is not even with w times that added to
what it paid.

Functions are plain; `compiled` compiles them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...planning.legal.driver.dominance import DOMINANCE, ask_less, covers
from ...planning.legal.driver.driving import drive
from ...planning.legal.driver.kept_labels import KEPT, grown
from ...planning.legal.driver.label import (
    CLOSES,
    COLUMNS,
    GONE,
    GONE_MOST,
    INFO,
    KIND,
    LASTS,
    OPENS,
    PARENT,
    TIME,
    WEEKLY_END,
)
from ...planning.legal.driver.least_left import LEFT, in_time
from ...planning.legal.driver.leaving import LEAVING
from ...planning.legal.driver.numbers import NONE
from ...planning.legal.driver.pausing import PAUSES, allowed, lasts, leave
from ...planning.legal.driver.road import NO_LIMIT

__all__ = ["HELPERS", "PAID", "PRICED", "WITH", "search_joining"]

Ints = NDArray[np.int64]

PAID, WITH, PRICED, BESIDES = 0, 1, 2, 3
"""What is kept beside a label: what was paid, the company of its lane, -1 for none, and what was
paid with what it has stood too long."""


def _narrowed(
    kept: Ints, kept_info: Ints, kept_paid: Ints, begin: int, total: int, width: int
) -> None:
    """Move some labels of a point to the front: half of them the cheapest, the rest the first."""
    size = total - begin
    cheapest = np.argsort(kept_paid[begin:total, PRICED], kind="mergesort")
    chosen = np.zeros(size, np.int64)
    taken = np.zeros(size, np.bool_)
    count = 0
    for row in cheapest:
        if count < width // 2:
            taken[row] = True
            count += 1
    for row in range(size):
        if count < width and not taken[row]:
            taken[row] = True
            count += 1
    place = 0
    for row in range(size):
        if taken[row]:
            chosen[place] = row
            place += 1
    for place in range(count):
        # Rows only move to the front, so none is overwritten before it is read.
        kept[begin + place] = kept[begin + chosen[place]]
        kept_info[begin + place] = kept_info[begin + chosen[place]]
        kept_paid[begin + place] = kept_paid[begin + chosen[place]]


def search_joining(
    drive_s: Ints, clock_s: Ints, stay_s: Ints, lane_of: Ints, first_hop: Ints,
    windows_first: Ints, windows_s: Ints, numbers: Ints, kinds: Ints,
    begins: Ints, begins_info: Ints, begins_with: Ints,
    first_offer: Ints, offer_cost: Ints, first_moment: Ints, moments: Ints,
    alone: Ints, to_go: Ints, below: int, waiting: int, stands: int,
    monday: int, fixed_weekly_end: int, latest: int, weeks: int, weekly: int, width: int,
    dominance: bool,
) -> tuple[Ints, Ints, Ints, Ints]:  # fmt: skip
    """Return the labels of each point.

    Parameters
    ----------
    drive_s, clock_s : int64 array, (n,)
        Of the hops of the way [s].
    stay_s : int64 array, (n + 1,)
        The longest pause at each point [s].
    lane_of : int64 array, (n,)
        Which lane of the way each hop is a part of.
    first_hop : int64 array, (M + 1,)
        Where the hops of each lane begin.
    windows_first, windows_s : int64 array
        Of `planning.legal.driver.waiting.windows_of`.
    numbers, kinds : int64 array
        The limits, and the kinds of pause that they know.
    begins, begins_info, begins_with : int64 array
        Labels that leave the origin, how, and which offer of the first lane each takes; -1 alone.
    first_offer : int64 array, (M + 1,)
        Where the offers of each lane begin: companies that may be joined there.
    offer_cost : int64 array, (O,)
        What each costs the fleet more if it is joined [grains].
    first_moment, moments : int64 array, (O + 1,) and more
        When each leaves the points of its lane, hop by hop [s].
    alone : int64 array, (M,)
        What each lane costs alone [grains].
    to_go : int64 array, (M + 1,)
        What the lanes from each on cost at least [grains].
    below : int
        Only trips that pay less than this are looked for [grains].
    waiting : int
        What each second costs that it stands longer than `stands` [grains/s].
    stands : int
        How long it stands for nothing [s].
    monday : int
        A Monday 0:00 UTC [s].
    fixed_weekly_end : int
        The end of a weekly rest that does not move with the departure [s].
    latest : int
        When the destination has to be reached [s].
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.
    width : int
        How many labels of each point are kept; 0 for all.
    dominance : bool
        Whether labels are dropped for others.

    Returns
    -------
    int64 array, (m, COLUMNS)
        The labels.
    int64 array, (m, INFO)
        How each came about.
    int64 array, (m, 3)
        What each has paid, the offer it takes on the lane that it has driven last, and what it has
        paid with its standing.
    int64 array, (n + 2,)
        Where the labels of each point begin.
    """
    n = len(drive_s)
    p = numbers
    left_s = np.zeros(n + 1, np.int64)
    left_clock = np.zeros(n + 1, np.int64)
    for k in range(n - 1, -1, -1):
        left_s[k] = left_s[k + 1] + drive_s[k]
        left_clock[k] = left_clock[k + 1] + clock_s[k]
    first = np.zeros(n + 2, np.int64)
    kept = np.zeros((256, COLUMNS), np.int64)
    kept_info = np.zeros((256, INFO), np.int64)
    kept_paid = np.zeros((256, BESIDES), np.int64)
    found = np.zeros((256, COLUMNS), np.int64)
    found_info = np.zeros((256, INFO), np.int64)
    found_paid = np.zeros((256, BESIDES), np.int64)
    need = np.zeros(COLUMNS, np.int64)
    total = 0
    for k in range(n):
        lane = lane_of[k]
        enters = first_hop[lane] == k
        ends = first_hop[lane + 1] == k + 1
        due = latest - left_s[k + 1]
        windows = windows_s[windows_first[k] : windows_first[k + 1]]
        regular = max(1, len(windows))
        low, high = first[k], total
        if k == 0:
            low, high = 0, len(begins)
        count = 0
        for label in range(low, high):
            # Alone, then in each company that may be joined; within a lane as it began.
            offer, offers_end = -1, first_offer[lane + 1]
            if k == 0:
                offer, offers_end = begins_with[label], begins_with[label] + 1
            elif not enters:
                offer, offers_end = kept_paid[label, WITH], kept_paid[label, WITH] + 1
            while offer < offers_end:
                joined = offer
                offer = first_offer[lane] if enters and k > 0 and offer < 0 else offer + 1
                paid = 0 if k == 0 else kept_paid[label, PAID]
                if enters:
                    paid += alone[lane] if joined < 0 else offer_cost[joined]
                    if paid + to_go[lane + 1] >= below:
                        continue
                moment = NO_LIMIT
                if joined >= 0:
                    moment = moments[first_moment[joined] + k - first_hop[lane]]
                    if (k > 0 and kept[label, TIME] > moment) or moment + drive_s[k] > due:
                        continue
                for choice in range(1 if k == 0 else len(kinds)):
                    kind = NONE
                    if k > 0:
                        kind = kinds[choice]
                        if kind != NONE and p[kind] > stay_s[k]:
                            break
                        if not allowed(kind, kept[label], p):
                            continue
                    for opening in range(1 if k == 0 else regular):
                        found = grown(found, count + 2)
                        found_info = grown(found_info, count + 2)
                        found_paid = grown(found_paid, count + 2)
                        out = found[count]
                        if k == 0:
                            out[:] = begins[label]
                            found_info[count] = begins_info[label]
                        else:
                            a = kept[label]
                            opens, closes, forced = -NO_LIMIT, NO_LIMIT, 0
                            if len(windows) > 0:
                                opens, closes = windows[opening, 0], windows[opening, 1]
                            if joined >= 0:
                                if moment < opens or moment > closes:
                                    continue
                                opens, closes, forced = moment, moment, 1
                            if closes < a[TIME] or opens + drive_s[k] > due:
                                continue
                            if not leave(
                                kind, a[TIME], opens, closes, stay_s[k], forced, a, p, monday,
                                fixed_weekly_end, out,
                            ):  # fmt: skip
                                continue
                            found_info[count, PARENT] = label
                            found_info[count, KIND] = kind
                            found_info[count, OPENS] = opens
                            found_info[count, CLOSES] = closes
                            found_info[count, LASTS] = lasts(kind, a, p)
                        if not drive(out, drive_s[k], clock_s[k], p, monday, weeks, weekly):
                            continue
                        if out[TIME] > due or not in_time(
                            out, left_s[k + 1], left_clock[k + 1], latest, -NO_LIMIT, p, monday,
                            False, weeks, weekly, out[WEEKLY_END] > fixed_weekly_end,
                        ):  # fmt: skip
                            continue
                        longer = out[GONE] - (left_s[0] - left_s[k + 1]) - stands
                        priced = paid + waiting * max(0, longer)
                        if priced + to_go[lane + 1] >= below:
                            continue
                        found_paid[count, PAID] = paid
                        found_paid[count, WITH] = joined
                        found_paid[count, PRICED] = priced
                        count += 1
        first[k + 1] = total
        if count == 0:
            for rest in range(k + 1, n + 1):
                first[rest + 1] = total
            return kept, kept_info, kept_paid, first
        begin = total
        order = np.argsort(found[:count, TIME], kind="mergesort")
        place = stay_s[k + 1] >= NO_LIMIT
        for label in order:
            need[:] = found[label]
            ask_less(
                need, left_s[k + 1], left_clock[k + 1], latest,
                need[WEEKLY_END] > fixed_weekly_end, p,
            )  # fmt: skip
            covered = False
            if dominance:
                for other in range(begin, total):
                    more = 0
                    if waiting > 0:
                        more = max(
                            0, kept[other, GONE] - need[GONE],
                            need[GONE_MOST] - kept[other, GONE_MOST],
                        )  # fmt: skip
                    if kept_paid[other, PAID] + waiting * more > found_paid[label, PAID]:
                        continue
                    if not ends and kept_paid[other, WITH] != found_paid[label, WITH]:
                        continue
                    if covers(kept[other], need, place, False, weeks, weekly):
                        covered = True
                        break
            if covered:
                continue
            kept = grown(kept, total + 1)
            kept_info = grown(kept_info, total + 1)
            kept_paid = grown(kept_paid, total + 1)
            kept[total] = found[label]
            kept_info[total] = found_info[label]
            kept_paid[total] = found_paid[label]
            total += 1
        if width > 0 and total - begin > width:
            _narrowed(kept, kept_info, kept_paid, begin, total, width)
            total = begin + width
    first[n + 1] = total
    return kept, kept_info, kept_paid, first


HELPERS = (*PAUSES, drive, *LEFT, *DOMINANCE, *LEAVING, *KEPT, _narrowed)
"""What the search calls: to be made known to the compiler before it."""
