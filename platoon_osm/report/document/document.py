"""One plan on one network as one JSON document: all that the page shows, and nothing else.

The schema is described in docs/report.md. Texts have passed `shown`, figures come both as numbers
in SI units and, where the page prints them, as text.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ...costs.weights import EdgeWeights
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.clock import duration
from ...plans.events import Event, platoon_events
from ...plans.records import JointPlan, Stop, VehiclePlan
from ...plans.stretches import (
    PlatoonPart,
    PlatoonSection,
    platoon_groups,
    platoon_parts,
    platoon_sections,
    solo_stretches,
)
from ..drawing.basemap import encoded_basemap, encoded_route
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..markup.quantities import CostUnit, clock_span, cost_unit, kilometres, litres, percent, signed
from ..markup.shown_text import fitted, shortened, shown
from .driver_fatigue import fatigue_along
from .journey import Journey, journey, ways
from .opposite import opposite_gaps
from .place_labels import junction_labels, town_labels
from .provenance import provenance
from .solo_costs import known_weights, sum_over
from .timeline import event_time, timeline, vehicle_day, waits_at

__all__ = ["DOCUMENT_VERSION", "check_plan", "report_document"]

DOCUMENT_VERSION = 3

MOST_NAMED = 5
"""Vehicles named one by one; a larger company is called the platoon."""

MOST_ROWS = 12
"""Vehicles in the table that a platoon shows when pointed at."""

ROLES = {"master": "master route", "member": "member", "alone": "stays alone"}


def report_document(
    plan: JointPlan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    weights: EdgeWeights | None = None,
    styles: Mapping[str, VehicleStyle] | None = None,
) -> dict[str, Any]:
    """Return the document of a plan, plain JSON types throughout.

    Parameters
    ----------
    net : the network the plan was made on.
    title : heads the page; by default made from the first vehicle's journey.
    weights : those the plan was made with. The paper's preset needs none; for others they tell
        what a section costs alone and what a detour costs, which is left out without them.
    styles : letter, colour and dash of each vehicle by its name; by default their own. Several
        documents that share a page share these.

    Raises
    ------
    ScenarioError
        A plan of another network, without vehicles, with two vehicles of one name, or weights
        that do not fit it.
    """
    check_plan(plan, net)
    unit = cost_unit(plan.unit)
    known = known_weights(plan, net, weights)
    looks = (
        vehicle_styles([vehicle.vehicle for vehicle in plan.vehicles])
        if styles is None
        else [styles[vehicle.vehicle] for vehicle in plan.vehicles]
    )
    sections = platoon_sections(plan)
    events = platoon_events(plan, sections)
    scale = journey(plan, net, sections)
    vehicles = [
        {
            **_vehicle(plan.vehicles[index], looks[index], unit, known, way),
            "fatigue": fatigue_along(plan.vehicles[index], plan.times[index]),
            "times": vehicle_day(plan, index, net, sections),
        }
        for index, way in enumerate(ways(plan, sections))
    ]
    opposite = opposite_gaps(net, (edge for vehicle in plan.vehicles for edge in vehicle.edges))
    parts = platoon_parts(sections, opposite)
    return {
        "format": "platoon_osm report",
        "version": DOCUMENT_VERSION,
        "title": fitted(title) if title and shown(title) else _default_title(plan),
        "subtitle": _subtitle(plan, events, sections),
        "cost_unit": {"label": unit.label, "note": unit.note},
        "totals": _totals(plan, net, sections, unit),
        "vehicles": vehicles,
        "groups": list(_groups(plan, net, sections, looks, unit)),
        "platoons": [
            _platoon(plan, net, section, cut, looks, unit, known)
            for section, cut in zip(sections, parts, strict=True)
        ],
        "solos": list(_solos(plan, net, sections, opposite, looks, unit)),
        "events": [_event(plan, net, event, looks, scale) for event in events],
        "journey": _journey(scale),
        "schedule": timeline(plan),
        "inferred_routes": _inferred_routes(plan, net),
        "towns": town_labels(net),
        "junctions": junction_labels(net),
        "basemap": encoded_basemap(net),
        "provenance": provenance(plan, net),
    }


def check_plan(plan: JointPlan, net: RoadNetwork) -> None:
    """Raise `ScenarioError` unless the plan has vehicles and was made on this network."""
    if not plan.vehicles:
        raise ScenarioError("report: the plan has no vehicles; plan at least one trip")
    if plan.network.identity != net.identity():
        raise ScenarioError(
            f"report: the plan was made on {plan.network.name!r} ({plan.network.identity}), not "
            f"on {net.source.name!r} ({net.identity()}); load the network it was made on"
        )
    plan.check_timetable()
    seen: set[str] = set()
    for vehicle in plan.vehicles:
        if vehicle.vehicle in seen:
            raise ScenarioError(
                f"report: two vehicles are named {vehicle.vehicle!r}; give each its own name"
            )
        seen.add(vehicle.vehicle)
        for edge in (*vehicle.edges, *vehicle.alone.edges):
            if not 0 <= edge < net.m:
                raise ScenarioError(
                    f"report: vehicle {vehicle.vehicle!r} drives edge {edge}, the network has "
                    f"0 to {net.m - 1}; plan again"
                )


def _default_title(plan: JointPlan) -> str:
    first = next((v for v in plan.vehicles if v.role == "master"), plan.vehicles[0])
    ends = (shortened(shown(stop.name), 40) for stop in (first.origin, first.destination))
    return "Platoon plan, " + " \u2013 ".join(ends)


def _count(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"


def _subtitle(plan: JointPlan, events: Sequence[Event], sections: Sequence[PlatoonSection]) -> str:
    merges = sum(event.kind == "merge" for event in events)
    parts = [_count(len(plan.vehicles), "vehicle", "vehicles")]
    groups = len(platoon_groups(sections, len(plan.vehicles)))
    if groups > 1:
        parts.append(f"{groups} platoons")
    if events:
        parts.append(_count(merges, "merge point", "merge points"))
        parts.append(_count(len(events) - merges, "separation point", "separation points"))
    else:
        parts.append("no platoon")
    return ", ".join(parts)


def _totals(
    plan: JointPlan, net: RoadNetwork, sections: Sequence[PlatoonSection], unit: CostUnit
) -> dict[str, Any]:
    # The vehicles of a platoon share one road: its length counts once here.
    road_m = sum(sum_over(net.length_m, section.edges) for section in sections)
    alone_l = sum(vehicle.alone.fuel_l for vehicle in plan.vehicles)
    saved_l = alone_l - sum(vehicle.fuel_l for vehicle in plan.vehicles)
    extra_m = sum(vehicle.length_m - vehicle.alone.length_m for vehicle in plan.vehicles)
    saved = plan.solo_cost - plan.joint_cost
    figures = [
        {
            "figure": percent(plan.saving).replace("-", "\u2212"),
            "label": f"saved, {unit.full(saved)}",
            "kind": "good" if saved > 0 else "plain",
        },
        {
            "figure": kilometres(road_m),
            "label": f"of road in platoon, {plan.platoon_m / 1000:,.0f} vehicle-km",
            "kind": "plain",
        },
    ]
    # Shorter is possible: alone, a vehicle may take a longer road that costs less.
    longer = f"{kilometres(abs(extra_m))} {'further' if extra_m >= 0 else 'less'} to drive"
    if abs(extra_m) < 50:
        longer = "no extra distance"
    if plan.timetable is not None:
        fuel = f"{litres(saved_l)} of fuel saved" if saved_l > 0 else "no fuel saved"
        waiting = clock_span(plan.timetable.waiting_s)
        figures.append(
            {"figure": waiting, "label": f"waiting on the road; {fuel}", "kind": "plain"}
        )
    elif saved_l > 0:
        share = f"{percent(saved_l / alone_l)} of fuel saved"
        figures.append({"figure": litres(saved_l), "label": f"{share}; {longer}", "kind": "plain"})
    else:
        figures.append(
            {"figure": kilometres(extra_m), "label": "further than alone", "kind": "plain"}
        )
    return {
        "solo_cost": plan.solo_cost,
        "joint_cost": plan.joint_cost,
        "saving": plan.saving,
        "platoon_road_m": road_m,
        "platoon_m": plan.platoon_m,
        "fuel_saved_l": saved_l,
        "extra_m": extra_m,
        "figures": figures,
        "text": _cost_texts(plan.solo_cost, plan.joint_cost, unit),
    }


def _cost_texts(alone: float, joint: float, unit: CostUnit) -> dict[str, str]:
    return {
        "alone": unit.bare(alone),
        "joint": unit.bare(joint),
        "saved": unit.bare_signed(alone - joint),
        "share": signed(percent(1 - joint / alone if alone else 0.0)),
    }


def _groups(
    plan: JointPlan,
    net: RoadNetwork,
    sections: Sequence[PlatoonSection],
    styles: Sequence[VehicleStyle],
    unit: CostUnit,
) -> Iterator[dict[str, Any]]:
    """Yield platoons as groups of vehicles, then those who drive alone as one group."""
    groups = platoon_groups(sections, len(plan.vehicles))
    grouped = {index for group in groups for index in group}
    alone = [index for index in range(len(plan.vehicles)) if index not in grouped]
    kinds = [("platoon", list(group)) for group in groups] + [("alone", alone)] * bool(alone)
    for number, (kind, members) in enumerate(kinds, 1):
        own = [part for part in sections if part.vehicles[0] in members]
        road_m = sum(sum_over(net.length_m, part.edges) for part in own)
        before = sum(plan.vehicles[index].solo_cost for index in members)
        after = sum(plan.vehicles[index].joint_cost for index in members)
        facts = [_count(len(members), "vehicle", "vehicles")]
        if len(members) > 1:
            facts[0] += f" ({joined([styles[index].letter for index in members])})"
        if kind == "platoon":
            facts.append(f"{kilometres(road_m)} of road in platoon")
        yield {
            "kind": kind,
            "name": f"Platoon {number}" if kind == "platoon" else "Driving alone",
            "facts": ", ".join(facts),
            "vehicles": members,
            "road_m": road_m,
            "saved": before - after,
            "text": _cost_texts(before, after, unit),
        }


def _journey(scale: Journey | None) -> dict[str, Any] | None:
    if scale is None:
        return None
    return {
        "length_m": round(scale.length_m, 1),
        "starts_m": [round(start, 1) for start in scale.starts_m],
        "guide": scale.guide,
    }


def _stop(stop: Stop) -> dict[str, Any]:
    return {"lon": round(stop.lon, 6), "lat": round(stop.lat, 6), "name": fitted(stop.name)}


def _vehicle(
    vehicle: VehiclePlan,
    style: VehicleStyle,
    unit: CostUnit,
    known: EdgeWeights | None,
    way: list[tuple[str, int]],
) -> dict[str, Any]:
    saved = vehicle.solo_cost - vehicle.joint_cost
    detour = platoon_gain = None
    if known is not None:
        # saved = gain of the platoon on the way driven - what that way costs more alone
        driven_alone = sum_over(known.solo, vehicle.edges)
        detour = max(driven_alone - vehicle.solo_cost, 0.0)
        platoon_gain = saved + detour
    name = fitted(vehicle.vehicle)
    inferred_m = sum(leg.inferred_m for leg in vehicle.legs)
    return {
        "name": name if name != style.letter else "",
        "letter": style.letter,
        "colour": style.colour,
        "dash": style.dash,
        "cap": style.cap,
        "role": vehicle.role,
        "role_text": ROLES.get(vehicle.role, fitted(vehicle.role)),
        "origin": _stop(vehicle.origin),
        "destination": _stop(vehicle.destination),
        "length_m": vehicle.length_m,
        "length_text": kilometres(vehicle.length_m),
        "alone_length_m": vehicle.alone.length_m,
        "platoon_m": vehicle.platoon_m,
        "inferred_m": inferred_m,
        "inferred_text": kilometres(inferred_m) if inferred_m > 0 else "",
        "fuel_l": vehicle.fuel_l,
        "alone_fuel_l": vehicle.alone.fuel_l,
        "solo_cost": vehicle.solo_cost,
        "joint_cost": vehicle.joint_cost,
        "saved": saved,
        "saving": vehicle.saving,
        "platoon_gain": platoon_gain,
        "detour": detour,
        "reason": fitted(vehicle.reason),
        "way": [[kind, piece] for kind, piece in way],
        "text": {
            **_cost_texts(vehicle.solo_cost, vehicle.joint_cost, unit),
            "gain": "" if platoon_gain is None else unit.bare(platoon_gain),
            "detour": "" if detour is None else unit.bare(detour),
        },
    }


# -- events ----------------------------------------------------------------------------------------


def _event(
    plan: JointPlan,
    net: RoadNetwork,
    event: Event,
    styles: Sequence[VehicleStyle],
    scale: Journey | None,
) -> dict[str, Any]:
    movers = joined([styles[i].letter for i in event.movers])
    others = [styles[i].letter for i in event.others]
    one = len(event.movers) == 1
    if not others and not one:
        # Case D: both vehicles come to the point, and both leave it.
        what = f"{movers} {'meet' if event.kind == 'merge' else 'part'}"
    elif event.kind == "merge":
        whom = joined(others) if 0 < len(others) <= MOST_NAMED else "the platoon"
        what = f"{movers} {'joins' if one else 'join'} {whom}"
    else:
        what = f"{movers} {'leaves' if one else 'leave'}"
    at_s = event_time(plan, event)
    if plan.timetable is not None and at_s is not None:
        what = f"{plan.timetable.clock.text(at_s)}, {what}"
    return {
        "kind": event.kind,
        "lon": round(event.point.lon, 6),
        "lat": round(event.point.lat, 6),
        "name": fitted(event.point.name),
        "vehicles": event.movers,
        "others": list(event.others),
        "at_m": _on_scale(plan, event, scale),
        "at_s": None if at_s is None else round(at_s, 1),
        "text": what,
        "detail": ", ".join(
            text
            for text in (_event_detail(plan, net, event), _waiting(plan, event, styles))
            if text
        ),
    }


def _on_scale(plan: JointPlan, event: Event, scale: Journey | None) -> float | None:
    if scale is None:
        return None
    vehicle = plan.vehicles[event.movers[0]]
    point = vehicle.merge if event.kind == "merge" else vehicle.separation
    return round(scale.starts_m[event.movers[0]] + (point.km if point else 0.0) * 1000, 1)


def joined(letters: Sequence[str], most: int = MOST_NAMED) -> str:
    """Return "A, B and C"; beyond `most` letters, "A, B, C and 14 more"."""
    if len(letters) > most:
        return f"{', '.join(letters[: most - 1])} and {len(letters) - most + 1} more"
    return " and ".join(part for part in (", ".join(letters[:-1]), *letters[-1:]) if part)


def _waiting(plan: JointPlan, event: Event, styles: Sequence[VehicleStyle]) -> str:
    """Return who waits there and how long: "B waits 24 min", at most a few."""
    waits = waits_at(plan, event)
    parts = [f"{styles[i].letter} waits {duration(wait)}" for i, wait in waits[:MOST_NAMED]]
    if len(waits) > MOST_NAMED:
        parts.append(f"{len(waits) - MOST_NAMED} more wait")
    return ", ".join(parts)


def _event_detail(plan: JointPlan, net: RoadNetwork, event: Event) -> str:
    road = shortened(shown(net.edge_ref(event.edge)), 40) if event.edge >= 0 else ""
    first = plan.vehicles[event.movers[0]]
    parts = [road]
    if len(event.movers) == 1:
        if event.kind == "merge":
            parts.append(
                f"{kilometres(event.point.km * 1000)} from {fitted(first.origin.name)}"
                if event.point.km >= 0.05
                else "at its start"
            )
        else:
            parts.append(f"after {kilometres(event.together_m)} in platoon")
            parts.append(f"towards {fitted(first.destination.name)}")
    return ", ".join(part for part in parts if part)


# -- lines on the map ------------------------------------------------------------------------------


def _platoon(
    plan: JointPlan,
    net: RoadNetwork,
    section: PlatoonSection,
    parts: Sequence[PlatoonPart],
    styles: Sequence[VehicleStyle],
    unit: CostUnit,
    known: EdgeWeights | None,
) -> dict[str, Any]:
    length_m = sum_over(net.length_m, section.edges)
    rows: list[list[str]] = []
    shares: list[dict[str, Any]] = []
    for index in section.vehicles:
        vehicle = plan.vehicles[index]
        alone, joint = _section_costs(vehicle, section, known)
        shares.append({"vehicle": index, "cost_alone": alone, "cost_platoon": joint})
        if joint is not None and alone is not None:
            text = _cost_texts(alone, joint, unit)
            rows.append([styles[index].letter, text["alone"], text["joint"], text["share"]])
        elif joint is not None:
            rows.append([styles[index].letter, "", unit.bare(joint), ""])
    letters = joined([styles[i].letter for i in section.vehicles])
    return {
        "vehicles": list(section.vehicles),
        "length_m": length_m,
        "costs": shares,
        "parts": [
            {
                "line": encoded_route(net, part.edges),
                "beside": list(part.beside),
                "place": part.place,
                "opposite_m": part.opposite_m,
            }
            for part in parts
        ],
        "tip": {
            "head": f"Platoon of {letters}",
            "lines": [f"{kilometres(length_m)}; costs in {unit.label}"],
            "columns": ["Vehicle", "Alone", "In platoon", "Saving"] if rows else [],
            "rows": rows[:MOST_ROWS],
            "more": f"and {len(rows) - MOST_ROWS} more" if len(rows) > MOST_ROWS else "",
        },
    }


def _section_costs(
    vehicle: VehiclePlan, section: PlatoonSection, known: EdgeWeights | None
) -> tuple[float | None, float | None]:
    """Return the cost of a section alone and in platoon; None where the plan does not tell."""
    whole = next((leg.cost for leg in vehicle.legs if leg.edges == section.edges), None)
    if known is None:
        return None, whole
    own = known.master if vehicle.role == "master" else known.platoon
    joint = sum_over(own, section.edges) if whole is None else whole
    return sum_over(known.solo, section.edges), joint


def _solos(
    plan: JointPlan,
    net: RoadNetwork,
    sections: Sequence[PlatoonSection],
    opposite: Mapping[int, int],
    styles: Sequence[VehicleStyle],
    unit: CostUnit,
) -> Iterator[dict[str, Any]]:
    for stretch in solo_stretches(plan, sections, opposite):
        vehicle, leg = plan.vehicles[stretch.vehicle], stretch.leg
        name = fitted(vehicle.vehicle)
        letter = styles[stretch.vehicle].letter
        yield {
            "vehicle": stretch.vehicle,
            "length_m": leg.length_m,
            "cost": leg.cost,
            "parts": [
                {
                    "line": encoded_route(net, part.edges),
                    "slot": part.slot,
                    "slots": part.slots,
                    "bands": list(part.bands),
                    "opposite_m": part.opposite_m,
                }
                for part in stretch.parts
            ],
            "tip": {
                "head": f"{letter} alone" if name == letter else f"{letter} alone ({name})",
                "lines": [
                    f"{kilometres(leg.length_m)}, cost {unit.full(leg.cost)}",
                    *([f"{kilometres(leg.inferred_m)} inferred"] if leg.inferred_m > 0 else []),
                ],
                "columns": [],
                "rows": [],
                "more": "",
            },
        }


def _inferred_routes(plan: JointPlan, net: RoadNetwork) -> list[str]:
    """Return the stretches of all routes that the loader inferred, each once."""
    lines: dict[str, None] = {}
    for vehicle in plan.vehicles:
        run: list[int] = []
        for edge in (*vehicle.edges, -1):
            if edge >= 0 and net.inferred[edge]:
                run.append(edge)
            elif run:
                lines[encoded_route(net, tuple(run))] = None
                run = []
    return list(lines)
