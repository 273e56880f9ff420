"""One value for each tag of an OSMnx edge, which after simplification may have several."""

from __future__ import annotations

from collections.abc import Mapping

from ..restricting_tags import is_restriction
from ..road_choice import RoadChoice, class_code
from ..speeds.texts import read_speed_kmh
from ..truck import TOLL_KEYS, is_driving_tag
from ..way_sides import FALSE
from .graph_arrays import Attributes
from .graph_values import flag, parts, tag_text

__all__ = ["edge_class", "truck_tags"]


def edge_class(attributes: Attributes, choice: RoadChoice) -> str:
    """Return the most important wanted class of an edge, else its most important one.

    Parameters
    ----------
    attributes : Attributes
        What the graph says of the edge.
    choice : RoadChoice
        Which roads are wanted; keeps count.

    Returns
    -------
    str
        A value of `highway`.
    """
    values = [str(value) for value in parts(attributes.get("highway"))]
    wanted = [kind for kind in values if kind in choice.classes]
    if wanted and len(values) > 1:
        choice.counts["edges of several classes, the most important taken"] += 1
    return min(wanted or values, key=class_code, default="")


def truck_tags(attributes: Attributes, highway: str, choice: RoadChoice) -> Mapping[str, str]:
    """Return one value for each tag that matters to a truck, out of an edge's attributes.

    Parameters
    ----------
    attributes : Attributes
        What the graph says of the edge.
    highway : str
        Value of the tag.
    choice : RoadChoice
        Which roads are wanted; keeps count.

    Returns
    -------
    mapping of str to str
        Values by key.
    """
    tags = {"highway": highway}
    for key, value in attributes.items():
        if not is_driving_tag(key) or key in {"highway", "oneway", "junction"}:
            continue
        values = [text for text in map(tag_text, parts(value)) if text]
        if values:
            tags[key] = _one_value(key, values, choice)
    two_way = bool(parts(attributes.get("oneway"))) and not flag(attributes.get("oneway"))
    # The graph has settled the direction; a backward edge only picks its side's speed limit.
    backwards = parts(attributes.get("reversed"))
    against = bool(backwards) and all(flag(part) for part in backwards)
    tags["oneway"] = "-1" if against else "yes"
    if two_way:
        # One carriageway for both directions, which the direction of its edges does not show.
        tags["dual_carriageway"] = "no"
    if two_way and highway in {"motorway", "motorway_link"}:
        choice.counts["motorway edges in both directions, as OSMnx has them"] += 1
    return tags


def _one_value(key: str, values: list[str], choice: RoadChoice) -> str:
    if len(values) == 1:
        return values[0]
    if is_restriction(key) and not key.endswith(":conditional"):
        # Access and limits alike: a list is as strict as its strictest part.
        choice.counts["edges with several restrictions, the strictest taken"] += 1
        return ";".join(values)
    if key in TOLL_KEYS:
        choice.counts["edges with toll on a part, taken for the whole"] += 1
        return next((text for text in values if text not in FALSE), values[0])
    if key.startswith("maxspeed") and not key.endswith(":conditional"):
        choice.counts["edges with several speed limits, the lowest taken"] += 1
        known = [text for text in values if read_speed_kmh(text) is not None]
        return min(known or values, key=lambda text: read_speed_kmh(text) or 0.0)
    return ";".join(values)
