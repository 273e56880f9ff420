"""What is worked out of a plan once, before any of it is put into words: all builders read this."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...costs.weights import EdgeWeights
from ...network.road_network import RoadNetwork
from ...plans.events import Event, platoon_events
from ...plans.records import JointPlan
from ...plans.stretches import (
    PlatoonPart,
    PlatoonSection,
    SoloStretch,
    platoon_groups,
    platoon_parts,
    platoon_sections,
    solo_stretches,
)
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..markup.quantities import CostUnit, cost_unit
from .checks import check_plan, check_styles
from .journey import journey, ways
from .model_day import JourneyScale
from .opposite import opposite_gaps
from .solo_costs import known_weights
from .timeline import event_time

__all__ = ["Findings", "find"]

Way = tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class Findings:
    """A plan, its network, and all that more than one part of the document needs to know of them.

    Attributes
    ----------
    plan : JointPlan
        What is told.
    net : RoadNetwork
        Where it drives.
    unit : CostUnit
        How its costs are printed.
    styles : tuple of VehicleStyle
        How each vehicle looks.
    known : EdgeWeights or None
        The weights it was made with, if they can be told.
    sections : tuple of PlatoonSection
        Stretches of one company.
    parts : tuple of tuple of PlatoonPart
        Each section, cut where its place in the drawing changes.
    stretches : tuple of SoloStretch
        Stretches driven alone, cut likewise.
    groups : tuple of tuple of int
        Vehicles that belong together.
    ways : tuple of tuple
        Each vehicle's pieces in driving order: "solo" or "platoon", and the position there.
    events : tuple of Event
        Merges and separations in driving order.
    moments : tuple of float or None
        When each event is [s]; None without times.
    scale : JourneyScale or None
        The common scale of distance, not rounded.
    """

    plan: JointPlan
    net: RoadNetwork
    unit: CostUnit
    styles: tuple[VehicleStyle, ...]
    known: EdgeWeights | None
    sections: tuple[PlatoonSection, ...]
    parts: tuple[tuple[PlatoonPart, ...], ...]
    stretches: tuple[SoloStretch, ...]
    groups: tuple[tuple[int, ...], ...]
    ways: tuple[Way, ...]
    events: tuple[Event, ...]
    moments: tuple[float | None, ...]
    scale: JourneyScale | None

    def letters(self, vehicles: Sequence[int]) -> list[str]:
        """Return what some vehicles are called in pictures.

        Parameters
        ----------
        vehicles : sequence of int
            Positions in the plan.

        Returns
        -------
        list of str
            Their letters.
        """
        return [self.styles[index].letter for index in vehicles]


def find(
    plan: JointPlan,
    net: RoadNetwork,
    weights: EdgeWeights | None = None,
    styles: Mapping[str, VehicleStyle] | None = None,
) -> Findings:
    """Work out a plan for its document, each thing once.

    Parameters
    ----------
    plan : JointPlan
        What is told.
    net : RoadNetwork
        The network it was made on.
    weights : EdgeWeights or None
        Those it was made with, where they cannot be made again from its parameters.
    styles : mapping of str to VehicleStyle, or None
        How each vehicle looks, by its name; by default their own.

    Returns
    -------
    Findings
        All that the builders of the document need.

    Raises
    ------
    ScenarioError
        A plan that does not fit the network, or weights that do not fit the plan.
    """
    check_plan(plan, net)
    check_styles(styles, plan)
    names = [vehicle.vehicle for vehicle in plan.vehicles]
    looks = vehicle_styles(names) if styles is None else [styles[name] for name in names]
    sections = platoon_sections(plan)
    events = platoon_events(plan, sections)
    groups = platoon_groups(sections, len(plan.vehicles))
    opposite = opposite_gaps(net, (edge for vehicle in plan.vehicles for edge in vehicle.edges))
    return Findings(
        plan=plan,
        net=net,
        unit=cost_unit(plan.unit),
        styles=tuple(looks),
        known=known_weights(plan, net, weights),
        sections=tuple(sections),
        parts=tuple(platoon_parts(sections, opposite)),
        stretches=tuple(solo_stretches(plan, sections, opposite)),
        groups=tuple(groups),
        ways=ways(plan, sections),
        events=tuple(events),
        moments=tuple(event_time(plan, event) for event in events),
        scale=journey(plan, net, sections, groups),
    )
