"""Times that keep to closings: one vehicle against brute force, and companies against it too."""

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.planning.timing.feasible import _Timed
from platoon_osm.planning.timing.forbidden import (
    Part,
    Section,
    allowed_between,
    forbidden_starts,
    latest_starts_along,
    united,
)
from platoon_osm.planning.timing.lawful import lawful_starts
from platoon_osm.planning.timing.limits import Window
from platoon_osm.planning.timing.pieces import pieces_of

DAY = 60
"""Of the grid on which brute force looks."""

SPANS = st.lists(
    st.tuples(st.integers(0, DAY), st.integers(1, 20)).map(lambda one: (one[0], sum(one))),
    max_size=3,
).map(united)


def earliest_starts_along(parts, ready_s):
    """Return the earliest start of each part of a route for who can leave at a moment."""
    starts = []
    at = ready_s
    for part in parts:
        for begin, end in part.forbidden:
            if begin < at < end:
                at = end
        starts.append(at)
        at += part.drive_s
    return starts


@st.composite
def routes(draw, most=3):
    """Return sections of each part of a route, and the parts."""
    parts = []
    for _ in range(draw(st.integers(1, most))):
        lengths = draw(st.lists(st.integers(1, 6), min_size=1, max_size=3))
        at, sections = 0, []
        for length in lengths:
            sections.append(Section(at, at + length, draw(SPANS)))
            at += length
        parts.append((at, tuple(sections)))
    return parts


def is_closed(sections, start):
    """Tell whether somebody who starts then is on a section while it is closed."""
    return any(
        start + section.begin_s < end and begin < start + section.end_s
        for section in sections
        for begin, end in section.closed
    )


def part_of(drive_s, sections):
    return Part(drive_s, forbidden_starts(sections))


@given(routes(most=1), st.integers(-30, 2 * DAY))
def test_a_start_is_forbidden_if_it_meets_a_closing(route, start):
    ((drive_s, sections),) = route
    part = part_of(drive_s, sections)
    assert any(a < start < b for a, b in part.forbidden) == is_closed(sections, start)


@given(routes(), st.integers(0, DAY))
def test_earliest_arrival_is_that_of_brute_force(route, ready):
    """Moments are whole, so the best is on the grid."""
    at = ready
    for drive_s, sections in route:
        at = next(t for t in range(at, at + 9 * DAY) if not is_closed(sections, t)) + drive_s
    starts = earliest_starts_along([part_of(*one) for one in route], ready)
    assert starts[-1] + route[-1][0] == at
    for start, (_, sections) in zip(starts, route, strict=True):
        assert not is_closed(sections, start)


@given(routes(), st.integers(0, 2 * DAY))
def test_latest_departure_is_that_of_brute_force(route, arrival):
    starts = latest_starts_along([part_of(*one) for one in route], arrival)
    parts = [part_of(*one) for one in route]
    found = earliest_starts_along(parts, starts[0])
    assert found[-1] + parts[-1].drive_s <= arrival
    for later in range(1, 30):
        found = earliest_starts_along(parts, starts[0] + later)
        assert found[-1] + parts[-1].drive_s > arrival


@given(SPANS, st.integers(-5, DAY), st.integers(0, DAY))
def test_what_is_not_forbidden_is_allowed(spans, first, long):
    last = first + long
    gaps = allowed_between(spans, first, last)
    for twice in range(2 * first, 2 * last + 1):
        at = twice / 2
        assert any(a <= at <= b for a, b in gaps) != any(a < at < b for a, b in spans)


def least_waiting(parts, ready):
    """Return the least time that a vehicle stands on its way, whenever it leaves."""
    drive = sum(part.drive_s for part in parts)
    found = []
    for leaves in range(ready, ready + 3 * DAY):
        starts = earliest_starts_along(parts, leaves)
        found.append(starts[-1] + parts[-1].drive_s - starts[0] - drive)
    return min(found)


