"""The page's static HTML from a report document: figures, table, bars, lists, legend."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from .charts import along_chart, fatigue_chart
from .fragments import Markup, fill, join
from .map_view import band_lines
from .static_map import static_map

__all__ = ["page_body"]

NOTHING = Markup("")

OPEN_UP_TO = 12
"""Vehicles in a plan all of whose groups are open from the start."""

COMPACT_BEYOND = 8
"""More vehicles than this get the narrow table, which scrolls."""

BARS_LEFT, BARS_RIGHT = 34.0, 304.0
BAR_ROW = 30


def page_body(document: dict[str, Any], live_map: Markup) -> Markup:
    """Return all that stands in the page's body but its scripts."""
    about = document["provenance"]
    return fill(
        "body",
        icons=fill("icons"),
        live_map=live_map,
        static_map=static_map(document),
        legend=_legend(document),
        credits=join(fill("credit", text=text) for text in about["credits"]),
        title=document["title"],
        subtitle=document["subtitle"],
        figures=join(fill("figure", **figure) for figure in document["totals"]["figures"]),
        journey=_journey(document),
        vehicles=_vehicles(document),
        fatigue=fatigue_chart(document),
        notes=_notes(document),
        proof=fill("proof", text=about["proof"]) if about["proof"] else NOTHING,
        rows=join(_about_row(label, text) for label, text in about["rows"]),
        remarks=_items("remarks", about["remarks"]),
        credit_items=join(fill("item", text=text) for text in about["credits"]),
    )


def _journey(document: dict[str, Any]) -> Markup:
    scale = document["journey"]
    return NOTHING if scale is None else fill("journey", km=f"{scale['length_m'] / 1000:.4f}")


def _vehicles(document: dict[str, Any]) -> Markup:
    """Return table, bars, way and events: at once for one small group, else group by group."""
    groups, every = document["groups"], range(len(document["vehicles"]))
    unit, note = document["cost_unit"]["label"], _unit_note(document)
    totals = document["totals"]
    platoons = [group for group in groups if group["kind"] == "platoon"]
    if len(every) <= COMPACT_BEYOND and len(platoons) <= 1:
        return fill(
            "one-group",
            unit=unit,
            unit_note=note,
            table=_table(document, every, "All vehicles", totals["text"], "Costs"),
            bars=_bars(document, every),
            along=along_chart(document, every),
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
        bars=_bars(document, members, key) if together else NOTHING,
        along=along_chart(document, members, key) if together else NOTHING,
        events=_events(document, members, key),
    )


def _items(fragment: str, texts: list[str]) -> Markup:
    if not texts:
        return NOTHING
    return fill(fragment, items=join(fill("item", text=text) for text in texts))


def _unit_note(document: dict[str, Any]) -> Markup:
    note = document["cost_unit"]["note"]
    return fill("unit-note", note=note) if note else NOTHING


def _about_row(label: str, text: str) -> Markup:
    if label == "sha256" and re.fullmatch("[0-9a-fA-F]{64}", text):
        return fill("about-hash", label=label, text=text, short=text[:8], end=text[-4:])
    return fill("about-row", label=label, text=text)


def badge(vehicle: dict[str, Any]) -> Markup:
    """Return a vehicle's letter in a disc of its colour."""
    return fill(
        "badge", colour=vehicle["colour"], letter=vehicle["letter"], size=_letter_size(vehicle)
    )


def _letter_size(vehicle: dict[str, Any]) -> str:
    return "11" if len(vehicle["letter"]) == 1 else "9"


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
        size=_letter_size(vehicle), shapes=join(shapes), net=vehicle["text"]["saved"],
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
    items: list[Markup] = []
    for vehicle in document["vehicles"]:
        letter, reason = vehicle["letter"], vehicle["reason"]
        if vehicle["role"] == "alone":
            lead = f"{letter} stays alone" + (":" if reason else ".")
        elif reason:
            lead = f"{letter}:"
        else:
            continue
        items.append(fill("note-vehicle", badge=badge(vehicle), lead=lead, text=reason))
    guessed = [vehicle for vehicle in document["vehicles"] if vehicle["inferred_text"]]
    if guessed:
        listed = ", ".join(f"{v['letter']} {v['inferred_text']}" for v in guessed)
        text = (
            "Road that the map does not hold but the loader inferred, drawn dashed, "
            f"is part of these routes: {listed}."
        )
        items.append(fill("note-inferred", text=text))
    return fill("notes", items=join(items)) if items else NOTHING


# -- legend ----------------------------------------------------------------------------------------


def _legend(document: dict[str, Any]) -> Markup:
    return fill("legend", rows=join(_legend_rows(document)))


def _legend_rows(document: dict[str, Any]) -> Iterator[Markup]:
    def row(layer: str, swatch: Markup, text: object) -> Markup:
        return fill("legend-row", layer=layer, swatch=swatch, text=text)

    vehicles = document["vehicles"]
    if document["platoons"]:
        widest = max((section["vehicles"] for section in document["platoons"]), key=len)
        yield row("platoon", _platoon_swatch([vehicles[i] for i in widest]), "Platoon")
    rows: list[Markup] = []
    for index, vehicle in enumerate(vehicles):
        swatch = fill(
            "swatch-line", colour=vehicle["colour"], dash=vehicle["dash"] or "none",
            cap=vehicle["cap"],
        )  # fmt: skip
        rest = {"master": ", master route", "alone": ", alone"}.get(vehicle["role"], "")
        rows.append(row(f"vehicle-{index}", swatch, f"Vehicle {vehicle['letter']}{rest}"))
    if len(rows) > COMPACT_BEYOND:
        swatches = (
            fill("swatch-thin", y=4 + 5 * place, colour=vehicle["colour"])
            for place, vehicle in enumerate(vehicles[:3])
        )
        yield fill("legend-crowd", swatches=join(swatches), rows=join(rows))
    else:
        yield from rows
    yield row("ends", fill("swatch-ends"), "Starts and destinations")
    kinds = {event["kind"] for event in document["events"]}
    if "merge" in kinds:
        yield row("merge", fill("swatch-merge"), "Merge points")
    if "separation" in kinds:
        yield row("separation", fill("swatch-separation"), "Separation points")
    yield row("network", fill("swatch-network"), "Motorway network")
    if document["basemap"]["inferred"]:
        yield row("inferred", fill("swatch-inferred"), "Inferred road")
    if document["junctions"]:
        yield row("junctions", fill("swatch-junctions"), "Junctions (zoom in)")
    if document["towns"] or document["junctions"]:
        yield row("names", fill("swatch-names"), "Place names")


def _platoon_swatch(vehicles: list[dict[str, Any]]) -> Markup:
    shown_lines = vehicles[:3]
    step = min(4.6, band_lines(len(shown_lines))[0])
    lines = [
        fill(
            "swatch-platoon-line",
            y=f"{9 + (place - (len(shown_lines) - 1) / 2) * step:.1f}",
            colour=vehicle["colour"],
            width="2.6",
        )
        for place, vehicle in enumerate(shown_lines)
    ]
    return fill("swatch-platoon", lines=join(lines))
