"""What a plan would cost by other figures: its roads, companies, orders and times kept.

Each vehicle's share of each stretch is worked out anew, edge by edge, from what edges cost by place
and size of a company. A stretch that begins or ends within an edge pays that part of it. Waiting
and delay are paid as they stand in its timetable.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..costs.share import Share
from ..network.placed import network_below
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..plans.records import Stretch
from .billing import with_bill
from .driven_pieces import DrivenPieces
from .ends import located
from .fleet import Fleet
from .fleet_of import fleet_of
from .places import PlacedEnds, placed
from .problem import Problem
from .road_closures import closed_roads

__all__ = ["KeptPlan"]

Index = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class KeptPlan:
    """A plan whose roads are known on the network that has its places.

    Attributes
    ----------
    plan : Plan
        That is kept.
    places : PlacedEnds
        The network with the places of its trips.
    shut : ndarray of bool, (m,)
        Roads that count as closed.
    roads : tuple of (ndarray, ndarray), one a stretch
        Edge ids of that network, and how much of each is driven, as a share of its length.
    """

    plan: Plan
    places: PlacedEnds
    shut: NDArray[np.bool_]
    roads: tuple[tuple[Index, Floats], ...]

    @classmethod
    def of(cls, plan: Plan, problem: Problem) -> KeptPlan:
        """Find the roads of a plan.

        Parameters
        ----------
        plan : Plan
            Of the problem.
        problem : Problem
            What was asked.

        Returns
        -------
        KeptPlan
            Ready to be priced.
        """
        locations = located(problem.net, problem.trips, problem.access, problem.profile)
        places = placed(problem.net, locations, problem.access)
        shut = closed_roads(problem.net, problem.close)
        pieces = places.net.attached(DrivenPieces)
        return cls(plan, places, shut, tuple(map(pieces.of, plan.stretches)))

    def kept(self, plan: Plan) -> KeptPlan:
        """Return another plan of the same trips, its roads found on the same network.

        Parameters
        ----------
        plan : Plan
            Of the same trips and places.

        Returns
        -------
        KeptPlan
            Ready to be priced.
        """
        pieces = self.places.net.attached(DrivenPieces)
        return replace(self, plan=plan, roads=tuple(map(pieces.of, plan.stretches)))

    def priced(self, problem: Problem, alone: Plan) -> Plan:
        """Return the plan with what it costs by the objective of a problem.

        Parameters
        ----------
        problem : Problem
            The same but for its objective.
        alone : Plan
            Any plan of that problem; what vehicles do alone is read off it.

        Returns
        -------
        Plan
            With its bill where costs are money; its proof and its remarks are those it had.
        """
        fleet = fleet_of(problem, self.places, self.shut)
        stretches = tuple(
            replace(stretch, shares=_shares(self.places.net, fleet, stretch, *road))
            for stretch, road in zip(self.plan.stretches, self.roads, strict=True)
        )
        kept = replace(
            self.plan, stretches=stretches, trips=alone.trips, params=alone.params, bill=None,
            gain=None,
        )  # fmt: skip
        return with_bill(kept, problem.objective, network_below(problem.net))


def _shares(
    net: RoadNetwork, fleet: Fleet, stretch: Stretch, edges: Index, driven: Floats
) -> tuple[Share, ...]:
    whole = edges[driven >= 1]
    parts = [(whole, 1.0)] if len(whole) else []
    parts += [(edges[k : k + 1], float(driven[k])) for k in np.flatnonzero(driven < 1).tolist()]
    found = []
    for place in range(len(stretch.vehicles)):
        shares = [
            fleet.share(stretch.vehicles, place, ids, float(net.length_m[ids].sum())).part(part)
            for ids, part in parts
        ]
        found.append(_sum(shares))
    return tuple(found)


def _sum(shares: Sequence[Share]) -> Share:
    """Return what pieces of a stretch cost together."""
    if len(shares) == 1:
        return shares[0]
    return Share(
        sum(one.cost for one in shares),
        sum(one.alone_cost or 0.0 for one in shares),
        sum(one.fuel_l for one in shares),
        sum(one.alone_fuel_l for one in shares),
        terms=tuple(map(sum, zip(*(one.terms for one in shares), strict=True))),
        alone_terms=tuple(map(sum, zip(*(one.alone_terms for one in shares), strict=True))),
    )
