"""Where the members of one master merge and separate: a table, with a row for each member."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

__all__ = ["MemberPlans"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]
Marks = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class MemberPlans:
    """The best merging and separation points of N members on one master route, (N,) each.

    Attributes
    ----------
    merge, separation : ndarray of int, (N,)
        Nodes; -1 for a member that stays alone.
    merge_index, separation_index : ndarray of int, (N,)
        Positions of those nodes on the route; -1 likewise.
    cost, solo_cost : ndarray of float, (N,)
        Of the member as planned, and alone.
    applicable : ndarray of bool, (N,)
        Whether the case can apply at all (A: the destination lies on the route; B: the origin
        does).
    """

    merge: Index
    separation: Index
    merge_index: Index
    separation_index: Index
    cost: Floats
    solo_cost: Floats
    applicable: Marks

    @classmethod
    def at(
        cls, nodes: Index, i: Index, j: Index, cost: Floats, solo: Floats, applicable: Marks
    ) -> MemberPlans:
        """Return plans by positions on the route.

        Parameters
        ----------
        nodes : ndarray of int, (K + 1,)
            Of the route.
        i, j : ndarray of int, (N,)
            Where members merge and separate; -1 for one that stays alone.
        cost, solo : ndarray of float, (N,)
            What they pay as planned, and alone.
        applicable : ndarray of bool, (N,)
            Whether the case can apply.

        Returns
        -------
        MemberPlans
            With the nodes of these positions.
        """
        joined = i >= 0
        merge, separation = (np.where(joined, nodes[at], -1) for at in (i, j))
        return cls(merge, separation, i, j, cost, solo, applicable)

    @classmethod
    def apart(cls, solo: Floats) -> MemberPlans:
        """Return the plans of members whose master drives no road that they could share.

        Parameters
        ----------
        solo : ndarray of float, (N,)
            What they pay alone.

        Returns
        -------
        MemberPlans
            All stay alone.
        """
        nowhere = np.full(len(solo), -1, np.int64)
        return cls(nowhere, nowhere, nowhere, nowhere, solo, solo, np.ones(len(solo), bool))

    @classmethod
    def together(cls, parts: Sequence[MemberPlans], rows: Sequence[Index]) -> MemberPlans:
        """Return the plans of several groups of members as one table.

        Parameters
        ----------
        parts : sequence of MemberPlans
            Those of each group.
        rows : sequence of ndarray of int
            In which rows of the table each group stands.

        Returns
        -------
        MemberPlans
            With a row for every member.
        """
        back = np.argsort(np.concatenate(rows))
        return cls(*(np.concatenate([getattr(one, name) for one in parts])[back] for name in NAMES))

    def with_row(self, row: int, turn: MemberPlans) -> MemberPlans:
        """Return the same with another plan for one member.

        Parameters
        ----------
        row : int
            The member's.
        turn : MemberPlans
            Of that member alone.

        Returns
        -------
        MemberPlans
            A table of its own.
        """
        columns = [getattr(self, name).copy() for name in NAMES]
        for name, column in zip(NAMES, columns, strict=True):
            column[row] = getattr(turn, name)[0]
        return MemberPlans(*columns)

    def covered(self, edges: int) -> Marks:
        """Mark the edges of the route that each member drives with the master.

        Parameters
        ----------
        edges : int
            How many the route has.

        Returns
        -------
        ndarray of bool, (N, K)
            None for a member that stays alone.
        """
        at = np.arange(edges)
        marked: Marks = (at >= self.merge_index[:, None]) & (at < self.separation_index[:, None])
        return marked


NAMES = tuple(item.name for item in fields(MemberPlans))
