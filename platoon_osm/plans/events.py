"""Merges and separations as events: who joins or leaves whom, at one place, in driving order."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

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
    master, whose route the others join, does neither. Where whole platoons meet, or the master
    meets one, those join who come without the master, or without the leader if no master is there;
    where they part, those leave.

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

    def note(kind: str, stretch: int, movers: Sequence[int]) -> None:
        for index in movers:
            if (point := point_at(index, kind, stretch)) is None:
                continue
            company = stretches[stretch].company
            key = (kind, point.node, point.edge, point.share, company)
            known = found.get(key)
            own = (*(known.movers if known else ()), index)
            others = tuple(other for other in company if other not in own)
            found[key] = Event(kind, known.point if known else point, own, others, stretch)

    for index, way in enumerate(ways):
        if index not in masters:
            for kind, stretch in _changes(stretches, way):
                note(kind, stretch, [index])
    moved: dict[tuple[str, int], set[int]] = {}
    for event in found.values():
        moved.setdefault((event.kind, event.stretch), set()).update(event.movers)
    for kind, stretch, groups in _meetings(stretches, ways):
        told = moved.get((kind, stretch), set())
        untold = [group for group in groups if told.isdisjoint(group)]
        host = _host(stretches[stretch], untold, masters)
        for group in untold:
            if group != host:
                note(kind, stretch, group)
    # How far each drives in company is summed up once.
    together_m: dict[int, float] = {}
    ordered = [
        (*_driving_order(event, stretches, ways, together_m), event.kind, event.movers, place)
        for place, event in enumerate(found.values())
    ]
    events = tuple(found.values())
    return tuple(events[place] for *_, place in sorted(ordered))


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


def _meetings(
    stretches: Sequence[Stretch], ways: Sequence[Sequence[int]]
) -> Iterator[tuple[str, int, list[tuple[int, ...]]]]:
    """Yield where companies meet and part, and which they are before and after."""
    before = {(index, k): way[place - 1] if place else None
              for index, way in enumerate(ways) for place, k in enumerate(way)}  # fmt: skip
    after = {(index, k): way[place + 1] if place + 1 < len(way) else None
             for index, way in enumerate(ways) for place, k in enumerate(way)}  # fmt: skip
    for number, stretch in enumerate(stretches):
        for kind, beside in (("merge", before), ("separation", after)):
            groups: dict[int, list[int]] = {}
            for index in stretch.company:
                # Who starts or arrives there comes, or goes, by itself.
                place = beside[index, number]
                groups.setdefault(-1 - index if place is None else place, []).append(index)
            if len(groups) > 1:
                yield kind, number, [tuple(some) for some in groups.values()]


def _host(
    stretch: Stretch, groups: Sequence[tuple[int, ...]], masters: Collection[int | None]
) -> tuple[int, ...] | None:
    """Return whom the others join or leave: those with a master, or with who drives foremost."""
    order = sorted(stretch.vehicles, key=lambda index: index not in masters)
    return next((group for index in order for group in groups if index in group), None)


def _driving_order(
    event: Event,
    stretches: Sequence[Stretch],
    ways: Sequence[Sequence[int]],
    together_m: dict[int, float],
) -> tuple[int, int]:
    """Return the vehicle that drives longest with them, and where on its way the event lies."""
    company = (*event.movers, *event.others)
    for index in company:
        if index not in together_m:
            together_m[index] = sum(
                stretches[k].length_m for k in ways[index] if stretches[k].together
            )
    guide = max(company, key=lambda index: (together_m[index], -index))
    way = list(ways[guide])
    place = way.index(event.stretch) if event.stretch in way else len(way)
    return guide, 2 * place + (event.kind == "separation")
