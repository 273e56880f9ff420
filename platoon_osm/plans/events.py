"""Merges and separations as events: who joins or leaves whom, at one place, in driving order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from .records import JointPlan, PlatoonPoint
from .stretches import PlatoonSection

__all__ = ["Event", "platoon_events"]


@dataclass(slots=True)
class Event:
    """Vehicles that join, or leave, a platoon at one node.

    Attributes
    ----------
    kind : "merge" or "separation".
    point : where.
    movers : vehicles that join or leave, positions in the plan.
    others : vehicles already together, or that go on together.
    edge : first edge after a merge, last before a separation; -1 if there is none.
    together_m : for a separation, how far the first mover came in platoon [m].
    """

    kind: str
    point: PlatoonPoint
    movers: list[int]
    others: tuple[int, ...] = ()
    edge: int = -1
    together_m: float = 0.0
    _order: tuple[int, int] = field(default=(0, 0))


def platoon_events(plan: JointPlan, sections: Sequence[PlatoonSection]) -> list[Event]:
    """Return the events of a plan, platoon by platoon, each in driving order."""
    found: dict[tuple[str, int, tuple[int, ...]], Event] = {}
    for index, vehicle in enumerate(plan.vehicles):
        own = [section for section in sections if index in section.vehicles]
        for kind, point in (("merge", vehicle.merge), ("separation", vehicle.separation)):
            if point is None:
                continue
            section = (own[0] if kind == "merge" else own[-1]) if own else None
            company = section.vehicles if section else ()
            event = found.setdefault((kind, point.node, company), Event(kind, point, []))
            event.movers.append(index)
            event.others = tuple(i for i in company if i not in event.movers)
            if len(event.movers) == 1:
                event.together_m = vehicle.platoon_m
            if section:
                event.edge = section.edges[0 if kind == "merge" else -1]
                event._order = _driving_order(plan, event)
    return sorted(found.values(), key=lambda event: (*event._order, event.kind, event.movers))


def _driving_order(plan: JointPlan, event: Event) -> tuple[int, int]:
    """Return the vehicle that drives longest with them, and where on its way the event lies."""
    company = {*event.movers, *event.others}
    guide = max(company, key=lambda index: (plan.vehicles[index].platoon_m, -index))
    edges = plan.vehicles[guide].edges
    place = edges.index(event.edge) if event.edge in edges else len(edges)
    return guide, 2 * place + (event.kind == "separation")
