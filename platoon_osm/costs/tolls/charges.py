"""What is due on the edges of a network, and along a route.

Toll is due where the map marks it, and by the kilometre on the roads of a national charge but for
the part that the map says is free (`toll=no`, `toll:hgv=no`). Costs in money have it in them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import ScenarioError, brief
from ...kinds import is_number
from ...network.columns import ROAD_CLASSES
from ...network.making import checked_edges
from ...network.road_network import RoadNetwork, checked_network
from ...vehicles.profile import Vehicle, vehicle_of
from .table import ROADS, Toll, TollKind, toll_of

__all__ = ["CountryToll", "due_m", "route_tolls", "toll_per_m"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

EURO = "EUR"


@dataclass(frozen=True, slots=True)
class CountryToll:
    """Toll of a route in one country.

    Attributes
    ----------
    country : str
        ISO 3166 code as the network has it; empty where it is not known.
    kind : {"distance", "time", "sections", "none", ""}
        How the country charges; empty if the table has no such country.
    km : float
        Of the route there [km].
    due_km : float
        On which toll is due [km].
    unknown_km : float
        Of those, at a rate that is not known [km].
    amount : float
        For the others, in `currency`.
    currency : str
        ISO 4217 code; empty if the country is not known.
    year : int or None
        Of the rate, None without one.
    per_day : float or None
        Price of a day where the charge is for a time and the price is known; not in `amount`.
    """

    country: str
    kind: TollKind | Literal[""]
    km: float
    due_km: float
    unknown_km: float
    amount: float
    currency: str
    year: int | None
    per_day: float | None


def due_m(net: RoadNetwork, vehicle: Vehicle | str | None = None) -> Floats:
    """Return on how much of each edge toll is due for a vehicle.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    vehicle : Vehicle, str or None
        Who drives, or a name of `VEHICLES`; by default `eu-40t`.

    Returns
    -------
    ndarray of float, (m,)
        Metres [m], between 0 and the edge's length.
    """
    due = np.zeros(checked_network(net).m)
    who = vehicle_of(vehicle)
    for toll, edges in _by_country(net):
        length = net.length_m[edges]
        marked = net.toll[edges]
        if toll is not None and toll.kind == "distance":
            if not toll.concerns(who):
                continue  # what is marked there is marked for heavy vehicles
            classes = [ROAD_CLASSES.index(name) for name in ROADS[toll.roads]]
            national = np.isin(net.road_class[edges], classes)
            paid = np.maximum(length - net.toll_free_m[edges], 0.0)
            due[edges] = np.where(marked, length, np.where(national, paid, 0.0))
        else:
            due[edges] = np.where(marked, length, 0.0)
    return due


def toll_per_m(
    net: RoadNetwork,
    vehicle: Vehicle | str | None = None,
    exchange: Mapping[str, float] | None = None,
) -> Floats:
    """Return what a metre of each edge costs in toll.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    vehicle : Vehicle, str or None
        Who drives, or a name of `VEHICLES`; by default `eu-40t`.
    exchange : mapping of str to float, optional
        Units of a currency for a euro, {"DKK": 7.46}; a rate in a currency that is not there is
        not known.

    Returns
    -------
    ndarray of float, (m,)
        Euro per metre, mean over the edge; 0 where no toll is due, NaN where some is due at a rate
        that is not known. Charges for a time are not in it.

    Raises
    ------
    ScenarioError
        A rate of exchange that is none.
    """
    who, euro = vehicle_of(vehicle), _euro(exchange)
    due = due_m(net, who)
    share = np.divide(due, net.length_m, out=np.zeros(net.m), where=net.length_m > 0)
    per_m = np.where(due > 0, np.nan, 0.0)
    for toll, edges in _by_country(net):
        rate = _rate(toll, who)
        if toll is not None and rate is not None and toll.currency in euro:
            per_m[edges] = share[edges] * rate / 1000 / euro[toll.currency]
    return per_m


def route_tolls(
    net: RoadNetwork, edges: ArrayLike, vehicle: Vehicle | str | None = None
) -> tuple[CountryToll, ...]:
    """Return the tolls along a route, country by country.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edges : array_like of int, (k,)
        Edges of the route, in any order; one that is driven twice is there twice.
    vehicle : Vehicle, str or None
        Who drives, or a name of `VEHICLES`; by default `eu-40t`.

    Returns
    -------
    tuple of CountryToll
        In the order in which the route comes to them.
    """
    ids, who = checked_edges(edges, checked_network(net).m), vehicle_of(vehicle)
    due = due_m(net, who)
    codes, first = np.unique(net.country[ids], return_index=True)
    told = []
    for code in codes[np.argsort(first)].tolist():
        own = ids[net.country[ids] == code]
        name = str(net.texts[code])
        toll = toll_of(name)
        rate = _rate(toll, who)
        due_km = float(due[own].sum()) / 1000
        timed = toll is not None and toll.kind == "time" and toll.concerns(who)
        told.append(
            CountryToll(
                country=name,
                kind="" if toll is None else toll.kind,
                km=float(net.length_m[own].sum()) / 1000,
                due_km=due_km,
                unknown_km=due_km if rate is None else 0.0,
                amount=0.0 if rate is None else rate * due_km,
                currency="" if toll is None else toll.currency,
                year=None if toll is None else toll.year,
                per_day=toll.per_day if toll and timed and toll.priced_for(who) else None,
            )
        )
    return tuple(told)


def _rate(toll: Toll | None, vehicle: Vehicle) -> float | None:
    """Return the rate per kilometre for a vehicle; None if it is not known."""
    if toll is None or not toll.priced_for(vehicle):
        return None
    return toll.rate


def _by_country(net: RoadNetwork) -> Iterator[tuple[Toll | None, Index]]:
    for code in np.unique(net.country).tolist():
        yield toll_of(str(net.texts[code])), np.flatnonzero(net.country == code)


def _euro(exchange: Mapping[str, float] | None) -> dict[str, float]:
    rates = dict(exchange or {})
    for currency, rate in rates.items():
        if not (is_number(rate) and 0 < rate < float("inf")):
            raise ScenarioError(
                f"exchange rate of {brief(currency)} is {brief(rate)}; give units for a "
                "euro, above 0"
            )
    return {**rates, EURO: 1.0}
