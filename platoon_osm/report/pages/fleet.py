"""The page of a whole fleet: what is saved and proved, flows, charts, platoons, who is left out."""

from __future__ import annotations

import os
from collections.abc import Sequence

from ...atomic_file import whole_file
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES
from ...plans.clock import Clock
from ...plans.plan import Plan
from ...shown_text import fitted
from ..charts.fleet_charts import corridor_chart, fine_percent, gap_chart, gap_percent, size_chart
from ..document.checks import check_path
from ..document.corridor import Ends
from ..document.fleet import LISTED, FleetDocument, Listed, fleet_document_of
from ..language.plan_sentences import in_language
from ..language.speech import clock_time, day_and_date, number, say, speaking, zone_text
from ..markup.fragments import NOTHING, Piece, Tree, page_data
from ..markup.quantities import clock_span, gain_or_loss, percent
from ..markup.still_page import PAGE_STYLES, still_page
from .fleet_map import fleet_map, share_keys, width_keys
from .flows import histogram_piece
from .page_pieces import items

__all__ = ["write_fleet_html"]

TOLD = 12
"""Vehicles of a platoon that its row names; fleet.js has the same number."""

MOST_UNSERVED = 300

ENDS = {
    "proved": "fleet.ended-proved",
    "refused": "fleet.ended-refused",
    "time": "fleet.ended-time",
    "rounds": "fleet.ended-rounds",
    "interrupted": "fleet.ended-interrupted",
}


def write_fleet_html(
    plan: Plan,
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    language: str | None = None,
    clock: int | None = None,
    corridor: Ends | None = None,
) -> None:
    """Write the page of a fleet's plan; whole or not at all.

    It asks the network for nothing. Without a script it lists the platoons that save most; the
    script sorts and filters all of them.

    Parameters
    ----------
    plan : Plan
        What `plan_fleet` returned.
    net : RoadNetwork
        The network it was made on.
    path : path-like
        Of the file; missing folders are made.
    title : str or None
        Heads the page; by default the number of trucks.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.
    corridor : tuple of int or str, (2,), or None
        From where to where the road goes whose diagram is drawn: nodes, or names of places; by
        default the busiest road.

    Raises
    ------
    ScenarioError
        A plan of no fleet or of another network, a corridor that nobody drives, a language without
        texts, or a file that cannot be written.
    """
    place = check_path(path)
    with speaking(language, clock):
        page = _page(fleet_document_of(plan, net, title, corridor))
    with whole_file(place, suffixes=PAGES) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def _page(found: FleetDocument) -> str:
    plan, record = found.plan, found.record
    clock = plan.timetable.clock if plan.timetable else None
    title = fitted(found.title) if found.title else say("fleet.title", n=len(plan.trips))
    day = [day_and_date(clock.start), zone_text(clock)] if clock else []
    provenance = found.provenance
    body = Piece(
        "fleet",
        {
            "title": title,
            "subtitle": " \u00b7 ".join([fitted(plan.network.name), *day]),
            "figures": _figures(found),
            "proof": _proved(found),
            "proved": "good" if record.gap <= 0 else "",
            "ended": say(
                ENDS[record.ended], n=record.rounds, time=_seconds(record.seconds)
            ),
            "map": fleet_map(found),
            "widths": width_keys(found),
            "shares": share_keys(found),
            "map_credits": " \u00b7 ".join(provenance.credits),
            "gap": _gap(found),
            "sizes": size_chart(found.sizes),
            "histogram": histogram_piece(found.histogram),
            "corridor": _corridor(found, clock),
            "platoons": _platoons(found, clock),
            "conditions": items(fitted(in_language(one)) for one in record.conditions),
            "unserved": _unserved(found),
            "rows": tuple(
                Piece("about-row", {"label": row.label, "text": row.text})
                for row in provenance.rows
            ),
            "remarks": Piece("remarks", {"items": items(provenance.remarks)})
            if provenance.remarks
            else NOTHING,
            "credits": items(provenance.credits),
            "data": _data(found, clock),
        },
    )  # fmt: skip
    scripts = ("elements.js", "fleet.js") if found.platoons else ()
    styles = (*PAGE_STYLES, "comparison.css", "flows.css", "fleet.css")
    return still_page(title, body, styles, scripts)


def _seconds(seconds: float) -> str:
    return clock_span(seconds) if seconds >= 90 else f"{number(seconds, 1)} s"


def _share(found: FleetDocument, cost: float) -> str:
    alone = found.record.alone_cost
    return fine_percent(cost / alone if alone else 0.0)


def _figures(found: FleetDocument) -> Tree:
    record, unit = found.record, found.unit
    total = sum(metres for _, metres in found.sizes) or 1.0
    together = sum(metres for size, metres in found.sizes if size > 1)
    rows = [
        (number(len(found.plan.trips)), say("fleet.trucks"), ""),
        (_share(found, record.saving), say("fleet.saved", cost=unit.full(record.saving)), "good"),
        (_share(found, record.most), say("fleet.at-most", cost=unit.full(record.most)), ""),
        (gap_percent(record.gap), say("fleet.gap"), ""),
        (number(len(found.platoons)), say("fleet.platoons"), ""),
        (percent(together / total), say("fleet.in-platoons", km=number(together / 1000)), ""),
    ]
    if record.unserved:
        rows.append((number(len(record.unserved)), say("fleet.unserved-figure"), ""))
    return tuple(
        Piece("fleet-figure", {"figure": figure, "label": label, "kind": kind})
        for figure, label, kind in rows
    )


