"""What is worked out of a plan once, before any of it is put into words: all builders read this."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...costs.weights import EdgeWeights
from ...network.antimeridian import near_deg
from ...network.preparing.unrolled import centre_longitude_deg, unrolled
from ...network.road_network import RoadNetwork
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...plans.records import Event, Stretch
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..markup.quantities import CostUnit
from .alone_costs import with_alone_costs
from .checks import check_plan, check_styles
from .journey import journey, levels
from .line_parts import PlatoonPart, SoloPart, platoon_parts, solo_parts
from .model_day import JourneyScale
from .opposite import opposite_gaps
from .wording import plan_unit

__all__ = ["Findings", "find", "moment_of"]

Way = tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class Findings:
    """A plan, its network, and all that more than one part of the document needs to know of them.

    Attributes
    ----------
    plan : Plan
        What is told, laid out in whole edges.
    net : RoadNetwork
        Where it drives, cut where its stretches begin and end; laid on a plane, so that longitudes
        of a network across the antimeridian may lie beyond 180.
    unit : CostUnit
        How its costs are printed.
    styles : tuple of VehicleStyle
        How each vehicle looks.
    platoons, solos : tuple of Stretch
        The plan's stretches that several vehicles drive, and those that one does.
    platoon_parts : tuple of tuple of PlatoonPart
        Each of the former, cut where its place in the drawing changes.
    solo_parts : tuple of tuple of SoloPart
        Each of the latter, cut likewise.
    groups : tuple of tuple of int
        Vehicles that belong together.
    ways : tuple of tuple
        Each vehicle's pieces in driving order: "solo" or "platoon", and the position there.
    moments : tuple of float or None
        When each event of the plan is [s]; None without times.
    scale : JourneyScale or None
        The common scale of distance, not rounded.
    levels : tuple of float or None
        Where each vehicle starts on the scale of its own group; None if that has none.
    centre : float
        The meridian in the middle of the network [deg].
    """

    plan: Plan
    net: RoadNetwork
    unit: CostUnit
    styles: tuple[VehicleStyle, ...]
    platoons: tuple[Stretch, ...]
    solos: tuple[Stretch, ...]
    platoon_parts: tuple[tuple[PlatoonPart, ...], ...]
    solo_parts: tuple[tuple[SoloPart, ...], ...]
    groups: tuple[tuple[int, ...], ...]
    ways: tuple[Way, ...]
    moments: tuple[float | None, ...]
    scale: JourneyScale | None
    levels: tuple[float | None, ...]
    centre: float

    def longitude(self, lon: float) -> float:
        """Return where a longitude lies on the map: as far round the globe as the network.

        Parameters
        ----------
        lon : float
            Degrees, as the plan has it.

        Returns
        -------
        float
            Degrees; the same away from the antimeridian.
        """
        return float(near_deg(lon, self.centre))

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
    plan: Plan,
    net: RoadNetwork,
    weights: EdgeWeights | None = None,
    styles: Mapping[str, VehicleStyle] | None = None,
    largest: float | None = None,
) -> Findings:
    """Work out a plan for its document, each thing once.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network it was made on.
    weights : EdgeWeights or None
        Those it was made with, where they cannot be made again from its parameters.
    styles : mapping of str to VehicleStyle, or None
        How each vehicle looks, by its name; by default their own.
    largest : float or None
        The largest cost printed on the page; by default that of all vehicles alone.

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
    plan, net = laid_out(with_alone_costs(plan, net, weights), net)
    net = unrolled(net)
    names = [trip.vehicle for trip in plan.trips]
    looks = vehicle_styles(names) if styles is None else [styles[name] for name in names]
    groups = tuple(one.vehicles for one in plan.platoons if len(one.vehicles) > 1)
    platoons = tuple(stretch for stretch in plan.stretches if stretch.together)
    solos = tuple(stretch for stretch in plan.stretches if not stretch.together)
    road = (stretch.edges for stretch in plan.stretches if stretch.access is None)
    opposite = opposite_gaps(net, (edge for edges in road for edge in edges))
    return Findings(
        plan=plan,
        net=net,
        unit=plan_unit(plan, largest),
        styles=tuple(looks),
        platoons=platoons,
        solos=solos,
        platoon_parts=tuple(platoon_parts(platoons, opposite)),
        solo_parts=tuple(solo_parts(solos, platoons, opposite)),
        groups=groups,
        ways=_ways(plan),
        moments=tuple(moment_of(plan, event) for event in plan.events),
        scale=journey(plan, groups),
        levels=levels(plan, groups),
        centre=centre_longitude_deg(net),
    )


def _ways(plan: Plan) -> tuple[Way, ...]:
    """Return each vehicle's pieces: "solo" or "platoon", and the position among those."""
    seen = {"solo": 0, "platoon": 0}
    pieces: list[tuple[str, int]] = []
    for stretch in plan.stretches:
        kind = "platoon" if stretch.together else "solo"
        pieces.append((kind, seen[kind]))
        seen[kind] += 1
    return tuple(tuple(pieces[stretch] for stretch in way) for way in plan.ways)


def moment_of(plan: Plan, event: Event) -> float | None:
    """Return when an event is.

    Parameters
    ----------
    plan : Plan
        Whose event it is.
    event : Event
        A merge or a separation.

    Returns
    -------
    float or None
        In seconds from the start of the timetable; None if the plan has no times.
    """
    if plan.timetable is None:
        return None
    mover = event.movers[0]
    span = plan.timetable.vehicles[mover].legs[plan.ways[mover].index(event.stretch)]
    return span[0] if event.kind == "merge" else span[1]