@pytest.mark.parametrize("may_wait", [False, True])
@settings(max_examples=25)
@given(routes(), st.integers(0, DAY))
def test_one_vehicle_waits_least_then_arrives_early(may_wait, route, ready):
    """Where it may not wait in between, the whole route is one part."""
    timed = [_Timed((0,), float(drive_s)) for drive_s, _ in route]
    way = tuple(range(len(route)))
    pieces = pieces_of(timed, [way], set(way) if may_wait else ())
    forbidden = [forbidden_starts(sections) for _, sections in route]
    window = Window(float(ready), None, 10_000.0)
    starts = lawful_starts(pieces, [window], [window], forbidden, (-10.0, 10_000.0))
    for start, shut in zip(starts, forbidden, strict=True):
        assert not any(a + 1e-3 < start < b - 1e-3 for a, b in shut)
    if may_wait:
        waiting = starts[-1] - starts[0] - sum(drive_s for drive_s, _ in route[:-1])
        parts = [part_of(*one) for one in route]
        assert waiting == pytest.approx(least_waiting(parts, ready), abs=1e-3)
    else:
        drive, whole = 0, []
        for drive_s, sections in route:
            whole += [
                Section(drive + one.begin_s, drive + one.end_s, one.closed) for one in sections
            ]
            drive += drive_s
        (alone,) = earliest_starts_along([part_of(drive, whole)], ready)
        assert starts[0] == pytest.approx(alone, abs=1e-3)


def earliest_after(moments):
    """Return for each moment the first of some others that is not before it."""
    found, later, known = {}, None, set(moments)
    for at in range(399, -1, -1):
        later = at if at in known else later
        found[at] = later
    return found


@settings(max_examples=20)
@given(st.lists(routes(most=1), min_size=3, max_size=3), st.integers(0, 20), st.integers(0, 20))
def test_two_that_merge_wait_no_longer_than_brute_force(three, one, two):
    """Two vehicles drive to one place and go on together: least waiting, then least arrivals."""
    (a,), (b,), (c,) = three
    timed = [_Timed((0,), a[0]), _Timed((1,), b[0]), _Timed((0, 1), c[0])]
    pieces = pieces_of(timed, [(0, 2), (1, 2)])
    windows = [Window(float(one), None, 200.0), Window(float(two), None, 200.0)]
    order = [forbidden_starts(part[1]) for part in (a, b, c)]
    place = [
        next(k for k, piece in enumerate(pieces.pieces) if piece.company == company)
        for company in ({0}, {1}, {0, 1})
    ]
    forbidden = [order[place.index(k)] for k in range(3)]
    starts = lawful_starts(pieces, windows, windows, forbidden, (0.0, 400.0))
    mine = [starts[k] for k in place]
    first, second = (
        [t for t in range(ready, 110) if not is_closed(part[1], t)]
        for ready, part in ((one, a), (two, b))
    )
    onward = earliest_after([t for t in range(400) if not is_closed(c[1], t)])
    best = min(
        2 * onward[max(x + a[0], y + b[0])] - x - a[0] - y - b[0] for x, y in product(first, second)
    )
    waiting = 2 * mine[2] - mine[0] - mine[1] - a[0] - b[0]
    assert waiting <= best + 1e-2
    for start, (_, sections) in zip(mine, (a, b, c), strict=True):
        assert not any(x + 1e-2 < start < y - 1e-2 for x, y in forbidden_starts(sections))


def test_who_cannot_but_break_a_closing_is_in_time_all_the_same():
    """In time comes first; a plan says who breaks what."""
    pieces = pieces_of([_Timed((0,), 10.0)], [(0,)])
    window = Window(0.0, None, 20.0)
    starts = lawful_starts(pieces, [window], [window], [((-10.0, 50.0),)], (-10.0, 100.0))
    assert starts[0] == pytest.approx(0.0, abs=1e-3)


@settings(max_examples=10)
@given(st.lists(st.integers(600, 40_000), min_size=1, max_size=4), st.integers(0, 86_400))
def test_nights_of_twenty_days_are_kept_to_the_second(drives, ready):
    """A solver's 1 is off by 1e-6, seconds of twenty days; times are exact all the same."""
    nights = tuple((day * 86_400.0 - 7200, day * 86_400.0 + 18_000) for day in range(-10, 11))
    way = tuple(range(len(drives)))
    timed = [_Timed((0,), float(drive_s)) for drive_s in drives]
    parts = [Part(drive_s, forbidden_starts([Section(0, drive_s, nights)])) for drive_s in drives]
    window = Window(float(ready), None, None)
    starts = lawful_starts(
        pieces_of(timed, [way], way), [window], [window], [part.forbidden for part in parts],
        (-864_000.0, 864_000.0),
    )  # fmt: skip
    for start, part in zip(starts, parts, strict=True):
        assert not any(a + 1e-3 < start < b - 1e-3 for a, b in part.forbidden)
    waiting = starts[-1] - starts[0] - sum(drives[:-1])
    tried = (earliest_starts_along(parts, ready + 60 * k) for k in range(2880))
    least = min(found[-1] - found[0] - sum(drives[:-1]) for found in tried)
    assert waiting <= least + 1e-2
