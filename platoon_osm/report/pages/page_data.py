"""The document as it stands in a page: written short, records as columns, named places as lines.

The script of the page puts them back (scene.js), so that it works on the document as
docs/report.md has it; but for the fatigue and the law's clocks along the day, which still charts
alone show, and bill, gain and chances, which stand in tables.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..document.as_json import as_json
from ..document.model import Document
from ..document.model_map import JunctionLabel, StopLabel, TownLabel
from ..drawing.polyline import encode_steps
from ..markup.security import json_for_html
from .online_map import Tiles
from .packing import packed

__all__ = ["page_data"]


def page_data(document: Document, tiles: Tiles | None) -> str:
    """Return what the script of a page reads.

    Parameters
    ----------
    document : Document
        What is shown.
    tiles : Tiles or None
        An online map underneath.

    Returns
    -------
    str
        JSON that cannot end the element it stands in.
    """
    whole = as_json(document)
    whole["law"] = None
    for table in ("bill", "gain", "chances"):
        whole.pop(table, None)
    for vehicle in whole["vehicles"]:
        del vehicle["fatigue"]
    return json_for_html(
        {
            **packed(whole),
            "towns": _packed(document.towns, "".join(str(town.rank) for town in document.towns)),
            "junctions": _packed(document.junctions),
            "stops": {
                **_packed(document.stops),
                "told": _unrepeated([stop.told for stop in document.stops]),
            },
            "tiles": as_json(tiles),
        }
    )


def _unrepeated(lines: Sequence[str]) -> str:
    """Return lines of which one that is like the line before it is empty: many stops are alike."""
    before = ["", *lines]
    return "\n".join("" if one == last else one for one, last in zip(lines, before, strict=False))


def _packed(
    labels: Sequence[TownLabel | JunctionLabel | StopLabel], ranks: str = ""
) -> dict[str, str]:
    """Return places as an encoded line, with their names a line each: a name has no line end."""
    points = np.array([(label.lon, label.lat) for label in labels], np.int64).reshape(-1, 2)
    names = "\n".join(label.name for label in labels)
    return {"at": encode_steps(points), "names": names, "ranks": ranks}
