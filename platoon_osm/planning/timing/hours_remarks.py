"""What a plan says of closings: who keeps to what and how, and who breaks what."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...plans.clock import MENTIONED_S, duration
from ...plans.plan import Plan
from ...plans.text_table import listed
from .hours_check import Broken

__all__ = ["breaking", "kept"]


def kept(
    before: Plan,
    after: Plan,
    broken: Sequence[Broken],
    left: Sequence[Broken],
    parking: Callable[[int], str],
) -> Iterator[str]:
    """Remark whose times were moved, for what, and how long it stands for that.

    Parameters
    ----------
    before, after : Plan
        With the times without closings, and with those that keep to them.
    broken, left : sequence of Broken
        What their times break.
    parking : callable
        Says of a vehicle that stands where it finds a parking; an empty text if it finds none.

    Yields
    ------
    str
        One a vehicle.
    """
    assert before.timetable is not None
    assert after.timetable is not None
    remaining = {(one.vehicle, one.why) for one in left}
    for index, trip in enumerate(before.trips):
        why = dict.fromkeys(
            one.why for one in broken if one.vehicle == index and (index, one.why) not in remaining
        )
        if not why:
            continue
        moved = _moved(before, after, index, parking)
        yield f"{trip.vehicle} keeps to {listed(list(why))}: {moved}"


def _moved(before: Plan, after: Plan, index: int, parking: Callable[[int], str]) -> str:
    """Return how far a departure was moved, and how much longer the vehicle stands."""
    assert before.timetable is not None
    assert after.timetable is not None
    old, new = before.timetable.vehicles[index], after.timetable.vehicles[index]
    moved = after.timetable.clock.moment(new.departure_s) - before.timetable.clock.moment(
        old.departure_s
    )
    later, stood = moved.total_seconds(), new.waiting_s - old.waiting_s
    parts = []
    if abs(later) >= MENTIONED_S:
        parts.append(f"leaves {duration(abs(later))} {'later' if later > 0 else 'earlier'}")
    if stood >= MENTIONED_S:
        parts.append(f"stands {duration(stood)} more on its way{parking(index)}")
    return f"it {' and '.join(parts)}" if parts else "it goes with others at other times"


def breaking(plan: Plan, left: Sequence[Broken]) -> Iterator[str]:
    """Remark who drives in which closing, and when.

    Parameters
    ----------
    plan : Plan
        With times.
    left : sequence of Broken
        What they break.

    Yields
    ------
    str
        One for each vehicle and closing.
    """
    assert plan.timetable is not None
    clock = plan.timetable.clock
    together: dict[tuple[int, str], list[Broken]] = {}
    for one in left:
        together.setdefault((one.vehicle, one.why), []).append(one)
    for (index, why), own in together.items():
        names = dict.fromkeys(one.road or "a road without a number" for one in own)
        roads = listed(list(names))
        begin, end = (
            clock.moment(clock.seconds(at))
            for at in (min(one.begin for one in own), max(one.end for one in own))
        )
        yield (
            f"{plan.trips[index].vehicle} drives while it may not ({why}), from "
            f"{begin:%Y-%m-%d %H:%M} to {end:%Y-%m-%d %H:%M} on {roads}; "
            "give it other times"
        )
