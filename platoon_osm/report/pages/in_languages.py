"""The page of a plan in several languages: a file for each, which leads to the others."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ...atomic_file import all_or_none, whole_file
from ...errors import ScenarioError, brief
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES, checked_folder
from ...plans.plan import Plan
from ..document.checks import check_path
from ..document.document import document_of
from ..language.languages import Language, language_of
from ..language.languages import languages as all_languages
from ..markup.leaflet import load_leaflet
from .page_parts import Another, PageParts

if TYPE_CHECKING:
    from ...costs.weights import EdgeWeights

__all__ = ["write_pages"]


def write_pages(
    plan: Plan,
    net: RoadNetwork,
    folder: str | os.PathLike[str],
    *,
    title: str | None = None,
    weights: EdgeWeights | None = None,
    languages: Sequence[str] | None = None,
    clock: int | None = None,
) -> list[Path]:
    """Write a plan's report in several languages, each page with links to the others.

    The files are `plan.en.html`, `plan.de.html` and so on. The part `language=de` of an address
    leads from any of them to that one, and what is looked at, map, moment and vehicle, goes along.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    folder : path-like
        Where to write; it is made if it is not there.
    title : str or None
        Heads the pages; by default made from the first vehicle's journey.
    weights : EdgeWeights or None
        Those the plan was made with; see `report_document`.
    languages : sequence of str or None
        Such as ("en-GB", "de"), each language once; by default all there are.
    clock : int or None
        24 or 12 hours; by default as each language has it.

    Returns
    -------
    list of Path
        What was written, in the order of the languages.

    Raises
    ------
    ScenarioError
        A plan that does not fit the network, languages that are none or named twice, or a folder
        that cannot be written to.
    """
    from .folium_map import PlanMap

    place = check_path(folder)
    spoken = _asked(languages, clock)
    leaflet = load_leaflet(None)
    pages = [(one, place / f"plan.{one.code}.html") for one in spoken]
    checked_folder(place)
    with all_or_none():
        for own, path in pages:
            document = document_of(
                plan, net, title=title, weights=weights, language=own.code, clock=clock
            )
            others = tuple(Another(one.code, one.own_name, file.name) for one, file in pages)
            text = PlanMap(PageParts(document, leaflet, others=others)).get_root().render()
            with whole_file(path, suffixes=PAGES) as draft:
                draft.write_text(text, encoding="utf-8", newline="\n")
    return [path for _, path in pages]


def _asked(codes: Sequence[str] | None, clock: int | None) -> list[Language]:
    if codes is None:
        codes = all_languages()
    is_list = isinstance(codes, Sequence) and not isinstance(codes, str | bytes)
    if not is_list or not codes or not all(isinstance(code, str) for code in codes):
        raise ScenarioError(
            f"pages: languages {brief(codes)} must be a list of codes, such as ('en', 'de')"
        )
    found = [language_of(code, clock) for code in codes]
    if len({one.code.lower() for one in found}) < len(found):
        raise ScenarioError(f"pages: languages {brief(codes)} names one twice")
    return found