def _proved(found: FleetDocument) -> str:
    record, unit = found.record, found.unit
    if record.bound <= record.saving:
        return say("fleet.proof-whole", saved=unit.full(record.saving))
    text = say(
        "fleet.proof", bound=unit.full(record.most), saved=unit.full(record.saving),
        gap=gap_percent(record.gap),
    )  # fmt: skip
    if record.most < record.bound:
        text += " " + say("fleet.proof-exact", bound=unit.full(record.bound))
    return text


def _gap(found: FleetDocument) -> Tree:
    record = found.record
    chart = gap_chart(record)
    if chart == NOTHING:
        return NOTHING
    return Piece(
        "fleet-gap-section",
        {
            "chart": chart,
            "bound": say("fleet.bound-line", share=_share(found, record.most)),
            "saved": say("fleet.saved-line", share=_share(found, record.saving)),
        },
    )


def _corridor(found: FleetDocument, clock: Clock | None) -> Tree:
    corridor = found.corridor
    if corridor is None or clock is None:
        return NOTHING
    chart = corridor_chart(corridor, clock)
    if chart == NOTHING:
        return NOTHING
    begin, end = corridor.places[0][1], corridor.places[-1][1]
    return Piece(
        "fleet-corridor-section",
        {
            "heading": say("fleet.corridor", begin=begin, end=end),
            "note": say(
                "fleet.corridor-note", n=corridor.vehicles, km=number(corridor.length_m / 1000)
            ),
            "chart": chart,
        },
    )


def _time(clock: Clock | None, seconds: float | None) -> str:
    return "" if clock is None or seconds is None else clock_time(clock, seconds)


def _platoons(found: FleetDocument, clock: Clock | None) -> Tree:
    if not found.platoons:
        return Piece("fleet-note", {"text": say("fleet.none")})
    every = len(found.platoons)
    return Piece(
        "fleet-platoons",
        {
            "heading": say("fleet.list", n=every),
            "saved": say("fleet.saved-in", unit=found.list_unit.label),
            "rows": tuple(
                _row(found, clock, one, k) for k, one in enumerate(found.platoons[:LISTED])
            ),
            "note": Piece(
                "fleet-first-of", {"text": say("fleet.first-of", n=LISTED, all=number(every))}
            )
            if every > LISTED
            else NOTHING,
        },
    )


def _row(found: FleetDocument, clock: Clock | None, one: Listed, rank: int) -> Piece:
    convoy = one.convoy
    saving = convoy.saving or 0.0
    return Piece(
        "fleet-row",
        {
            "row": rank,
            "forms": one.forms,
            "begins": _time(clock, convoy.begins_s),
            "parts": one.parts,
            "ends": _time(clock, convoy.ends_s),
            "count": number(len(convoy.vehicles)),
            "names": _names(found.plan, convoy.vehicles),
            "km": number(convoy.vehicle_m / 1000),
            "label": say("fleet.saved-in", unit=found.list_unit.label),
            "saved": _saved(found, convoy.saving),
            "sign": gain_or_loss(saving),
        },
    )


def _names(plan: Plan, vehicles: Sequence[int]) -> str:
    told = ", ".join(fitted(plan.trips[one].vehicle) for one in vehicles[:TOLD])
    left = len(vehicles) - TOLD
    return f"{told} +{number(left)}" if left > 0 else told


def _saved(found: FleetDocument, saving: float | None) -> str:
    return "" if saving is None else found.list_unit.bare(saving)


def _data(found: FleetDocument, clock: Clock | None) -> Tree:
    """Return all platoons for the script, the one that saves most first."""
    if not found.platoons:
        return NOTHING
    rows = [
        [
            one.forms, one.parts, list(one.convoy.vehicles),
            _time(clock, one.convoy.begins_s), _time(clock, one.convoy.ends_s),
            round(one.convoy.begins_s or 0.0), round(one.convoy.ends_s or 0.0),
            round(one.convoy.vehicle_m), float(f"{one.convoy.saving or 0.0:.6g}"),
            number(one.convoy.vehicle_m / 1000), _saved(found, one.convoy.saving),
        ]
        for one in found.platoons
    ]  # fmt: skip
    names = [fitted(trip.vehicle) for trip in found.plan.trips]
    return Piece("fleet-data", {"data": page_data({"names": names, "rows": rows})})


def _unserved(found: FleetDocument) -> Tree:
    unserved = found.record.unserved
    if not unserved:
        return NOTHING
    left = len(unserved) - MOST_UNSERVED
    return Piece(
        "fleet-unserved",
        {
            "heading": say("fleet.unserved", n=len(unserved)),
            "rows": tuple(
                Piece(
                    "fleet-unserved-row",
                    {"vehicle": fitted(one.vehicle), "reason": fitted(in_language(one.reason))},
                )
                for one in unserved[:MOST_UNSERVED]
            ),
            "note": Piece("fleet-note", {"text": say("fleet.unserved-more", n=left)})
            if left > 0
            else NOTHING,
        },
    )
