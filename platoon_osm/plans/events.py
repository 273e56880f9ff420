"""Merges and separations as events: who joins or leaves whom, at one place, in driving order."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from .records import Event, Platoon, PlatoonPoint, Stretch

__all__ = ["platoon_events"]

PointAt = Callable[[int, str, int], PlatoonPoint | None]
"""Returns the point where a vehicle begins ("merge") or ends ("separation") a stretch, if known."""


def platoon_events(
    stretches: Sequence[Stretch],
    ways: Sequence[Sequence[int]],
    platoons: Sequence[Platoon],
    point_at: PointAt,
) -> tuple[Event, ...]:
    """Return the events of a plan, platoon by platoon, each in driving order.

    A vehicle merges where it begins to drive with others and separates where it stops to; the
    master, whose route the others join, does neither.

    Parameters
    ----------
    stretches, ways, platoons : sequence
        Fields of `Plan`.
    point_at : callable
        Returns the `PlatoonPoint` where a vehicle begins ("merge") or ends ("separation") a
        stretch, given the positions of vehicle and stretch, with its `km` left at 0; None if it
        is not known.

    Returns
    -------
    tuple of Event
        Those who join, or leave, the same company at the same place are one event.
    """
    masters = {platoon.master for platoon in platoons}
    found: dict[tuple[object, ...], Event] = {}
    for index, way in enumerate(ways):
        if index in masters:
            continue
        for kind, stretch in _changes(stretches, way):
            if (point := point_at(index, kind, stretch)) is None:
                continue
            company = stretches[stretch].company
            key = (kind, point.node, point.edge, point.share, company)
            movers = (*(found[key].movers if key in found else ()), index)
            found[key] = Event(
                kind,
                found[key].point if key in found else point,
                movers,
                tuple(other for other in company if other not in movers),
                stretch,
            )
    order = {event: _driving_order(event, stretches, ways) for event in found.values()}
    return tuple(sorted(found.values(), key=lambda one: (*order[one], one.kind, one.movers)))


def _changes(stretches: Sequence[Stretch], way: Sequence[int]) -> list[tuple[str, int]]:
    """Return where a vehicle begins and ends to drive in company."""
    found: list[tuple[str, int]] = []
    together = False
    for place, stretch in enumerate(way):
        now = stretches[stretch].together
        if now and not together:
            found.append(("merge", stretch))
        if together and not now:
            found.append(("separation", way[place - 1]))
        together = now
    if together:
        found.append(("separation", way[-1]))
    return found


def _driving_order(
    event: Event, stretches: Sequence[Stretch], ways: Sequence[Sequence[int]]
) -> tuple[int, int]:
    """Return the vehicle that drives longest with them, and where on its way the event lies."""
    guide = max(
        (*event.movers, *event.others),
        key=lambda index: (
            sum(stretches[k].length_m for k in ways[index] if stretches[k].together),
            -index,
        ),
    )
    way = list(ways[guide])
    place = way.index(event.stretch) if event.stretch in way else len(way)
    return guide, 2 * place + (event.kind == "separation")
