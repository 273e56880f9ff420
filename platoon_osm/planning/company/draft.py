"""A plan in the making: each vehicle's edges and, edge by edge, the company that drives them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...plans.stretches import Run, runs_along
from ..fleet import Fleet

__all__ = ["NO_CHEAPER", "Company", "Draft", "Order"]

NO_CHEAPER = 1e-9
"""Only what costs less by this share is cheaper, or sums of the same edges would take turns."""

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]
Company = tuple[int, ...]
"""Vehicles that drive an edge together, the leader first, then the others ascending."""


class Order:
    """Who leads a company: the master, else the vehicle with the longest route alone.

    Parameters
    ----------
    lengths_m : ndarray of float, (N,)
        Of the routes alone.
    master : int or None
        The vehicle that leads wherever it is.
    """

    def __init__(self, lengths_m: Floats, master: int | None) -> None:
        ranked = np.lexsort((np.arange(len(lengths_m)), -np.round(lengths_m, 3)))
        self._rank = np.empty(len(lengths_m), np.int64)
        self._rank[ranked] = np.arange(len(lengths_m))
        if master is not None:
            self._rank[master] = -1

    def company(self, vehicles: Iterable[int]) -> Company:
        """Return vehicles in the order in which they drive.

        Parameters
        ----------
        vehicles : iterable of int
            Positions in the plan.

        Returns
        -------
        tuple of int
            The leader, then the others ascending.
        """
        some = sorted(vehicles)
        if len(some) < 2:
            return tuple(some)
        leader = min(some, key=self._rank.__getitem__)
        return (leader, *(one for one in some if one != leader))


@dataclass(frozen=True, slots=True, eq=False)
class Draft:
    """Who drives what with whom.

    Attributes
    ----------
    routes : tuple of ndarray of int, (N, ...)
        Each vehicle's edges in driving order.
    companies : tuple of list of tuple of int, (N, ...)
        The company on each of these edges; all of a company name the same one.
    """

    routes: tuple[Edges, ...]
    companies: tuple[list[Company], ...]

    @classmethod
    def of(cls, runs: Sequence[Sequence[Run]]) -> Draft:
        """Return the draft of some runs.

        Parameters
        ----------
        runs : sequence of sequence of Run, (N, ...)
            Each vehicle's in driving order.

        Returns
        -------
        Draft
            The same, edge by edge.
        """
        return cls(
            tuple(np.array([e for run in own for e in run.edges], np.int64) for own in runs),
            tuple([run.company for run in own for _ in run.edges] for own in runs),
        )

    @classmethod
    def alone(cls, routes: Sequence[Edges]) -> Draft:
        """Return the draft in which everyone drives alone.

        Parameters
        ----------
        routes : sequence of ndarray of int, (N, ...)
            Each vehicle's edges.

        Returns
        -------
        Draft
            Companies of one.
        """
        return cls(tuple(routes), tuple([(k,)] * len(route) for k, route in enumerate(routes)))

    def runs(self) -> list[list[Run]]:
        """Return each vehicle's way, cut where its company changes.

        Returns
        -------
        list of list of Run
            In driving order.
        """
        return [
            runs_along(route, own) for route, own in zip(self.routes, self.companies, strict=True)
        ]

    def costs(self, fleet: Fleet) -> Floats:
        """Return what each vehicle pays.

        Parameters
        ----------
        fleet : Fleet
            What edges cost each.

        Returns
        -------
        ndarray of float, (N,)
            In their unit.
        """
        paid = np.zeros(len(self.routes))
        for index, (route, own) in enumerate(zip(self.routes, self.companies, strict=True)):
            weights = fleet[index]
            table = (weights.solo, weights.master, weights.platoon)
            # 0 alone, 1 in front, 2 behind
            place = np.array([0 if len(c) < 2 else 2 - (c[0] == index) for c in own], np.int64)
            paid[index] = sum(
                float(weight[route[place == kind]].sum()) for kind, weight in enumerate(table)
            )
        return paid

    def on_edges(self) -> dict[int, list[Company]]:
        """Return the companies that drive each edge, each once.

        Returns
        -------
        dict of int to list of tuple of int
            In the order of the vehicles.
        """
        found: dict[int, list[Company]] = {}
        for route, own in zip(self.routes, self.companies, strict=True):
            for edge, company in zip(route.tolist(), own, strict=True):
                there = found.setdefault(edge, [])
                if company not in there:
                    there.append(company)
        return found

    def led(self) -> list[int]:
        """Return how many edges each vehicle drives in front of others.

        Returns
        -------
        list of int, (N,)
            0 for those who follow or drive alone.
        """
        return [
            sum(len(company) > 1 and company[0] == index for company in own)
            for index, own in enumerate(self.companies)
        ]

    @property
    def together(self) -> bool:
        """Whether anybody drives with anybody."""
        return any(len(company) > 1 for own in self.companies for company in own)
