"""Road networks from Overture's segments."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from ...errors import MapDataError
from ...network.load_report import Source
from ...network.road_network import RoadNetwork
from ..file_identity import ATTRIBUTION, LICENCE, file_digest
from ..osm.extract import network_of
from ..osm.tables import raw_map
from ..truck import TruckRules
from .parts import cut
from .segments import REMEDY, Segment, segments_of
from .transitions import turns_of

__all__ = ["read_overture"]

OVERTURE = "Overture Maps Foundation"
OSM = "OpenStreetMap"


def read_overture(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read the road segments of Overture's transportation theme.

    Parameters
    ----------
    path : path-like
        GeoParquet or GeoJSON, as Overture's own command downloads it.
    classes : sequence of str
        Values of `highway` to keep; Overture's class, with `_link` where its subclass is link.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    RoadNetwork
        The network. Overture has no exits, tolls, barriers or rest areas among its segments.

    Raises
    ------
    MapDataError
        Not a file of segments, cut short, or no road of these classes.
    """
    file = Path(path)
    try:
        kinds = {kind.removesuffix("_link") for kind in classes}
        segments, others = segments_of(file, kinds)
        parts = cut(segments)
        turns = turns_of(segments, parts)
    except MapDataError:
        raise
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
        said = " ".join(str(error).split())[:120]
        raise MapDataError(
            f"{file}: not a file of Overture segments, or damaged ({said}); {REMEDY}"
        ) from error
    source = Source(file.name, file_digest(file), "", LICENCE, _attribution(segments))
    raw = raw_map(
        str(file), source, parts.ways, parts.nodes, turns,
        classes=classes, left_out=parts.counts, others=others,
    )  # fmt: skip
    net = network_of(raw, str(file), classes, rules)
    remark = "Overture's segments tell neither tolls, exits and barriers nor rest areas"
    return net.with_report(net.load_report.extended({}, remark))


def _attribution(segments: Sequence[Segment]) -> str:
    """Return whose data it is: OpenStreetMap's only where a segment says so."""
    sets = {
        str(source.get("dataset", ""))
        for segment in segments
        for source in segment.about.get("sources") or ()
    }
    return f"{ATTRIBUTION}, {OVERTURE}" if OSM in sets else OVERTURE
