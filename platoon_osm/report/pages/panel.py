"""The page's static HTML from a report document: figures, table, bars, lists, legend."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from ..charts.charts import along_chart, fatigue_chart
from ..charts.schedule_chart import late_note, schedule_chart
from ..charts.waiting_bars import waiting_bars
from ..drawing.static_map import static_map
from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import NOTHING, Markup, fill, join
from .legend import legend
from .page_pieces import about, badge, credit_lines, heading, opening, unit_note

__all__ = ["page_body"]

OPEN_UP_TO = 12
"""Vehicles in a plan all of whose groups are open from the start."""

COMPACT_BEYOND = 8
"""More vehicles than this get the narrow table, which scrolls."""

BARS_LEFT, BARS_RIGHT = 34.0, 304.0
BAR_ROW = 30


def page_body(document: dict[str, Any], live_map: Markup) -> Markup:
    """Return all that stands in the page's body but its scripts."""
    provenance = document["provenance"]
    return fill(
        "body",
        opening=opening(document),
        live_map=live_map,
        static_map=static_map(document),
        legend=legend(document),
        credits=credit_lines(document),
        heading=heading(document),
        journey=_journey(document),
        vehicles=_vehicles(document),
        fatigue=fatigue_chart(document),
        notes=_notes(document),
        about=about(
            document,
            join(_about_row(label, text) for label, text in provenance["rows"]),
            _items("remarks", provenance["remarks"]),
        ),
    )


def _journey(document: dict[str, Any]) -> Markup:
    scale = document["journey"]
    if (schedule := document["schedule"]) is not None:
        minutes = (schedule["end_s"] - schedule["begin_s"]) / 60
        return fill("journey-by-clock", minutes=f"{minutes:.3f}")
    return NOTHING if scale is None else fill("journey", km=f"{scale['length_m'] / 1000:.4f}")


def _vehicles(document: dict[str, Any]) -> Markup:
    """Return table, bars, way and events: at once for one small group, else group by group."""
    groups, every = document["groups"], range(len(document["vehicles"]))
    unit, note = document["cost_unit"]["label"], unit_note(document)
    totals = document["totals"]
    platoons = [group for group in groups if group["kind"] == "platoon"]
    if len(every) <= COMPACT_BEYOND and len(platoons) <= 1:
        return fill(
            "one-group",
            unit=unit,
            unit_note=note,
            table=_table(document, every, "All vehicles", totals["text"], "Costs"),
            day=schedule_chart(document, every),
            bars=join([_bars(document, every), waiting_bars(document, every)]),
            along=_way(document, every),
            events=_events(document, every),
        )
    return fill(
        "groups",
        unit=unit,
        unit_note=note,
        overview=join(
            fill(
                "overview-row", name=group["name"], facts=group["facts"],
                sign=_sign(group["saved"]), **group["text"],
            )
            for group in groups
        ),
        groups=join(_group(document, number, group) for number, group in enumerate(groups)),
        sign=_sign(totals["solo_cost"] - totals["joint_cost"]),
        **totals["text"],
    )  # fmt: skip


def _group(document: dict[str, Any], number: int, group: dict[str, Any]) -> Markup:
    members, key = group["vehicles"], f"-{number}"
    together = group["kind"] == "platoon"
    # A few groups are open from the start; of many, the first shows what the others hold.
    is_open = number == 0 or (len(document["vehicles"]) <= OPEN_UP_TO and together)
    return fill(
        "group",
        open=fill("group-open") if is_open else NOTHING,
        name=group["name"],
        facts=group["facts"],
        table=_table(document, members, "Together", group["text"], f"Costs, {group['name']}"),
        bars=join([_bars(document, members, key), waiting_bars(document, members, key)])
        if together
        else NOTHING,
        day=schedule_chart(document, members, key),
        along=_way(document, members, key) if together else NOTHING,
        events=_events(document, members, key),
    )


def _way(document: dict[str, Any], members: Sequence[int], key: str = "") -> Markup:
    """Return the way by distance; where there are times the schedule takes its place."""
    return NOTHING if document["schedule"] else along_chart(document, members, key)


def _items(fragment: str, texts: list[str]) -> Markup:
    if not texts:
        return NOTHING
    return fill(fragment, items=join(fill("item", text=text) for text in texts))


def _about_row(label: str, text: str) -> Markup:
    if label == "sha256" and re.fullmatch("[0-9a-fA-F]{64}", text):
        return fill("about-hash", label=label, text=text, short=text[:8], end=text[-4:])
    return fill("about-row", label=label, text=text)


def _sign(saved: float) -> str:
    return "gain" if saved > 0 else "loss" if saved < 0 else "even"


def _table(
    document: dict[str, Any], members: Sequence[int], total: str, text: Mapping[str, str],
    label: str,
) -> Markup:  # fmt: skip
    """Return the costs of some vehicles, one a row, and their sum."""
    rows = []
    for vehicle in (document["vehicles"][index] for index in members):
        facts: object = f"{vehicle['role_text']}, {vehicle['length_text']}"
        if vehicle["times"]:
            clock = vehicle["times"]["text"]
            facts = f"{clock['departure']}\u2060\u2013\u2060{clock['arrival']}, {facts}"
        if vehicle["name"]:
            facts = fill("vehicle-name", name=vehicle["name"], facts=facts)
        rows.append(
            fill(
                "table-row",
                badge=badge(vehicle),
                origin=vehicle["origin"]["name"],
                destination=vehicle["destination"]["name"],
                facts=facts,
                alone=vehicle["text"]["alone"],
                joint=vehicle["text"]["joint"],
                saved=vehicle["text"]["saved"],
                share=vehicle["text"]["share"],
                sign=_sign(vehicle["saved"]),
            )
        )
    return fill(
        "table", rows=join(rows), total=total, label=label,
        density=" compact" if len(rows) > COMPACT_BEYOND else "",
        sign=_sign(sum(document["vehicles"][index]["saved"] for index in members)), **text,
    )  # fmt: skip


