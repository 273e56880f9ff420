"""The legend, which is the layer control: an entry for each layer, vehicle and group."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD
from ..language.speech import say
from ..maps.lanes import band_lines
from ..maps.pause_icons import pause_kinds
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["legend"]

PAUSES = {
    "rest": "legend.rests",
    "break": "legend.breaks",
    "ban": "legend.bans",
    "change": "legend.changes",
    "wait": "legend.waits",
}
VEHICLES = {"master": "legend.master", "alone": "legend.stays-alone"}


def legend(document: Document) -> Piece:
    """Return the legend of a document.

    Vehicles stand one under another; a crowd is listed by group, as several platoons are.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Piece
        An entry for each layer, vehicle and group.
    """
    return Piece("legend", {"rows": tuple(_rows(document))})


def _row(layer: str, swatch: Tree, text: object) -> Piece:
    return Piece("legend-row", {"layer": layer, "swatch": swatch, "text": text})


def _rows(document: Document) -> Iterator[Tree]:
    vehicles, traffic = document.vehicles, document.traffic
    several = sum(group.is_platoon for group in document.groups) > 1
    if document.platoons:
        widest = max((section.vehicles for section in document.platoons), key=len)
        swatch: Tree = _platoon_swatch([vehicles[i] for i in widest])
        text = say("legend.platoons" if several else "legend.platoon")
        if traffic is not None and traffic.bundled:
            swatch, text = Piece("swatch-bundle"), say("legend.in-platoons")
        yield _row("platoon", swatch, text)
    if traffic is not None:
        yield _row("lone", Piece("swatch-lone"), say("legend.alone"))
    elif several:
        yield from (_group(document, number) for number in range(len(document.groups)))
    else:
        yield from (_vehicle(vehicles, index) for index in range(len(vehicles)))
    if any(line.access for line in document.solos):
        yield Piece(
            "legend-plain", {"swatch": Piece("swatch-access"), "text": say("legend.access")}
        )
    yield _row("ends", Piece("swatch-ends"), say("legend.ends"))
    if any(vehicle.is_late for vehicle in vehicles):
        yield Piece("legend-plain", {"swatch": Piece("swatch-late"), "text": say("legend.late")})
    kinds = {event.kind for event in document.events}
    if "merge" in kinds:
        yield _row("merge", Piece("swatch-merge"), say("legend.merges"))
    if "separation" in kinds:
        yield _row("separation", Piece("swatch-separation"), say("legend.separations"))
    for kind in pause_kinds(document):
        yield _row(kind, Piece("swatch-pause", {"kind": kind}), say(PAUSES[kind]))
    if not all(event.has_parking for event in document.events):
        text = say("legend.no-parking")
        yield Piece("legend-plain", {"swatch": Piece("swatch-unknown"), "text": text})
    yield _row("network", Piece("swatch-network"), say("legend.network"))
    if document.basemap.inferred:
        yield _row("inferred", Piece("swatch-inferred"), say("legend.inferred"))
    if document.junctions:
        yield _row("junctions", Piece("swatch-junctions"), say("legend.junctions"))
    if document.stops:
        yield _row("stops", Piece("swatch-stops"), say("legend.stops"))
    if document.towns or document.junctions:
        yield _row("names", Piece("swatch-names"), say("legend.names"))
    if traffic is not None:
        yield _crowd(document)


def _vehicle(vehicles: Sequence[Vehicle], index: int) -> Tree:
    vehicle = vehicles[index]
    swatch = Piece(
        "swatch-line", {"colour": vehicle.colour, "dash": vehicle.stroke, "cap": vehicle.cap}
    )
    text = say(VEHICLES.get(vehicle.role, "legend.vehicle"), who=vehicle.letter)
    return _row(f"vehicle-{index}", swatch, text)


def _crowd(document: Document) -> Piece:
    """Return the vehicles of a crowd, by group, closed until one asks for them."""
    groups = (_group(document, number) for number in range(len(document.groups)))
    every = Piece("legend-all", {"swatch": _lines_swatch(document.vehicles)})
    summary = say("legend.by-group", n=len(document.vehicles))
    return Piece("legend-crowd", {"summary": summary, "rows": (every, *groups)})


def _group(document: Document, number: int) -> Piece:
    """Return a group's entry, which stands for its vehicles, and theirs to open below it."""
    group, every = document.groups[number], document.vehicles
    members = [every[index] for index in group.vehicles]
    together = group.is_platoon
    few = together and len(every) <= CROWD
    return Piece(
        "legend-group",
        {
            "number": number,
            "swatch": _platoon_swatch(members) if together else _lines_swatch(members),
            "name": group.name,
            "count": len(members),
            "of_group": say("legend.of-group", n=len(members), group=group.name),
            "open": Piece("group-open") if few else NOTHING,
            "rows": tuple(_vehicle(every, index) for index in group.vehicles),
        },
    )


def _lines_swatch(vehicles: Sequence[Vehicle]) -> Tree:
    return tuple(
        Piece("swatch-thin", {"y": 4 + 5 * place, "colour": vehicle.colour})
        for place, vehicle in enumerate(vehicles[:3])
    )


def _platoon_swatch(vehicles: Sequence[Vehicle]) -> Piece:
    shown_lines = vehicles[:3]
    step = min(4.6, band_lines(len(shown_lines))[0])
    lines = [
        Piece(
            "swatch-platoon-line",
            {
                "y": f"{9 + (place - (len(shown_lines) - 1) / 2) * step:.1f}",
                "colour": vehicle.colour,
                "width": "2.6",
            },
        )
        for place, vehicle in enumerate(shown_lines)
    ]
    return Piece("swatch-platoon", {"lines": tuple(lines)})
