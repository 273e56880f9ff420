"""The legend, which is the layer control: an entry for each layer, vehicle and group."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD
from ..maps.lanes import band_lines
from ..markup.fragments import NOTHING, Markup, fill, join

__all__ = ["legend"]


def legend(document: Document) -> Markup:
    """Return the legend of a document.

    Vehicles stand one under another; a crowd is listed by group, as several platoons are.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Markup
        An entry for each layer, vehicle and group.
    """
    return fill("legend", rows=join(_rows(document)))


def _row(layer: str, swatch: Markup, text: object) -> Markup:
    return fill("legend-row", layer=layer, swatch=swatch, text=text)


def _rows(document: Document) -> Iterator[Markup]:
    vehicles = document.vehicles
    several = sum(group.is_platoon for group in document.groups) > 1
    if document.platoons:
        widest = max((section.vehicles for section in document.platoons), key=len)
        swatch = _platoon_swatch([vehicles[i] for i in widest])
        yield _row("platoon", swatch, "Platoons" if several else "Platoon")
    if len(vehicles) > CROWD or several:
        if len(vehicles) > CROWD:
            yield fill("legend-all", swatch=_lines_swatch(vehicles))
        yield from (_group(document, number) for number in range(len(document.groups)))
    else:
        yield from (_vehicle(vehicles, index) for index in range(len(vehicles)))
    yield _row("ends", fill("swatch-ends"), "Starts and destinations")
    kinds = {event.kind for event in document.events}
    if "merge" in kinds:
        yield _row("merge", fill("swatch-merge"), "Merge points")
    if "separation" in kinds:
        yield _row("separation", fill("swatch-separation"), "Separation points")
    yield _row("network", fill("swatch-network"), "Motorway network")
    if document.basemap.inferred:
        yield _row("inferred", fill("swatch-inferred"), "Inferred road")
    if document.junctions:
        yield _row("junctions", fill("swatch-junctions"), "Junctions (zoom in)")
    if document.towns or document.junctions:
        yield _row("names", fill("swatch-names"), "Place names")


def _vehicle(vehicles: Sequence[Vehicle], index: int) -> Markup:
    vehicle = vehicles[index]
    swatch = fill(
        "swatch-line",
        colour=vehicle.colour,
        dash=vehicle.stroke,
        cap=vehicle.cap,
    )
    rest = {"master": ", master route", "alone": ", alone"}.get(vehicle.role, "")
    return _row(f"vehicle-{index}", swatch, f"Vehicle {vehicle.letter}{rest}")


def _group(document: Document, number: int) -> Markup:
    """Return a group's entry, which stands for its vehicles, and theirs to open below it."""
    group, every = document.groups[number], document.vehicles
    members = [every[index] for index in group.vehicles]
    together = group.is_platoon
    few = together and len(every) <= CROWD
    return fill(
        "legend-group",
        number=number,
        swatch=_platoon_swatch(members) if together else _lines_swatch(members),
        name=group.name,
        count=len(members),
        noun="vehicle" if len(members) == 1 else "vehicles",
        open=fill("group-open") if few else NOTHING,
        rows=join(_vehicle(every, index) for index in group.vehicles),
    )


def _lines_swatch(vehicles: Sequence[Vehicle]) -> Markup:
    return join(
        fill("swatch-thin", y=4 + 5 * place, colour=vehicle.colour)
        for place, vehicle in enumerate(vehicles[:3])
    )


def _platoon_swatch(vehicles: Sequence[Vehicle]) -> Markup:
    shown_lines = vehicles[:3]
    step = min(4.6, band_lines(len(shown_lines))[0])
    lines = [
        fill(
            "swatch-platoon-line",
            y=f"{9 + (place - (len(shown_lines) - 1) / 2) * step:.1f}",
            colour=vehicle.colour,
            width="2.6",
        )
        for place, vehicle in enumerate(shown_lines)
    ]
    return fill("swatch-platoon", lines=join(lines))