# -- bars ------------------------------------------------------------------------------------------


def _bars(document: dict[str, Any], members: Sequence[int], key: str = "") -> Markup:
    """Return a bar per vehicle: what the platoon gains it, against what its detour costs."""
    vehicles = [document["vehicles"][index] for index in members]
    split = all(vehicle["detour"] is not None for vehicle in vehicles)
    gains = [v["platoon_gain"] if split else max(v["saved"], 0.0) for v in vehicles]
    losses = [v["detour"] if split else max(-v["saved"], 0.0) for v in vehicles]
    most_gain, most_loss = max(gains), max(losses)
    if most_gain + most_loss <= 0:
        return NOTHING
    # Text of a loss stands left of its bar, so room is kept for it if there is any loss.
    label_room = 52.0 if most_loss > 0 else 0.0
    room = BARS_RIGHT - BARS_LEFT - label_room
    per_pixel = (most_gain + most_loss) / room
    zero = BARS_LEFT + label_room + most_loss / per_pixel
    rows = [
        _bar_row(vehicle, gain, loss, split, zero, per_pixel, 22 + BAR_ROW * place)
        for place, (vehicle, gain, loss) in enumerate(zip(vehicles, gains, losses, strict=True))
    ]
    heads = [("372", "end", "net")]
    if split:
        heads.append((f"{zero + 6:.1f}", "start", "gained in platoon"))
        if most_loss > 0:
            heads.append((f"{zero - 6:.1f}", "end", "longer way"))
    else:
        heads.append((f"{zero + 6:.1f}", "start", "saved"))
    unit = document["cost_unit"]["label"]
    title = f"{'Gain in platoon, less the longer way' if split else 'Saving'}, {unit}"
    return fill(
        "bars",
        key=key,
        title=title,
        height=22 + BAR_ROW * len(vehicles) - 4,
        zero=f"{zero:.1f}",
        heads=join(fill("bars-head", x=x, anchor=anchor, text=text) for x, anchor, text in heads),
        rows=join(rows),
    )


def _bar_row(
    vehicle: dict[str, Any], gain: float, loss: float, split: bool, zero: float,
    per_pixel: float, y: float,
) -> Markup:  # fmt: skip
    shapes: list[Markup] = []
    if loss > 0:
        left = zero - loss / per_pixel
        shapes.append(
            fill(
                "bar-loss",
                x=f"{left:.1f}",
                width=f"{zero - left:.1f}",
                text_x=f"{left - 5:.1f}",
                text=vehicle["text"]["detour"] if split else "",
            )
        )
    if gain > 0:
        shapes.append(
            fill(
                "bar-gain",
                x=f"{zero:.1f}",
                width=f"{gain / per_pixel:.1f}",
                text_x=f"{zero + 6:.1f}",
                colour=vehicle["colour"],
                text=vehicle["text"]["gain"] if split else "",
            )
        )
    if gain > 0 and split:
        shapes.append(fill("bar-net", x=f"{zero + (gain - loss) / per_pixel:.1f}"))
    return fill(
        "bars-row", y=f"{y:g}", colour=vehicle["colour"], letter=vehicle["letter"],
        size=letter_size(vehicle["letter"]), shapes=join(shapes), net=vehicle["text"]["saved"],
    )  # fmt: skip


# -- lists -----------------------------------------------------------------------------------------


def _events(document: dict[str, Any], members: Sequence[int], key: str = "") -> Markup:
    items = [
        fill(
            "event",
            index=index,
            number=index + 1,
            kind=event["kind"].capitalize(),
            icon=event["kind"],
            name=event["name"],
            text=event["text"],
            detail=event["detail"],
        )
        for index, event in enumerate(document["events"])
        if set(event["vehicles"]) & set(members)
    ]
    return fill("events", key=key, items=join(items)) if items else NOTHING


def _notes(document: dict[str, Any]) -> Markup:
    # Those of one reason share a note.
    alike: dict[tuple[bool, str], list[dict[str, Any]]] = {}
    for vehicle in document["vehicles"]:
        alone = vehicle["role"] == "alone"
        if alone or vehicle["reason"]:
            alike.setdefault((alone, vehicle["reason"]), []).append(vehicle)
    items: list[Markup] = late_note(document)
    for (alone, reason), vehicles in alike.items():
        lead = ", ".join(vehicle["letter"] for vehicle in vehicles)
        if alone:
            lead += " stays alone" if len(vehicles) == 1 else " stay alone"
        lead += ":" if reason else "."
        face = badge(vehicles[0]) if len(vehicles) == 1 else NOTHING
        items.append(fill("note-vehicle", badge=face, lead=lead, text=reason))
    guessed = [vehicle for vehicle in document["vehicles"] if vehicle["inferred_text"]]
    if guessed:
        listed = ", ".join(f"{v['letter']} {v['inferred_text']}" for v in guessed)
        text = (
            "Road that the map does not hold but the loader inferred, drawn dashed, "
            f"is part of these routes: {listed}."
        )
        items.append(fill("note-inferred", text=text))
    return fill("notes", items=join(items)) if items else NOTHING
