"""A master and its members in whole seconds: what the search for their times under the law needs.

Positions 0 to P lie along the master's way: its origin, the nodes of its route, where members may
merge and separate, and the places where it may rest. Driving times to them are rounded up, so that
sums are whole; windows are rounded inward. Moments count from one reference moment.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ....driving.limits import Limits
from ....driving.state import DriverState
from ..driver.road import Road

__all__ = ["NEVER_S", "OPEN_S", "Span", "StarTimes", "VehicleRules"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

NEVER_S = 2**40
"""As a driving time: there is no way."""

OPEN_S = 2**40
"""As the end of a window, and negative as its begin: it has none."""


@dataclass(frozen=True, slots=True)
class Span:
    """When a vehicle may leave and arrive [s]; plus or minus `OPEN_S` where it may be any.

    Attributes
    ----------
    earliest_s, latest_s : int
        Of its departure. Who leaves its origin by `latest_s` may wait on the way.
    arrival_s : int
        Its latest arrival.
    """

    earliest_s: int = -OPEN_S
    latest_s: int = OPEN_S
    arrival_s: int = OPEN_S


@dataclass(frozen=True, slots=True)
class VehicleRules:
    """What the law is for one vehicle.

    Attributes
    ----------
    limits : Limits
        Of its one driver or two.
    state : DriverState
        What they have behind them.
    state_at_s : int or None
        When that holds [s], its earliest departure; None where it holds whenever it leaves.
    """

    limits: Limits
    state: DriverState
    state_at_s: int | None


@dataclass(frozen=True, slots=True, eq=False)
class StarTimes:
    """One master, M members, P + 1 positions on the master's way, K + 1 nodes of its route.

    Attributes
    ----------
    road : Road
        The master's way: P hops between its positions, where it may rest, and bans.
    node_at : ndarray of int, (K + 1,)
        The position of each node of its route.
    window : Span
        When the master may drive.
    rules : VehicleRules
        The master's.
    approach_s, onward_s : ndarray of int, (M, K + 1)
        Driving times of members alone to each node, and from it; `NEVER_S` where there is no way,
        or none that could pay.
    entry, leave : ndarray of float, (M, K + 1)
        What they cost; inf likewise, and where the case lets nobody merge or separate.
    platoon : ndarray of float, (M, K + 1)
        What each member pays in the platoon from the first node to each node.
    length_m : ndarray of float, (K + 1,)
        From the first node to each [m]; of equally cheap choices the longest platoon is taken.
    alone : ndarray of float, (M,)
        What each pays alone.
    alone_s : ndarray of int, (M,)
        Its driving time alone [s].
    windows : tuple of Span, (M,)
        When each member may drive.
    member_rules : tuple of VehicleRules, (M,)
        Each member's.
    relief : float
        How much of the driving in the platoon a member's clock does not count, [0, 1].
    master_alone : float
        What the master pays alone.
    gain : ndarray of float, (K,)
        What it saves on each edge of its route if it has company there.
    monday_s : int
        A Monday, 0:00 UTC [s].
    """

    road: Road
    node_at: Seconds
    window: Span
    rules: VehicleRules
    approach_s: Seconds
    onward_s: Seconds
    entry: Floats
    leave: Floats
    platoon: Floats
    length_m: Floats
    alone: Floats
    alone_s: Seconds
    windows: tuple[Span, ...]
    member_rules: tuple[VehicleRules, ...]
    relief: float
    master_alone: float
    gain: Floats
    monday_s: int = 0
