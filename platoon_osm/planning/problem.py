"""What is asked of the planner, in one record that is checked once."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from ..chance.delays import Delays
from ..costs.objective import Objective, check_objective
from ..costs.weights import EdgeWeights
from ..driving.rules import NO_RULES, DrivingRules, limits_of, rules_of
from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole, kind_of
from ..network.access import STANDARD_ACCESS, Access
from ..network.road_network import RoadNetwork
from ..plans.text_table import listed
from ..plans.trip import Trip, check_one_clock
from ..search.protocol import EngineName
from ..sharing.rule_names import SharingRule
from ..vehicles.profile import DEFAULT_VEHICLE, Vehicle, vehicle_of
from .cases import CASES
from .delays_asked import checked_delays
from .master import LONGEST
from .routers import Method
from .timing.limits import PATIENCE_MIN

__all__ = ["Company", "Lead", "Optimum", "Problem"]

Optimum = Literal["member", "system"]
Company = Literal["anywhere", "master"]
Lead = Literal["master", "rotated"]


@dataclass(frozen=True, slots=True, repr=False)
class Problem:
    """A question to the planner: who goes where, and what is to be least.

    Attributes
    ----------
    net : RoadNetwork
        The network.
    trips : tuple of Trip
        One or more; any iterable of trips will do.
    objective : Objective or EdgeWeights
        What every edge costs and what waiting does.
    rules : DrivingRules or str
        Rules of driving times, or the name of some: "eu561", "us395", "spread-rest", "none". Breaks
        and rests are planned by their limits; what else a plan breaks of them is remarked.
    task_relief : float
        How much a follower's driving clock slows under the rules, from 0, as the law has it today,
        to 1, as the paper has it.
    case : {"A", "B", "C", "D", "best"}
        "A" members merge and stay, "B" start together and separate, "C" both, "D" two vehicles
        whose routes are both free, "best" the cheapest of those that apply.
    master : str or None
        Name of the vehicle that keeps its route, or "longest" for that of the longest route, which
        is the paper's rule. By default every vehicle is tried and the plan that is cheapest for
        all is taken; under A* it is the longest.
    method : {"dijkstra", "astar", "astar-closed-once"}
        "dijkstra" is exact; "astar" is the paper's inflated A*, "astar-closed-once" the same with
        each node explored once.
    optimum : {"member", "system"}
        Whose cost is least: each member's own (the paper), or that of members and master together.
    engine : {"auto", "reference", "hierarchy"}
        Which engine searches; routes do not depend on it.
    access : Access
        How places beside the road get onto it.
    company : {"anywhere", "master"}
        Where vehicles that drive side by side are a platoon: "anywhere", and then vehicles plan
        again in turns around each other; or with the master alone, as in the paper.
    max_platoon : int or None
        Vehicles of the largest platoon allowed, 2 or more; None for any.
    patience_min : float
        By how many minutes company may move a vehicle that names no window; one with a window may
        be moved within it. Nobody who is in time alone is late for company.
    profile : Vehicle or None
        The vehicle of every trip that names none; a name of `VEHICLES` or a mapping will do. None
        is `DEFAULT_VEHICLE` at whatever speed the network was loaded for.
    close : tuple of str, int or (float, float)
        Roads that count as closed; see `planning.road_closures`.
    delays : Delays or None
        How late vehicles may be; the plan then tells how likely each merge is. Spreads that trips
        name themselves are in it, too.
    robust : bool
        Whether the plan that is expected to save most with these delays is taken, not the cheapest.
    lead : {"master", "rotated"}
        Who leads: the master wherever it is, or all in turns, so that each leads its fair share;
        see `planning.rotation`.
    share : {"equal", "shapley", "least-core"}
        By what rule the gain is shared, where costs are money; see `planning.sharing_rules`.

    Raises
    ------
    ScenarioError
        Anything that is not what it should be, in one line.
    """

    net: RoadNetwork
    trips: tuple[Trip, ...]
    objective: Objective | EdgeWeights
    rules: DrivingRules = NO_RULES
    task_relief: float = 0.0
    case: str = "best"
    master: str | None = None
    method: Method = "dijkstra"
    optimum: Optimum = "member"
    engine: EngineName = "auto"
    access: Access = STANDARD_ACCESS
    company: Company = "anywhere"
    max_platoon: int | None = None
    patience_min: float = PATIENCE_MIN
    profile: Vehicle | None = None
    close: tuple[Any, ...] = ()
    delays: Delays | None = None
    robust: bool = False
    lead: Lead = "master"
    share: SharingRule = "equal"

    def __post_init__(self) -> None:
        if not isinstance(self.net, RoadNetwork):
            raise ScenarioError(
                f"plan: net is a {kind_of(self.net)}; give the network first, from load_network, "
                "then weights and trips"
            )
        check_objective(self.objective, "plan", ("weights", "waiting"))
        object.__setattr__(self, "trips", _trips(self.trips))
        for label, value, allowed in (
            ("case", self.case, (*CASES, "best")),
            ("optimum", self.optimum, get_args(Optimum)),
            ("method", self.method, get_args(Method)),
            ("engine", self.engine, get_args(EngineName)),
            ("company", self.company, get_args(Company)),
            ("lead", self.lead, get_args(Lead)),
            ("share", self.share, get_args(SharingRule)),
        ):
            check_choice(label, value, allowed)
        object.__setattr__(self, "rules", rules_of(self.rules))
        if not (is_number(self.task_relief) and 0 <= self.task_relief <= 1):
            raise ScenarioError(
                f"task_relief is {brief(self.task_relief)}; give a number from 0 to 1"
            )
        if not isinstance(self.access, Access):
            raise ScenarioError(f"plan: access is a {kind_of(self.access)}; give an Access")
        if self.profile is not None:
            object.__setattr__(self, "profile", vehicle_of(self.profile, "profile"))
        object.__setattr__(self, "close", _closed(self.close))
        names = [trip.vehicle for trip in self.trips]
        known = (*names, LONGEST)
        if self.master is not None and not (isinstance(self.master, str) and self.master in known):
            raise ScenarioError(
                f"master {brief(self.master)} has no trip; vehicles are {listed(names)}; or use "
                f"{LONGEST!r}"
            )
        if self.max_platoon is not None and not (
            is_whole(self.max_platoon) and self.max_platoon > 1
        ):
            raise ScenarioError(
                f"max_platoon is {brief(self.max_platoon)}; give a whole number, 2 or more, or None"
            )
        if not (is_number(self.patience_min) and 0 <= self.patience_min < math.inf):
            raise ScenarioError(
                f"patience_min is {brief(self.patience_min)}; give minutes, 0 or more"
            )
        if twice := next((name for name, times in Counter(names).items() if times > 1), None):
            raise ScenarioError(
                f"vehicle {brief(twice)} has {names.count(twice)} trips; names must differ"
            )
        if self.case == "D" and len(self.trips) != 2:
            raise ScenarioError(
                f"case 'D' plans two vehicles, not {len(self.trips)}; use C for one master and "
                "many members"
            )
        if self.case == "D" and self.method != "dijkstra":
            raise ScenarioError("case 'D' is beyond the paper's A*; use method dijkstra")
        check_one_clock(self.trips)
        self._check_rules()
        is_exact = self.method == "dijkstra"
        delays = checked_delays(self.delays, self.robust, self.trips, is_exact)
        object.__setattr__(self, "delays", delays)

    def _check_rules(self) -> None:
        if not self.limits_driving:
            return
        name = self.rules.name
        if self.method != "dijkstra":
            raise ScenarioError(
                f"driving rules {name!r} are beyond the paper's A*; use method dijkstra"
            )
        if self.task_relief and self.lead == "rotated":
            raise ScenarioError(
                "lead 'rotated' and task_relief are not planned together, for the clock of who "
                "comes to lead would run on; use lead master, or task_relief 0"
            )
        if not any(trip.times for trip in self.trips):
            raise ScenarioError(
                f"driving rules {name!r} need a clock; give at least one trip an earliest_departure"
            )

    def __repr__(self) -> str:
        return (
            f"<Problem case {self.case}: {len(self.trips):,} trips on "
            f"{brief(self.net.source.name)}, {self.method}, {self.optimum}>"
        )

    @property
    def limits_driving(self) -> bool:
        """Whether its rules have limits, by which breaks and rests are planned."""
        # All are asked: rules that are not planned for two drivers refuse any trip that has them.
        each = [limits_of(self.rules, trip.driver.drivers) for trip in self.trips]
        return any(limits.limits_driving for limits in each)

    def profile_of(self, trip: Trip) -> Vehicle | None:
        """Return the vehicle that is named for a trip.

        Parameters
        ----------
        trip : Trip
            One of the problem.

        Returns
        -------
        Vehicle or None
            Its own, or that of the problem; None if neither names one.
        """
        return self.profile if trip.profile is None else trip.profile

    def vehicle_of(self, trip: Trip) -> Vehicle:
        """Return what drives a trip.

        Parameters
        ----------
        trip : Trip
            One of the problem.

        Returns
        -------
        Vehicle
            The one that is named for it, or `DEFAULT_VEHICLE`.
        """
        return self.profile_of(trip) or DEFAULT_VEHICLE

    @property
    def cases(self) -> tuple[str, ...]:
        """The cases to be planned; of equally good ones the earlier is simpler."""
        if self.case != "best":
            return (self.case,)
        pair = len(self.trips) == 2 and self.method == "dijkstra"
        return tuple(case for case in CASES if case != "D" or pair)


def check_choice(label: str, value: object, allowed: tuple[str, ...]) -> None:
    """Check that a value is one of some words.

    Parameters
    ----------
    label : str
        What the value is, for the message.
    value : object
        Anything.
    allowed : tuple of str
        The words.

    Raises
    ------
    ScenarioError
        It is none of them.
    """
    if not isinstance(value, str) or value not in allowed:
        raise ScenarioError(f"{label} {brief(value)} is unknown; use {', '.join(allowed)}")


def _closed(given: Any) -> tuple[Any, ...]:
    if isinstance(given, str | int) or _is_point(given):
        return (given,)
    if isinstance(given, Mapping) or not isinstance(given, Iterable):
        raise ScenarioError(f"close is a {kind_of(given)}; give a list of roads")
    return tuple(given)


def _is_point(given: Any) -> bool:
    """Tell a pair of coordinates from a list of roads, of which edge ids are whole numbers."""
    return (
        isinstance(given, tuple | list)
        and len(given) == 2
        and all(isinstance(part, float) for part in given)
    )


def _trips(given: Any) -> tuple[Trip, ...]:
    if isinstance(given, Trip):
        raise ScenarioError("plan: trips is a single Trip; put it in a list")
    if isinstance(given, str | bytes | Mapping) or not isinstance(given, Iterable):
        raise ScenarioError(f"plan: trips is a {kind_of(given)}; give a list of Trip")
    trips = tuple(given)
    for number, trip in enumerate(trips, 1):
        if not isinstance(trip, Trip):
            remedy = "Trip(**it)" if isinstance(trip, Mapping) else "Trip(vehicle, from, to)"
            raise ScenarioError(f"plan: trip {number} is a {kind_of(trip)}; make it a {remedy}")
    if not trips:
        raise ScenarioError("plan: no trips; give at least one")
    return trips
