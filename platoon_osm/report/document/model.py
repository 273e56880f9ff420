"""The document of a plan: all that pages show of it, as records made once.

The order of the fields is that of the keys of its JSON, which `as_json` writes; docs/report.md
says what each means to a reader.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from ...plans.bill import Bill
from ...plans.chances import Chances
from ...plans.gain import GainSharing
from ..drawing.lines import Line
from ..ground.model import Ground
from .model_day import DaySchedule, JourneyScale, LongDrive
from .model_law import Law
from .model_lead import LeadTurn, PositionMark
from .model_map import (
    Basemap,
    EventMark,
    JunctionLabel,
    PlatoonLine,
    SoloLine,
    StopLabel,
    TownLabel,
    Traffic,
)
from .model_vehicle import CostTexts, Vehicle

__all__ = [
    "NOT_IN_JSON",
    "CostLabel",
    "Document",
    "Figure",
    "Group",
    "LabelledText",
    "Provenance",
    "Status",
    "Totals",
]

NOT_IN_JSON = {"json": False}
"""Marks a field that drawings need and readers of the JSON do not."""

IF_THERE = {"if there": True}
"""Marks a field that the JSON has only where it is not None."""


@dataclass(frozen=True, slots=True)
class CostLabel:
    """What costs are counted in.

    Attributes
    ----------
    label : str
        Heads a column.
    note : str
        Explains the unit; empty if it needs no explanation.
    name : str
        As the plan calls it, for files.
    scale : float
        Printed figure per figure of the document.
    decimals : int
        Of printed figures.
    """

    label: str
    note: str
    name: str
    scale: float = field(metadata=NOT_IN_JSON)
    decimals: int = field(metadata=NOT_IN_JSON)


@dataclass(frozen=True, slots=True)
class Status:
    """What a reader should know first, in a line.

    Attributes
    ----------
    kind : str
        "bad" if somebody is late, "good" if all are in time, else "plain".
    text : str
        What it says.
    """

    kind: str
    text: str


@dataclass(frozen=True, slots=True)
class Figure:
    """One of the large figures at the head of a page.

    Attributes
    ----------
    figure : str
        The figure with its unit.
    label : str
        What it tells.
    kind : str
        "good" if it is a gain and nobody is late for it, else "plain".
    """

    figure: str
    label: str
    kind: str


@dataclass(frozen=True, slots=True)
class Totals:
    """Sums over all vehicles.

    Attributes
    ----------
    solo_cost, joint_cost : float
        Of driving alone and as planned, in the plan's unit.
    saving : float
        Share of the cost alone that the plan saves.
    platoon_road_m : float
        Road driven in platoon, counted once.
    platoon_m : float
        Vehicle-metres in platoon.
    fuel_saved_l : float
        Against driving alone.
    extra_m : float
        How much further all vehicles drive together than alone.
    figures : tuple of Figure
        The three at the head of the page; of money what is saved, fuel and CO2e.
    text : CostTexts
        The costs as they are printed.
    """

    solo_cost: float
    joint_cost: float
    saving: float
    platoon_road_m: float
    platoon_m: float
    fuel_saved_l: float
    extra_m: float
    figures: tuple[Figure, ...]
    text: CostTexts


@dataclass(frozen=True, slots=True)
class Group:
    """Vehicles that are told of together: a platoon, or all who drive alone.

    Attributes
    ----------
    kind : str
        "platoon" or "alone".
    name, facts : str
        Its heading, and how many vehicles and how much road it has.
    vehicles : tuple of int
        Positions in the document.
    road_m : float
        Road driven in platoon, counted once.
    saved : float
        In the plan's unit.
    text : CostTexts
        Its costs as they are printed.
    """

    kind: str
    name: str
    facts: str
    vehicles: tuple[int, ...]
    road_m: float
    saved: float
    text: CostTexts

    @property
    def is_platoon(self) -> bool:
        """Whether its vehicles drive together."""
        return self.kind == "platoon"


class LabelledText(NamedTuple):
    """A row of what a page tells about a plan.

    Attributes
    ----------
    label : str
        What it is.
    text : str
        What it says.
    """

    label: str
    text: str


@dataclass(frozen=True, slots=True)
class Provenance:
    """Where a plan comes from, and who is to be named.

    Attributes
    ----------
    rows : tuple of LabelledText
        Network, method, parameters, version.
    proof : str
        How good the plan is known to be, in a sentence.
    remarks : tuple of str
        What a reader should know.
    credits : tuple of str
        Whom to name with the map.
    """

    rows: tuple[LabelledText, ...]
    proof: str
    remarks: tuple[str, ...]
    credits: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Document:
    """All that pages show of one plan on one network.

    Attributes
    ----------
    format : str
        "platoon_osm report".
    version : int
        Of the format.
    language : str
        That all its texts are in, BCP 47.
    clock : int
        The hours on the face of its clock, 24 or 12.
    title, subtitle : str
        Head the page.
    status : tuple of Status
        What a reader should know first.
    cost_unit : CostLabel
        What costs are counted in.
    totals : Totals
        Sums over all vehicles.
    vehicles : tuple of Vehicle
        In the plan's order.
    groups : tuple of Group
        Platoons, then those who drive alone.
    platoons : tuple of PlatoonLine
        Stretches of one company.
    solos : tuple of SoloLine
        Stretches driven alone.
    traffic : Traffic or None
        What a crowd is drawn as; None of few vehicles.
    events : tuple of EventMark
        Merges and separations in driving order, and pauses among them.
    journey : JourneyScale or None
        The common scale of distance; None if there is none.
    schedule : DaySchedule or None
        The day by the clock; None without times.
    law : Law or None
        The driving rules by which it was planned, and what they count; None without.
    inferred_routes : tuple of Line
        Where routes follow roads that the loader inferred.
    towns : tuple of TownLabel
        Most important first.
    junctions : tuple of JunctionLabel
        Interchanges first.
    stops : tuple of StopLabel
        Where trucks may stop on the ways of the plan.
    basemap : Basemap
        The network in the background.
    ground : Ground or None
        Land, sea and borders under it; None where it does not lie on land.
    provenance : Provenance
        Where the plan comes from.
    levels : tuple of float or None
        Where each vehicle starts on the scale of its own group; None if that has none.
    long_drives : tuple of LongDrive
        Who drives beyond 4 h 30 without a break.
    leads : tuple of LeadTurn
        Who leads from where on, where the lead is handed on.
    positions : tuple of tuple of PositionMark
        The positions of each vehicle on the clock, where the lead is handed on.
    bill : Bill or None
        What vehicles pay for what; None where costs are no money.
    gain : GainSharing or None
        Who gets what is saved; None where it is not shared.
    chances : Chances or None
        How likely merges are, their events those of the document; None without delays.
    """

    format: str
    version: int
    language: str
    clock: int
    title: str
    subtitle: str
    status: tuple[Status, ...]
    cost_unit: CostLabel
    totals: Totals
    vehicles: tuple[Vehicle, ...]
    groups: tuple[Group, ...]
    platoons: tuple[PlatoonLine, ...]
    solos: tuple[SoloLine, ...]
    traffic: Traffic | None
    events: tuple[EventMark, ...]
    journey: JourneyScale | None
    schedule: DaySchedule | None
    law: Law | None
    inferred_routes: tuple[Line, ...]
    towns: tuple[TownLabel, ...]
    junctions: tuple[JunctionLabel, ...]
    stops: tuple[StopLabel, ...]
    basemap: Basemap
    ground: Ground | None
    provenance: Provenance
    levels: tuple[float | None, ...] = field(metadata=NOT_IN_JSON)
    long_drives: tuple[LongDrive, ...] = field(metadata=NOT_IN_JSON)
    leads: tuple[LeadTurn, ...] = field(metadata=NOT_IN_JSON)
    positions: tuple[tuple[PositionMark, ...], ...] = field(metadata=NOT_IN_JSON)
    bill: Bill | None = field(default=None, metadata=IF_THERE)
    gain: GainSharing | None = field(default=None, metadata=IF_THERE)
    chances: Chances | None = field(default=None, metadata=IF_THERE)

    def piece_m(self, kind: str, piece: int) -> float:
        """Return the length of a piece of a vehicle's way.

        Parameters
        ----------
        kind : str
            "platoon" or "solo".
        piece : int
            Its position in `platoons` or `solos`.

        Returns
        -------
        float
            In metres.
        """
        return (self.platoons if kind == "platoon" else self.solos)[piece].length_m
