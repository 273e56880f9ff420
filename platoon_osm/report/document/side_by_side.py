"""The document of several plans of one network; of the same trips, vehicles look alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from ...errors import ScenarioError, brief
from ...kinds import is_whole
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...shown_text import fitted, shortened, shown
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..language.speech import say, speaking
from .alike_trips import AlikePlans, alike, alike_plans
from .as_json import as_json
from .checks import check_plan, check_title, check_titles
from .document import document_of
from .model import Document
from .wording import joined

__all__ = ["Comparison", "comparison_document", "comparison_of"]

COMPARISON_VERSION = 2

MOST_HEADS, LONGEST_HEAD = 6, 60
"""Titles of plans that head the page, and letters of each."""


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
    sets : tuple of AlikePlans
        Plans of the same trips, which alone can be compared.
    plans : tuple of Document
        One for each plan.
    """

    format: str
    version: int
    title: str
    subtitle: str
    remarks: tuple[str, ...]
    sets: tuple[AlikePlans, ...]
    plans: tuple[Document, ...]


def comparison_document(
    plans: Sequence[Plan],
    net: RoadNetwork,
    *,
    titles: Sequence[str] | None = None,
    title: str | None = None,
    baseline: int | str = 0,
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
    title : str or None
        Heads the page; by default the titles of all plans.
    baseline : int or str
        The position or the title of the plan that those of the same trips are set against.
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
        No plans, a plan of another network, titles of another number, or no such baseline.
    """
    with speaking(language, clock):
        return as_json(  # type: ignore[no-any-return]  # a record becomes a dict
            comparison_of(plans, net, titles=titles, title=title, baseline=baseline)
        )


def comparison_of(
    plans: Sequence[Plan],
    net: RoadNetwork,
    *,
    titles: Sequence[str] | None = None,
    title: str | None = None,
    baseline: int | str = 0,
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
    title : str or None
        Heads the page; by default the titles of all plans.
    baseline : int or str
        The position or the title of the plan that those of the same trips are set against.

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
    heads = [
        fitted(head) if shown(head) else say("compare.plan")
        for head in (
            titles
            if titles is not None
            else [say("compare.case", case=plan.case) for plan in plans]
        )
    ]
    base = _position(baseline, heads)
    documents: list[Document | None] = [None] * len(plans)
    sets = alike(plans)
    for places in sets:
        alike_ones = [plans[place] for place in places]
        styles = _common_styles(alike_ones)
        # As many decimals in all of them, so that their sums stand below one another.
        largest = max(plan.solo_cost for plan in alike_ones)
        for place in places:
            document = document_of(
                plans[place], net, title=heads[place], styles=styles, largest=largest
            )
            documents[place] = replace(document, title=heads[place])
    made = tuple(document for document in documents if document is not None)
    network = fitted(plans[0].network.name)
    subtitle = say("compare.subtitle", n=len(plans), network=network)
    if len(sets) > 1:
        subtitle = say("compare.subtitle-sets", n=len(plans), sets=len(sets), network=network)
    return Comparison(
        format="platoon_osm comparison",
        version=COMPARISON_VERSION,
        title=fitted(title) if title and shown(title) else fitted(_title_of(heads)),
        subtitle=subtitle,
        remarks=(say("compare.apart"),) if len(sets) > 1 else (),
        sets=tuple(alike_plans(places, base, plans, made) for places in sets),
        plans=made,
    )


def _title_of(heads: Sequence[str]) -> str:
    """Return the titles of all plans in a row."""
    return joined([shortened(head, LONGEST_HEAD) for head in heads], MOST_HEADS)


def _position(baseline: object, heads: Sequence[str]) -> int:
    """Return the position of the plan that others are set against, from that or its title."""
    if isinstance(baseline, str):
        if fitted(baseline) in heads:
            return heads.index(fitted(baseline))
        told = ", ".join(map(brief, heads))
        raise ScenarioError(
            f"compare: no plan is called {brief(baseline)}; baseline is one of {told}"
        )
    if not is_whole(baseline) or not 0 <= baseline < len(heads):
        raise ScenarioError(
            f"compare: baseline {brief(baseline)} is no plan; give 0 to {len(heads) - 1} or a title"
        )
    return int(baseline)


def _checked(plans: object, net: RoadNetwork) -> Sequence[Plan]:
    if not isinstance(plans, list | tuple):
        raise ScenarioError("compare: the plans are no list; give two or more of one network")
    if not plans:
        raise ScenarioError("compare: no plans; give two or more of one network")
    for plan in plans:
        check_plan(plan, net)
    return plans


def _common_styles(plans: Sequence[Plan]) -> dict[str, VehicleStyle]:
    names = [trip.vehicle for trip in plans[0].trips]
    return dict(zip(names, vehicle_styles(names), strict=True))
