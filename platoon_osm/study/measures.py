"""What the paper prints of a study, as ratios over its runs, with bootstrap intervals."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from .monte_carlo import StudyResult
from .one_run import DRIVES_AFTER, DRIVES_BEFORE, JOINED, MASTER_GOES_ON, MASTER_UNDERWAY
from .settings import Total

__all__ = ["INVOLVEMENTS", "TOTALS", "Estimate", "Involvement", "Measures"]

Floats = NDArray[np.float64]
Involvement = Literal["joined", "merges and separates", "inside the master's route"]

TOTALS: tuple[Total, ...] = ("members", "system")
INVOLVEMENTS: dict[Involvement, int] = {
    "joined": JOINED,
    "merges and separates": JOINED | DRIVES_BEFORE | DRIVES_AFTER,
    "inside the master's route":
        JOINED | DRIVES_BEFORE | DRIVES_AFTER | MASTER_UNDERWAY | MASTER_GOES_ON,
}  # fmt: skip
"""Who counts as taking part: any member that joins; one that drives roads alone both before and
after (access edges are not roads); one that does so while the master is on its way too."""
assert tuple(INVOLVEMENTS) == get_args(Involvement)

RESAMPLES = 2000
COVERED = (2.5, 97.5)


@dataclass(frozen=True, slots=True)
class Estimate:
    """A number with its 95 % bootstrap interval over networks.

    Attributes
    ----------
    value : float
        Of the networks as drawn.
    low, high : float
        The interval's ends.
    """

    value: float
    low: float
    high: float

    def covers(self, value: float) -> bool:
        """Tell whether the interval contains a value.

        Parameters
        ----------
        value : float
            In the same unit.

        Returns
        -------
        bool
            Also at its ends.
        """
        return self.low <= value <= self.high


class Measures:
    """Surfaces and numbers of one method and one reading of a study.

    Parameters
    ----------
    result : StudyResult
        R runs, P points.
    method, reading : int
        Positions in the study's methods and readings.
    """

    def __init__(self, result: StudyResult, method: int, reading: int) -> None:
        self.study = result.study
        runs = len(result.master)
        everyone = np.ones((runs, result.optimum.shape[1]), bool)
        counted = {"members": result.is_member(), "system": everyone}
        alone, joint = result.solo(method, reading), result.joint(method, reading)
        self._alone = {t: (alone * counted[t]).sum(axis=1) for t in TOTALS}
        self._joint = {t: np.einsum("rvp,rv->rp", joint, counted[t]) for t in TOTALS}
        self._count = {t: counted[t].sum(axis=1).astype(np.float64) for t in TOTALS}
        how = result.of("how", method, reading)
        self._taking_part = {
            name: np.einsum(
                "rvp,rv->rp", (how & bits) == bits, counted["members"], dtype=np.float64
            )
            for name, bits in INVOLVEMENTS.items()
        }
        # The same resampled networks for every number, so that they can be compared. The seed is
        # fixed: an interval belongs to the result, not to the hour.
        draws = np.random.default_rng(0).multinomial(runs, np.full(runs, 1 / runs), RESAMPLES)
        self._weights: Floats = np.concatenate([np.ones((1, runs)), draws])
        self._together: dict[Total, Floats] = {}
        rows, columns = self.study.grid_shape
        self._grid = slice(0, rows * columns)

    def _joint_sums(self, total: Total) -> Floats:
        """Return joint costs summed over runs as drawn and resampled: (1 + resamples, P)."""
        if total not in self._together:
            self._together[total] = self._weights @ self._joint[total]
        return self._together[total]

    def _estimate(self, values: Floats) -> Estimate:
        low, high = np.percentile(values[1:], COVERED)
        return Estimate(float(values[0]), float(low), float(high))

    def saving(self, total: Total) -> Floats:
        """Return the share saved over each point.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.

        Returns
        -------
        ndarray of float, (1 + resamples, P)
            As drawn, then resampled.
        """
        saved: Floats = 1 - self._joint_sums(total) / (self._weights @ self._alone[total])[:, None]
        return saved

    def saving_at(self, total: Total, tau: float, xi: float) -> Estimate:
        """Return the share saved at one of the study's points.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.
        tau, xi : float
            The point.

        Returns
        -------
        Estimate
            A share.

        Raises
        ------
        ValueError
            A point the study did not look at.
        """
        at = np.flatnonzero((self.study.grid_points() == (tau, xi)).all(axis=1))
        if not len(at):
            raise ValueError(f"point (tau, xi) = ({tau}, {xi}) is not in the study")
        return self._estimate(self.saving(total)[:, at[0]])

    def mean_saving(self, total: Total) -> Estimate:
        """Return the mean over the grid of the share saved.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.

        Returns
        -------
        Estimate
            A share.
        """
        return self._estimate(self.saving(total)[:, self._grid].mean(axis=1))

    def involvement(self, name: Involvement) -> Floats:
        """Return the share of members taking part at each point.

        Parameters
        ----------
        name : str
            Of `INVOLVEMENTS`: who counts as taking part.

        Returns
        -------
        ndarray of float, (1 + resamples, P)
            As drawn, then resampled.
        """
        part = self._weights @ self._taking_part[name]
        share: Floats = part / (self._weights @ self._count["members"])[:, None]
        return share

    def mean_involvement(self, name: Involvement) -> Estimate:
        """Return the mean over the grid of the share of members taking part.

        Parameters
        ----------
        name : str
            Of `INVOLVEMENTS`: who counts as taking part.

        Returns
        -------
        Estimate
            A share.
        """
        return self._estimate(self.involvement(name)[:, self._grid].mean(axis=1))

    def cost_surfaces(self, total: Total = "system") -> tuple[Floats, Floats]:
        """Return the mean cost of a vehicle alone and jointly at each point.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.

        Returns
        -------
        alone, joint : ndarray of float, (P,)
            In metres; the first is the same everywhere.
        """
        count = self._count[total].sum()
        joint = self._joint[total].sum(axis=0) / count
        return np.full_like(joint, self._alone[total].sum() / count), joint

    def cost_alone(self, total: Total = "system") -> Estimate:
        """Return the mean cost of a vehicle alone.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.

        Returns
        -------
        Estimate
            In metres.
        """
        count = self._weights @ self._count[total]
        return self._estimate((self._weights @ self._alone[total]) / count)

    def joint_range(self, total: Total = "system") -> tuple[Estimate, Estimate]:
        """Return the least and the greatest mean joint cost over the grid.

        Parameters
        ----------
        total : {"members", "system"}
            Whose costs are summed.

        Returns
        -------
        least, greatest : Estimate
            In metres.
        """
        count = (self._weights @ self._count[total])[:, None]
        surface = self._joint_sums(total)[:, self._grid] / count
        return self._estimate(surface.min(axis=1)), self._estimate(surface.max(axis=1))
