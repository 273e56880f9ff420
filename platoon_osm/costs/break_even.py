r"""Break-even: how far to drive together for a detour, or for a wait, to pay.

A vehicle that drives alone pays a for a kilometre, and company saves g on each kilometre driven
together. Joining lengthens its way by d km and makes it wait for w minutes at the price p. Whatever
part of the way is driven together, S km of it, joining pays if

.. math:: S g \ge d a + w p,

for all kilometres cost a, those together g less. So a / g kilometres together pay for one of
detour, and p / g for one minute of waiting. If the member decides, g is what it saves itself behind
all others. For all together, g is also what its coming saves the others: what they save on a
kilometre with it, less what they save without. Plans with times weigh waiting against what all
save, whosever cost is least. Roads are taken to be alike, and driven as fast alone as in company.

If arriving later than alone has a price of its own, a minute of waiting costs that as well, and so
does the time that a kilometre of detour takes. Nobody pays it who names no earliest departure, so
it is counted only if asked for.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, get_args, runtime_checkable

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole
from ..vehicles.profile import Vehicle, vehicle_of
from .time_prices import TimePrices

if TYPE_CHECKING:
    import pandas

__all__ = ["BreakEven", "BreakEvenRow", "KilometreCosts", "break_even"]

Side = Literal["member", "system"]

MOST_VEHICLES = 100
"""More in one platoon are a slip of the pen."""


@runtime_checkable
class KilometreCosts(Protocol):
    """What a kilometre costs by place, and what waiting does; such as `PaperCosts`.

    One may have a method `delay` besides, as an `Objective` may.
    """

    @property
    def unit(self) -> str:
        """Unit of all costs."""
        ...

    def per_km(self, vehicle: Vehicle | None, position: int, size: int, speed_kmh: float) -> float:
        """Return what a vehicle pays for a kilometre.

        Parameters
        ----------
        vehicle : Vehicle or None
            Who drives; None for the standard vehicle.
        position : int
            Its place; 0 leads.
        size : int
            Vehicles in the platoon; 1 is alone.
        speed_kmh : float
            Speed [km/h].

        Returns
        -------
        float
            Cost of a kilometre.
        """
        ...

    def waiting(self, seconds: float) -> float:
        """Return what waiting on the road costs.

        Parameters
        ----------
        seconds : float
            How long.

        Returns
        -------
        float
            Its cost, 0 if waiting is free.
        """
        ...


@dataclass(frozen=True, slots=True)
class BreakEvenRow:
    """Break-even under one objective.

    Attributes
    ----------
    name : str
        What the objective is called.
    unit : str
        Of costs.
    alone_per_km : float
        What the joining vehicle pays for a kilometre alone.
    saved_per_km : float
        What each kilometre together saves; below 0 if company costs.
    waiting_per_min : float
        What a minute of waiting costs, its delay included if that was asked for.
    detour_per_km : float
        What a kilometre of detour costs: as alone, its delay included if that was asked for.
    """

    name: str
    unit: str
    alone_per_km: float
    saved_per_km: float
    waiting_per_min: float
    detour_per_km: float

    @property
    def km_per_detour_km(self) -> float:
        """How many kilometres together pay for one of detour; infinite if none do."""
        return self._paid_by(self.detour_per_km)

    @property
    def km_per_waiting_min(self) -> float:
        """How many kilometres together pay for a minute of waiting; infinite if none do."""
        return self._paid_by(self.waiting_per_min)

    def km_together(self, detour_km: float = 0.0, waiting_min: float = 0.0) -> float:
        """Return how many kilometres together pay for a detour and a wait.

        Parameters
        ----------
        detour_km : float
            By how much joining lengthens the way [km].
        waiting_min : float
            How long it makes somebody wait [min].

        Returns
        -------
        float
            Kilometres; infinite if none do.
        """
        return self._paid_by(detour_km * self.detour_per_km + waiting_min * self.waiting_per_min)

    def _paid_by(self, cost: float) -> float:
        if cost <= 0:
            return 0.0
        return cost / self.saved_per_km if self.saved_per_km > 0 else math.inf


@dataclass(frozen=True, slots=True)
class BreakEven:
    """Break-even under several objectives, for one vehicle that joins others of its kind.

    Attributes
    ----------
    table : tuple of BreakEvenRow
        One for each objective, in the order given.
    vehicle : str
        Who drives.
    size : int
        Vehicles together, the one that joins being the last.
    speed_kmh : float
        Speed [km/h].
    optimum : {"member", "system"}
        Whose gain is counted.
    late : bool
        Whether the price of arriving later is counted.
    """

    table: tuple[BreakEvenRow, ...]
    vehicle: str
    size: int
    speed_kmh: float
    optimum: Side
    late: bool

    def rows(self) -> Iterator[dict[str, Any]]:
        """Yield the rows, all with the same columns.

        Yields
        ------
        dict
            Values by the names of columns.
        """
        for row in self.table:
            yield {
                **asdict(row),
                "km_per_detour_km": row.km_per_detour_km,
                "km_per_waiting_min": row.km_per_waiting_min,
            }

    def to_frame(self) -> pandas.DataFrame:
        """Return the rows as a table of pandas.

        Returns
        -------
        pandas.DataFrame
            In the order of `rows`.
        """
        import pandas as pd

        return pd.DataFrame(list(self.rows()))


def break_even(
    costs: KilometreCosts | Mapping[str, KilometreCosts],
    *,
    vehicle: Vehicle | str | None = None,
    size: int = 2,
    speed_kmh: float = 80.0,
    optimum: Side = "member",
    late: bool = False,
) -> BreakEven:
    """Return how many kilometres together pay for a kilometre of detour and a minute of waiting.

    Parameters
    ----------
    costs : KilometreCosts or mapping of str to KilometreCosts
        An objective, or several by what they are to be called.
    vehicle : Vehicle, str or None
        Who drives, or a name of `VEHICLES`; by default `eu-40t`.
    size : int
        Vehicles together, the one that joins being the last of them.
    speed_kmh : float
        Speed alone and in company [km/h].
    optimum : {"member", "system"}
        Whether what the joining vehicle saves is counted, or what all save by its joining.
    late : bool
        Whether the price of arriving later than alone is counted, where an objective has one.

    Returns
    -------
    BreakEven
        A row for each objective.

    Raises
    ------
    ScenarioError
        What cannot be, or costs that have no price of a kilometre.
    """
    who = vehicle_of(vehicle)
    if not (is_whole(size) and 2 <= size <= MOST_VEHICLES):
        raise ScenarioError(f"break-even: size is {brief(size)}; give 2 to {MOST_VEHICLES}")
    if not (is_number(speed_kmh) and 1 <= speed_kmh <= 200):
        raise ScenarioError(f"break-even: speed_kmh is {brief(speed_kmh)}; give 1 to 200 km/h")
    if not isinstance(optimum, str) or optimum not in get_args(Side):
        raise ScenarioError(f"break-even: optimum {brief(optimum)} is unknown; use member, system")
    if isinstance(costs, Mapping):
        given = dict(costs)
    else:
        name = getattr(costs, "name", "")
        given = {name if isinstance(name, str) else "": costs}
    if not given:
        raise ScenarioError("break-even: no costs are given; give an objective or more by name")
    table = tuple(_row(str(name), one, who, size, speed_kmh, optimum, late)
                  for name, one in given.items())  # fmt: skip
    return BreakEven(table, who.name, size, float(speed_kmh), optimum, bool(late))


def _row(
    name: str, costs: KilometreCosts, who: Vehicle, size: int, kmh: float, optimum: Side, late: bool
) -> BreakEvenRow:
    if isinstance(costs, type) or not isinstance(costs, KilometreCosts):
        raise ScenarioError(
            f"break-even: {brief(name)} is a {type(costs).__name__} without `per_km` and "
            "`waiting`; give an objective that has them, such as PaperCosts()"
        )

    def paid(position: int, together: int) -> float:
        cost = costs.per_km(who, position, together, kmh)
        if not (math.isfinite(cost) and cost >= 0):
            raise ScenarioError(
                f"break-even: {brief(name)} has {cost:g} for a kilometre at place {position} of "
                f"{together}; costs must be finite and 0 or more"
            )
        return float(cost)

    alone = paid(0, 1)
    saved = alone - paid(size - 1, size)
    if optimum == "system":
        before, after = (
            sum(alone - paid(place, together) for place in range(size - 1))
            for together in (size - 1, size)
        )
        saved += after - before
    prices = TimePrices.of(costs)
    delay = prices.delay if late else 0.0
    return BreakEvenRow(
        name,
        costs.unit,
        alone_per_km=alone,
        saved_per_km=saved,
        waiting_per_min=60 * (prices.waiting + delay),
        detour_per_km=alone + delay * 3600 / kmh,
    )
