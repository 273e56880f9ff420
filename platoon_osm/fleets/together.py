"""Vehicles that must drive together: what they drive, and whether a plan keeps to it.

All of a group are in one platoon on one stretch at least; where they have one origin and one
destination, from start to end. Their ways are the cheapest that have such a stretch
(`shared_way`), over all roads that are in time for them. Everybody else is then planned beside
them, and may join them.
"""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from .companies import companies_of
from .exact import Ways
from .instance import Instance
from .model import FleetModel
from .one_group import Group, Windows, group_of
from .plan.search import FleetSearch
from .shared_way import NOBODY, Others, SharedWays
from .windows import Wanted, paired

__all__ = ["Together"]

Ints = NDArray[np.int64]

SHOWN = 4
"""More vehicles of a group are counted, not named."""

MOST_TICKS = 100
"""By so much a group keeps out of the way of others at most."""


class Together:
    """Groups of trucks that must drive together.

    Parameters
    ----------
    model : FleetModel
        The problem.
    groups : sequence of sequence of str
        Names; those without a truck do not count.
    apart : sequence of (int, int)
        Trucks that must keep apart.

    Raises
    ------
    ScenarioError
        A group that cannot drive together, in one line that names its vehicles.
    """

    def __init__(
        self,
        model: FleetModel,
        groups: Sequence[Sequence[str]],
        apart: Sequence[tuple[int, int]] = (),
    ) -> None:
        self._model, self.instance = model, model.instance
        self.names = [trip.vehicle for trip in model.question.problem.trips]
        place = {name: k for k, name in enumerate(self.names)}
        own = [tuple(sorted(place[name] for name in group if name in place)) for group in groups]
        self.groups = sorted(group for group in own if len(group) > 1)
        self._apart = {*apart}
        self._shared: SharedWays | None = None
        for group in self.groups:
            self._check(group)

    def __bool__(self) -> bool:
        return bool(self.groups)

    @property
    def trucks(self) -> list[int]:
        """All of them."""
        return sorted(itertools.chain(*self.groups))

    def whole_instance(self) -> Instance:
        """Return the problem with all pairs of these trucks, also those that would save nothing.

        Returns
        -------
        Instance
            The same trucks.
        """
        return self._paired(list(range(self.instance.trucks)), self.trucks)

    def platoons(self) -> list[Group]:
        """Return the ways of each group.

        Returns
        -------
        list of Group
            In the order of `groups`; what one saves may be below 0.

        Raises
        ------
        ScenarioError
            No stretch is in the windows of all of a group.
        """
        found = []
        for group in self.groups:
            driven = self.ways(group)
            instance = self._ways_shared().instance
            own = [self.trucks.index(k) for k in group]
            platoon = group_of(instance, Windows(instance), own, *driven)
            if platoon is None:
                raise self._impossible(group)
            found.append(replace(platoon, trucks=group))
        return found

    def ways(self, group: Sequence[int], others: Others = NOBODY) -> Ways:
        """Return the cheapest ways of a group against what others do.

        Parameters
        ----------
        group : sequence of int
            One of `groups`.
        others : mapping of int to mapping of int to int
            How many others enter a lane at an instant, by lane and instant.

        Returns
        -------
        Ways
            Of each truck of it.

        Raises
        ------
        ScenarioError
            No stretch is in the windows of all of it.
        """
        place = {k: own for own, k in enumerate(self.trucks)}
        found = self._ways_shared().of(
            [place[k] for k in group], whole=self._is_alike(group), others=others
        )
        if found is None:
            raise self._impossible(group)
        return found

    def _ways_shared(self) -> SharedWays:
        if self._shared is None:
            if self.instance.waiting:
                raise ScenarioError(
                    "fleet: vehicles that must drive together are planned with free waiting; give "
                    "waiting no price"
                )
            trucks = self.trucks
            self._shared = SharedWays(self._paired(trucks, range(len(trucks))))
        return self._shared

    def _impossible(self, group: Sequence[int]) -> ScenarioError:
        return ScenarioError(
            f"fleet: {self._named(group)} must drive together, and no stretch is in the windows of "
            "all; widen them"
        )

    def answered(self, search: FleetSearch, from_nothing: bool = False) -> None:
        """Let each group respond to what all others do in a search, if that costs less.

        Parameters
        ----------
        search : FleetSearch
            With some ways of all groups.
        from_nothing : bool
            Whether the groups drive nowhere yet.
        """
        lanes, departs = search.best.ways()
        others: dict[int, Counter[int]] = defaultdict(Counter)
        for own, at in zip(lanes, departs, strict=True):
            _counted(others, own, at, 1)
        fixed = {k: (lanes[k], departs[k]) for k in self.trucks}
        for group in self.groups:
            for k in group:
                _counted(others, *fixed[k], -1)
            ways = zip(group, *self.ways(group, others), strict=True)
            changed = fixed | {k: (way, at) for k, way, at in ways}
            if search.refix(changed, always=from_nothing):
                fixed = changed
            for k in group:
                _counted(others, *fixed[k], 1)

    def drive(self, platoon: Group, group: Sequence[int]) -> bool:
        """Tell whether trucks drive together in some platoon as they must.

        Parameters
        ----------
        platoon : Group
            Of one platoon a trip, where it drives as one.
        group : sequence of int
            One of `groups`.

        Returns
        -------
        bool
            On one stretch, or from start to end.
        """
        if not {*group} <= {*platoon.trucks}:
            return False
        place = [platoon.trucks.index(k) for k in group]
        entries = [
            set(zip(platoon.lanes[i].tolist(), platoon.departs[i].tolist(), strict=True))
            for i in place
        ]
        common = set.intersection(*entries)
        return len(common) == len(entries[0]) if self._is_alike(group) else bool(common)

    def kept(self, ways: Ways) -> Ways:
        """Return a plan in which all drive together that must.

        Parameters
        ----------
        ways : Ways
            A plan with the ways of `platoons`.

        Returns
        -------
        Ways
            The same, or one in which a group leaves some ticks later than others that would have
            parted it.

        Raises
        ------
        ScenarioError
            They are not together.
        """
        lanes, departs = ways
        for group in self._parted(ways):
            windows = self._until(group, lanes)
            slack = min(
                int((until - departs[k]).min()) for k, until in zip(group, windows, strict=True)
            )
            for later in range(1, min(slack, MOST_TICKS) + 1):
                moved = list(departs)
                for k in group:
                    moved[k] = departs[k] + later
                if group not in self._parted((lanes, moved)):
                    departs = moved
                    break
        for group in self._parted((lanes, departs)):
            raise ScenarioError(
                f"fleet: {self._named(group)} must drive together, and others part their platoon; "
                "let them keep apart from others or allow larger platoons"
            )
        return lanes, departs

    def _until(self, group: Sequence[int], lanes: Sequence[Ints]) -> Iterator[Ints]:
        """Yield until when each of a group may enter the lanes of its way."""
        instance = self.instance
        for k in group:
            drive = instance.drive[lanes[k]]
            until = instance.latest[k] - np.cumsum(drive[::-1])[::-1]
            until[0] = min(until[0], instance.latest_departure[k])
            yield until

    def _parted(self, ways: Ways) -> list[tuple[int, ...]]:
        """Return the groups that do not drive together as they must."""
        companies = companies_of(self.instance, *ways)
        found = []
        for group in self.groups:
            with_all = [{*group} <= {*company} for company in companies[group[0]]]
            if not (all(with_all) if self._is_alike(group) else any(with_all)):
                found.append(group)
        return found

    def _is_alike(self, group: Sequence[int]) -> bool:
        """Tell whether a group has one origin and one destination."""
        ends = {(int(self.instance.origin[k]), int(self.instance.destination[k])) for k in group}
        return len(ends) == 1

    def _check(self, group: Sequence[int]) -> None:
        largest = self.instance.largest
        if largest and len(group) > largest:
            raise ScenarioError(
                f"fleet: {self._named(group)} must drive together, and a platoon has at most "
                f"{largest}; allow larger platoons"
            )
        if len(np.unique(self.instance.kind[list(group)])) > 1:
            raise ScenarioError(
                f"fleet: {self._named(group)} must drive together, but are not of one kind of "
                "vehicle and one carrier; take them out"
            )
        both = next((p for p in itertools.combinations(group, 2) if p in self._apart), None)
        if both is not None:
            raise ScenarioError(
                f"fleet: {self._named(both)} must drive together and must not; take them out of "
                "one of both"
            )

    def _named(self, group: Sequence[int]) -> str:
        shown = ", ".join(repr(self.names[k]) for k in group[:SHOWN])
        return shown if len(group) <= SHOWN else f"{shown} and {len(group) - SHOWN} more"

    def _paired(self, trucks: Sequence[int], whole: Sequence[int]) -> Instance:
        """Return the problem of some trucks, of which some keep all their pairs."""
        own, instance = np.array(trucks, np.int64), self.instance
        wanted = Wanted(
            origin=instance.origin[own], destination=instance.destination[own],
            earliest=instance.earliest[own], latest_departure=instance.latest_departure[own],
            latest=instance.latest[own], alone=[self._model.routes[k] for k in trucks],
        )  # fmt: skip
        lanes = replace(self._model.lanes, kind=instance.kind[own])
        return paired(
            lanes, wanted, given=instance.given, largest=instance.largest,
            waiting=instance.waiting, whole=whole,
        )[0]  # fmt: skip


def _counted(others: dict[int, Counter[int]], lanes: Ints, departs: Ints, by: int) -> None:
    """Count a truck's entries, or no longer."""
    for lane, at in zip(lanes.tolist(), departs.tolist(), strict=True):
        others[lane][at] += by
        if not others[lane][at]:
            del others[lane][at]
