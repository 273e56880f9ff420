"""What the hour is worth: cost against the master's departure, and saving against allowed delay.

A departure curve is piecewise linear in the moment t at which the master leaves, and does not
wait on its way. Its steps are closed intervals that meet: where two of them meet, the cheaper one
counts, for company opens at a moment and closes after one. A step of no length is a moment at
which something opens that another thing closes. Where waiting is free, steps are level.

Under driving rules the master stands for its breaks and rests, and moments are whole seconds: a
step ends a second before the next begins, and the master cannot leave at departures between two
steps that do not meet so. Steps are level.

A frontier tells the largest saving for each delay that every vehicle allows. A wider window allows
all that a narrower one did, so the saving never falls.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError
from .clock import Clock, Offsets
from .row_table import Row, RowTable

__all__ = ["DelayFrontier", "DepartureCurve"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class DepartureCurve(RowTable):
    """What all vehicles pay together if the master leaves at a moment and waits for nobody.

    All moments are departures of the master in seconds from `start`; all arrays are read-only.

    Attributes
    ----------
    master : str
        The vehicle that keeps its route.
    members : tuple of str, (M,)
        All others.
    unit : str
        Of costs, "m" for metre-equivalents.
    solo_cost : float
        What all pay alone.
    start : str
        ISO 8601 moment from which seconds count, as in `Timetable`.
    zone : str
        Name of the zone in which times are shown; empty if it has none.
    offsets : tuple of (float, float)
        From when on [s] clocks go by which offset from UTC [s], if they change.
    begin_s, end_s : ndarray of float, (S,)
        Each step's first and last departure; the end of one is the begin of the next, or under
        driving rules a second before it.
    cost, end_cost : ndarray of float, (S,)
        What all pay together at the begin and at the end of each step, linear between.
    company : ndarray of int, (S,)
        How many members drive with the master.
    joins : tuple of ndarray of float, (M, k, 2)
        For each member the departures, from and to, at which it drives with the master.
    best_s : float
        The earliest departure at which all pay least; under driving rules the earliest of the
        plainest plan of that cost, with few stops.
    best_cost : float
        What they pay then.
    is_exact : bool
        Whether each step is the least cost, under `conditions`; else it can be had, and a lesser
        one may be.
    conditions : tuple of str
        What the curve holds for.
    rules : str
        The driving rules by which the master and its members stand; empty without.
    bound : ndarray of float, (S,), or None
        What no plan of a step under `conditions` undercuts, where the search for it ended before
        all was compared; `cost` in the other steps. None where there is no such step.
    """

    master: str
    members: tuple[str, ...]
    unit: str
    solo_cost: float
    start: str
    zone: str
    offsets: Offsets
    begin_s: Floats
    end_s: Floats
    cost: Floats
    end_cost: Floats
    company: Index
    joins: tuple[Floats, ...]
    best_s: float
    best_cost: float
    is_exact: bool = True
    conditions: tuple[str, ...] = ()
    rules: str = ""
    bound: Floats | None = None

    def __post_init__(self) -> None:
        if self.bound is not None:
            self.bound.flags.writeable = False
        for array in (
            self.begin_s,
            self.end_s,
            self.cost,
            self.end_cost,
            self.company,
            *self.joins,
        ):
            array.flags.writeable = False

    def __len__(self) -> int:
        return len(self.begin_s)

    def __repr__(self) -> str:
        return (
            f"<DepartureCurve of {self.master}: {len(self):,} steps, "
            f"{len(self.members):,} members, saves {self.best_saving:.1%} at best>"
        )

    @property
    def clock(self) -> Clock:
        """What turns seconds into times of day."""
        return Clock.from_text(self.start, self.zone, self.offsets)

    @property
    def best_saving(self) -> float:
        """What is saved at the best departure, as a share of the cost alone."""
        return 1.0 - self.best_cost / self.solo_cost if self.solo_cost else 0.0

    @property
    def best_company(self) -> tuple[str, ...]:
        """The members that drive with the master if it leaves at its best departure, by name."""
        return self.company_at(self.best_s)

    def cost_at(self, departure_s: ArrayLike) -> Floats:
        """Return what all pay together at some departures.

        Parameters
        ----------
        departure_s : array_like of float, (k,)
            Seconds from the start.

        Returns
        -------
        ndarray of float, (k,)
            Costs; inf at departures that no step holds, such as those that the master forbids.
        """
        moments = np.atleast_1d(np.asarray(departure_s, np.float64))
        found = np.full(len(moments), np.inf)
        for place, at in enumerate(moments.tolist()):
            first = int(np.searchsorted(self.end_s, at, "left"))
            last = int(np.searchsorted(self.begin_s, at, "right"))
            for step in range(first, last):
                found[place] = min(found[place], self._on(step, at))
        return found

    def _on(self, step: int, at: float) -> float:
        begin, end = float(self.begin_s[step]), float(self.end_s[step])
        low, high = float(self.cost[step]), float(self.end_cost[step])
        return low if end <= begin or high == low else (
            low + (high - low) * (at - begin) / (end - begin)
        )  # fmt: skip

    def company_at(self, departure_s: float) -> tuple[str, ...]:
        """Return who drives with the master at a departure.

        Parameters
        ----------
        departure_s : float
            Seconds from the start.

        Returns
        -------
        tuple of str
            Names, in the order of `members`.
        """
        return tuple(
            name
            for name, spans in zip(self.members, self.joins, strict=True)
            if ((spans[:, 0] <= departure_s) & (departure_s <= spans[:, 1])).any()
        )

    def rows(self) -> Iterator[Row]:
        """Yield what is known of each step.

        Yields
        ------
        dict
            Moments in ISO 8601 and in seconds, costs, the share saved, and how many join.
        """
        clock = self.clock
        unit = "m_eq" if self.unit == "m" else self.unit
        for step in range(len(self)):
            begin, end = float(self.begin_s[step]), float(self.end_s[step])
            cost, last = float(self.cost[step]), float(self.end_cost[step])
            yield {
                "begin": clock.moment(begin).isoformat(),
                "end": clock.moment(end).isoformat(),
                "begin_s": begin,
                "end_s": end,
                f"cost_{unit}": cost,
                f"end_cost_{unit}": last,
                **({} if self.bound is None else {f"bound_{unit}": float(self.bound[step])}),
                "saving_share": 1.0 - min(cost, last) / self.solo_cost if self.solo_cost else 0.0,
                "company": int(self.company[step]),
            }


@dataclass(frozen=True, slots=True, eq=False)
class DelayFrontier(RowTable):
    """What can be saved if every vehicle may arrive so much later than alone.

    Attributes
    ----------
    vehicles : tuple of str, (N,)
        All of them.
    unit : str
        Of costs, "m" for metre-equivalents.
    solo_cost : float
        What all pay alone.
    delay_min : ndarray of float, (D,)
        How much later than alone, leaving at once, each vehicle may arrive [min]; ascending.
    cost : ndarray of float, (D,)
        What all pay together; it never rises.
    bound : ndarray of float, (D,)
        What no plan under `conditions` undercuts; `cost` itself where it is proved optimal.
    master : tuple of str, (D,)
        Who leads; empty where everyone drives alone.
    company : ndarray of int, (D,)
        How many vehicles drive with the master.
    conditions : tuple of str
        What the bounds hold for.
    rules : str
        The driving rules by which all stand, alone too; empty without.
    """

    vehicles: tuple[str, ...]
    unit: str
    solo_cost: float
    delay_min: Floats
    cost: Floats
    bound: Floats
    master: tuple[str, ...]
    company: Index
    conditions: tuple[str, ...] = ()
    rules: str = ""

    def __post_init__(self) -> None:
        for array in (self.delay_min, self.cost, self.bound, self.company):
            array.flags.writeable = False
        if (np.diff(self.cost) > 0).any() or (np.diff(self.delay_min) <= 0).any():
            raise ScenarioError("frontier: delays must rise and costs must not; work it out again")

    def __len__(self) -> int:
        return len(self.delay_min)

    def __repr__(self) -> str:
        most = f"{self.saving_share[-1]:.1%}" if len(self) else "nothing"
        return f"<DelayFrontier of {len(self.vehicles):,} vehicles: saves {most} at most>"

    @property
    def saving(self) -> Floats:
        """What is saved for each delay, in the unit of costs, (D,)."""
        found: Floats = self.solo_cost - self.cost
        return found

    @property
    def saving_share(self) -> Floats:
        """Share of the cost alone that is saved for each delay, (D,)."""
        return self.saving / self.solo_cost if self.solo_cost else np.zeros(len(self))

    @property
    def gap(self) -> Floats:
        """How much more could be saved at most, as a share of that most, (D,)."""
        most = self.solo_cost - self.bound
        return np.where(most > 0, (self.cost - self.bound) / np.where(most > 0, most, 1.0), 0.0)

    def rows(self) -> Iterator[Row]:
        """Yield what is known of each delay.

        Yields
        ------
        dict
            Delay, cost, bound, the share saved, who leads and how many join.
        """
        unit = "m_eq" if self.unit == "m" else self.unit
        saved, gap = self.saving_share, self.gap
        for at in range(len(self)):
            yield {
                "delay_min": float(self.delay_min[at]),
                f"cost_{unit}": float(self.cost[at]),
                f"bound_{unit}": float(self.bound[at]),
                "saving_share": float(saved[at]),
                "gap_share": float(gap[at]),
                "master": self.master[at],
                "company": int(self.company[at]),
            }
