"""All runs of a study, on one core or many, from the start or from where it stopped."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from .one_run import run_once
from .parts import load_part, part_path, save_part
from .settings import Study
from .workers import stopped

__all__ = ["StudyResult", "run_study"]

Floats = NDArray[np.float64]
Arrays = dict[str, NDArray[np.generic]]

CHUNK = 5
"""Runs that go to a worker together."""


@dataclass(frozen=True, slots=True, eq=False)
class StudyResult:
    """R runs of a study: M methods, V vehicles, F different factors of its readings and points.

    Costs are in units of the study's first choice of terms; `joint` and `solo` give those of a
    reading.

    Attributes
    ----------
    study : Study
        What was run.
    seed : int
        Of all draws.
    master : ndarray of int, (R,)
        Which vehicle.
    optimum : ndarray of float, (R, V)
        Cost alone by Dijkstra [m].
    solo_cost : ndarray of float, (R, M, V)
        Cost alone by each method [m].
    joint_cost, platoon_m : ndarray of float, (R, M, V, F)
        Cost [m] and metres in company; the master's cost with what it saves there.
    merge, separation : ndarray of int, (R, M, V, F)
        Nodes, -1 alone.
    how : ndarray of uint8, (R, M, V, F)
        Bits of `one_run`: joined, drives alone before and after, and so on.
    applicable : ndarray of bool, (R, M, V)
        Whether the case could apply.
    redraws : ndarray of int, (R, 2)
        Draws thrown away: not connected, and without destinations far enough.
    overestimate : ndarray of float, (R, V)
        The A* heuristic at the origin over the true remaining cost.
    """

    study: Study
    seed: int
    master: NDArray[np.int32]
    optimum: Floats
    solo_cost: Floats
    joint_cost: Floats
    platoon_m: Floats
    merge: NDArray[np.int32]
    separation: NDArray[np.int32]
    how: NDArray[np.uint8]
    applicable: NDArray[np.bool_]
    redraws: NDArray[np.int32]
    overestimate: Floats

    def is_member(self) -> NDArray[np.bool_]:
        """Mark the vehicles that are not the master of their run.

        Returns
        -------
        ndarray of bool, (R, V)
            False for the master alone.
        """
        vehicles = np.arange(self.optimum.shape[1])
        return np.asarray(vehicles != self.master[:, None])

    def solo(self, method: int, reading: int) -> Floats:
        """Return what vehicles pay alone under a reading.

        Parameters
        ----------
        method, reading : int
            Positions in the study's methods and readings.

        Returns
        -------
        ndarray of float, (R, V)
            In metres.
        """
        cost: Floats = self.solo_cost[:, method] * self.study.factors().scale[reading]
        return cost

    def joint(self, method: int, reading: int) -> Floats:
        """Return what vehicles pay under a reading at each point.

        Parameters
        ----------
        method, reading : int
            Positions in the study's methods and readings.

        Returns
        -------
        ndarray of float, (R, V, P)
            In metres.
        """
        scale = self.study.factors().scale[reading]
        cost: Floats = self.of("joint_cost", method, reading) * scale
        return cost

    def of(self, name: str, method: int, reading: int) -> NDArray[Any]:
        """Return an array under a reading at each point.

        Parameters
        ----------
        name : str
            "joint_cost", "platoon_m", "merge", "separation" or "how".
        method, reading : int
            Positions in the study's methods and readings.

        Returns
        -------
        ndarray, (R, V, P)
            Its values; costs in units of the study's first choice of terms.
        """
        values: NDArray[Any] = getattr(self, name)[:, method]
        return values[..., self.study.factors().at[reading]]


def run_study(
    study: Study | None = None,
    seed: int = 0,
    executor: Executor | None = None,
    folder: Path | str | None = None,
    progress: Callable[[int], None] | None = None,
) -> StudyResult:
    """Run a study; the answer depends on `study` and `seed` alone.

    Parameters
    ----------
    study : Study, optional
        By default the paper's, `PAPER_STUDY`.
    seed : int
        Of all draws; run k uses the k-th child of its `SeedSequence`.
    executor : concurrent.futures.Executor, optional
        Any; by default runs follow each other here.
    folder : path-like, optional
        Where finished runs are kept and found again; by default nowhere.
    progress : callable, optional
        Called with the number of runs just finished.

    Returns
    -------
    StudyResult
        All runs, in order.

    Raises
    ------
    ScenarioError
        A seed below 0, or networks that cannot be drawn.
    """
    from .settings import PAPER_STUDY

    study = PAPER_STUDY if study is None else study
    if not isinstance(study, Study):
        raise ScenarioError(f"study: {brief(study)} is no Study; give one, or None for the paper's")
    if isinstance(seed, bool) or not isinstance(seed, int | np.integer) or seed < 0:
        raise ScenarioError(f"seed = {brief(seed)} must be a whole number, 0 or more")
    seeds = np.random.SeedSequence(int(seed)).spawn(study.runs)
    parts = None if folder is None else Path(folder)
    key = study.key(int(seed))
    names = {item.name for item in fields(StudyResult)} - {"study", "seed"}
    done: dict[int, Arrays] = {}
    if parts is not None:
        for run in range(study.runs):
            if (found := load_part(part_path(parts, key, run), names)) is not None:
                done[run] = found
    tell = progress or (lambda _: None)
    if done:
        tell(len(done))
    missing = [run for run in range(study.runs) if run not in done]
    jobs = [
        (study, key, parts, [(run, seeds[run]) for run in missing[at : at + CHUNK]])
        for at in range(0, len(missing), CHUNK)
    ]
    if executor is None:
        for job in jobs:
            done.update(_run_chunk(*job))
            tell(len(job[3]))
    else:
        waiting = [executor.submit(_run_chunk, *job) for job in jobs]
        try:
            for finished in as_completed(waiting):
                chunk = finished.result()
                done.update(chunk)
                tell(len(chunk))
        finally:
            for future in waiting:
                future.cancel()
    # By number, not by time of arrival: the order must not depend on the workers.
    columns = {name: np.stack([done[run][name] for run in range(study.runs)]) for name in done[0]}
    return StudyResult(study, int(seed), **columns)  # type: ignore[arg-type]


def _run_chunk(
    study: Study,
    key: str,
    parts: Path | None,
    runs: Sequence[tuple[int, np.random.SeedSequence]],
) -> list[tuple[int, Arrays]]:
    """Do some runs; at module level, for processes have to find it."""
    factors = study.factors()
    results = []
    for run, seed in runs:
        if stopped():
            break
        arrays = run_once(study, factors, seed)
        if parts is not None:
            save_part(part_path(parts, key, run), arrays)
        results.append((run, arrays))
    return results
