"""Which roads a network keeps: those of the wanted classes that a truck may drive on."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import MapDataError
from ..network.load_report import LoadReport
from ..network.preparing.simplify import merge_chains
from ..network.road_network import ROAD_CLASSES, RoadNetwork
from .truck import TruckRules, WayReading, dropped, read_way

__all__ = ["RoadChoice", "class_code"]


def class_code(highway: str) -> int:
    """Return the code of a road's class.

    Parameters
    ----------
    highway : str
        Value of the tag.

    Returns
    -------
    int
        Position in `ROAD_CLASSES`; that of "other" for one that is not there.
    """
    return ROAD_CLASSES.index(highway if highway in ROAD_CLASSES else "other")


class RoadChoice:
    """Choose roads by their tags and keep count of what was dropped, and why.

    Parameters
    ----------
    classes : sequence of str
        The wanted values of `highway`.
    rules : TruckRules
        The truck.
    unit : str
        What is read, "ways" or "edges", for the names of the counts.
    """

    def __init__(self, classes: Sequence[str], rules: TruckRules, unit: str) -> None:
        self.classes = classes
        self.rules = rules
        self.unit = unit
        self.counts: Counter[str] = Counter()
        self.found: Counter[str] = Counter()
        self.closed = 0
        self._within: dict[str, TruckRules] = {}

    def read(self, tags: Mapping[str, str], country: str = "") -> WayReading | None:
        """Return what the tags of a road mean, None if it is dropped.

        Parameters
        ----------
        tags : mapping of str to str
            Tags of a road.
        country : str
            Where it is, "IT" or "US-CA"; empty if that is not known.

        Returns
        -------
        WayReading or None
            What they mean; None if the road is dropped.
        """
        highway = tags.get("highway", "")
        self.counts[f"{self.unit} read"] += 1
        self.found[highway or "none"] += 1
        if highway not in self.classes:
            self.counts[f"{self.unit} dropped: other road class"] += 1
            return None
        if country not in self._within:
            self._within[country] = self.rules.within(country)
        reading = read_way(tags, self._within[country])
        if not reading.allowed:
            self.counts[dropped(reading, self.unit)] += 1
            self.closed += 1
            return None
        self.counts[f"{self.unit} kept"] += 1
        self.counts.update(reading.remarks)
        return reading

    def check_any(self, what: str) -> None:
        """Refuse data without a single road to keep.

        Parameters
        ----------
        what : str
            The file or graph, to begin the message with.

        Raises
        ------
        MapDataError
            With the classes that were found instead.
        """
        if self.counts[f"{self.unit} kept"]:
            return
        found = ", ".join(f"{kind} ({count:,})" for kind, count in self.found.most_common(8))
        closed = self.closed
        raise MapDataError(
            f"{what}: no road of class {', '.join(self.classes)} that trucks may use"
            f"{f' ({closed:,} are closed to them)' if closed else ''}; "
            f"found: {found or 'no road at all'}; choose other classes or a larger area"
        )

    def finished(
        self, net: RoadNetwork, junctions: NDArray[np.bool_], *remarks: str
    ) -> RoadNetwork:
        """Contract the chains between junctions, which stay, and attach the report.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        junctions : ndarray of bool, (n,)
            Nodes to keep though the road only passes them.
        *remarks : str
            Sentences for the report.

        Returns
        -------
        RoadNetwork
            The contracted network.
        """
        merged = merge_chains(net, junctions)
        ordered = sorted(self.counts, key=lambda name: not name.startswith(self.unit))
        counts = {name: self.counts[name] for name in ordered}
        if merged.graded_m.any():
            counts["km of known grade"] = round(merged.graded_m.sum() / 1000)
        touched = np.zeros(net.n, bool)
        touched[net.tail] = touched[net.head] = True
        counts |= {
            "nodes on kept roads": int(touched.sum()),
            "nodes contracted": int(touched.sum()) - merged.n,
            "nodes after contracting chains": merged.n,
            "edges after contracting chains": merged.m,
            "named junctions": int((merged.node_name > 0).sum()),
            "numbered junctions": int((merged.node_ref > 0).sum()),
        }
        return merged.with_report(LoadReport(counts, remarks))
