"""The document of several plans of one network, in which a vehicle always looks the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...shown_text import fitted, shown
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..language.speech import speaking
from .as_json import as_json
from .checks import check_plan, check_title, check_titles
from .document import document_of
from .model import Document

__all__ = ["SIDE_BY_SIDE", "Comparison", "comparison_document", "comparison_of"]

COMPARISON_VERSION = 1

SIDE_BY_SIDE = "Plans side by side"
"""Heads the page unless asked otherwise."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """All that the page of several plans shows.

    Attributes
    ----------
    format : str
        "platoon_osm comparison".
    version : int
        Of the format.
    title, subtitle : str
        Head the page.
    remarks : tuple of str
        What a reader should know before comparing.
    plans : tuple of Document
        One for each plan.
    """

    format: str
    version: int
    title: str
    subtitle: str
    remarks: tuple[str, ...]
    plans: tuple[Document, ...]


def comparison_document(
    plans: Sequence[Plan],
    net: RoadNetwork,
    *,
    titles: Sequence[str] | None = None,
    title: str = SIDE_BY_SIDE,
    language: str | None = None,
    clock: int | None = None,
) -> dict[str, Any]:
    """Return what the page of several plans shows as plain JSON types.

    Parameters
    ----------
    plans : sequence of Plan
        One or more, of the same network.
    net : RoadNetwork
        The network they were made on.
    titles : sequence of str, or None
        Of the plans; by default their cases.
    title : str
        Heads the page.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Returns
    -------
    dict
        With a report document for each plan, as docs/report.md describes it.

    Raises
    ------
    ScenarioError
        No plans, a plan of another network, or titles of another number.
    """
    with speaking(language, clock):
        return as_json(comparison_of(plans, net, titles=titles, title=title))  # type: ignore[no-any-return]


def comparison_of(
    plans: Sequence[Plan],
    net: RoadNetwork,
    *,
    titles: Sequence[str] | None = None,
    title: str = SIDE_BY_SIDE,
) -> Comparison:
    """Return what the page of several plans shows as records.

    Parameters
    ----------
    plans : sequence of Plan
        One or more, of the same network.
    net : RoadNetwork
        The network they were made on.
    titles : sequence of str, or None
        Of the plans; by default their cases.
    title : str
        Heads the page.

    Returns
    -------
    Comparison
        All that the page shows.

    Raises
    ------
    ScenarioError
        As in `comparison_document`.
    """
    plans = _checked(plans, net)
    check_titles(titles, plans)
    check_title(title)
    heads = titles if titles is not None else [f"Case {plan.case}" for plan in plans]
    styles = _common_styles(plans)
    documents = tuple(
        replace(
            document_of(plan, net, title=head, styles=styles),
            title=fitted(head) if shown(head) else "Plan",
        )
        for plan, head in zip(plans, heads, strict=True)
    )
    return Comparison(
        format="platoon_osm comparison",
        version=COMPARISON_VERSION,
        title=fitted(title) if title and shown(title) else SIDE_BY_SIDE,
        subtitle=f"{len(plans)} plans on {fitted(plans[0].network.name)}",
        remarks=tuple(_remarks(plans, documents)),
        plans=documents,
    )


def _checked(plans: object, net: RoadNetwork) -> Sequence[Plan]:
    if not isinstance(plans, list | tuple):
        raise ScenarioError("compare: the plans are no list; give two or more of one network")
    if not plans:
        raise ScenarioError("compare: no plans; give two or more of one network")
    for plan in plans:
        check_plan(plan, net)
    return plans


def _remarks(plans: Sequence[Plan], documents: Sequence[Document]) -> list[str]:
    remarks: list[str] = []
    units = {document.cost_unit.label for document in documents}
    if len(units) > 1:
        remarks.append(
            f"Costs of these plans are in other units ({', '.join(sorted(units))}): compare shares."
        )
    if len({tuple(sorted((k, repr(v)) for k, v in plan.params.items())) for plan in plans}) > 1:
        remarks.append(
            "These plans were made with other cost parameters: compare shares, not costs."
        )
    return remarks


def _common_styles(plans: Sequence[Plan]) -> dict[str, VehicleStyle]:
    names = list(dict.fromkeys(vehicle.vehicle for plan in plans for vehicle in plan.vehicles))
    return dict(zip(names, vehicle_styles(names), strict=True))
