"""HiGHS in a process of its own: what it leaks or breaks there harms nobody here.

The process solves one programme after another, and ends with whoever started it, however that ends.
"""

from __future__ import annotations

import math
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from types import ModuleType, TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ..errors import PlatoonError
from .exact import Programme, Ways, programme_of, ways_of
from .instance import Instance
from .instants import MOST_ENTRIES

__all__ = ["Exact", "Solver", "exact_fleet"]

Floats = NDArray[np.float64]

GRACE_S = 5.0
"""How long after its limit an answer is waited for: large programmes take long to read [s]."""

LOOK_S = 0.1
"""How often it is asked whether to give up [s]."""

NODES = 200
"""Nodes of the solver's search where its time is not limited."""

MOST_S = 3600.0
"""Nobody waits longer for these [s]."""

LARGEST_GAIN = 1e4
"""Gains are scaled to at most this, for HiGHS counts tolerances from 1."""

LAST_DIGITS = 1e-9
"""What HiGHS proves holds but for the last digits of its sums."""


@dataclass(frozen=True, slots=True, eq=False)
class Exact:
    """What the exact model tells.

    Attributes
    ----------
    ways : Ways
        The best plan found.
    saving : int
        What it saves [grains].
    bound : int
        What no plan can save more than [grains].
    proved : bool
        Whether no plan saves more than it does.
    """

    ways: Ways
    saving: int
    bound: int
    proved: bool


class Solver:
    """A process that solves programmes; use it as a context."""

    def __init__(self) -> None:
        self._process: Any = None
        self._ours: Connection | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._process, self._ours = None, None

    def solve(
        self,
        programme: Programme,
        time_s: float | None,
        relaxed: bool = False,
        stop: Callable[[], bool] | None = None,
    ) -> tuple[Floats, float, float] | None:
        """Solve a programme.

        Parameters
        ----------
        programme : Programme
            The model.
        time_s : float or None
            For how long [s]; None for `NODES` nodes.
        relaxed : bool
            Whether its linear relaxation is solved instead.
        stop : callable, optional
            Asked now and then whether to give up.

        Returns
        -------
        values : ndarray of float, (c,)
            The best solution.
        value : float
            What it gains [grains].
        bound : float
            What no solution gains more than [grains].

        Raises
        ------
        PlatoonError
            The process ended before its answer.

        Notes
        -----
        None is returned instead of all three if nothing was found in time, or if it was asked to
        give up.
        """
        if self._process is None or not self._process.is_alive():
            self._begin()
        assert self._ours is not None
        self._ours.send((programme, time_s, relaxed))
        until = time.monotonic() + (MOST_S if time_s is None else time_s) + GRACE_S
        ends = stop or _never
        try:
            while not self._ours.poll(LOOK_S):
                if ends() or time.monotonic() > until:
                    self.close()
                    return None
            found = self._ours.recv()
        except (EOFError, OSError) as error:
            self.close()
            raise PlatoonError(
                "fleet: the exact solver ended without an answer; plan without it"
            ) from error
        if isinstance(found, str):
            raise PlatoonError(f"fleet: the exact solver failed ({found}); plan without it")
        return found  # type: ignore[no-any-return]  # what our own process sends

    def _begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._ours, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, os.getpid()), daemon=True)
        # The new process would run the user's script again; it needs none of it.
        script = sys.modules["__main__"]
        sys.modules["__main__"] = ModuleType("__main__")
        try:
            self._process.start()
        finally:
            sys.modules["__main__"] = script
        theirs.close()


def exact_fleet(
    instance: Instance,
    time_s: float | None,
    solver: Solver | None = None,
    most: int = MOST_ENTRIES,
    stop: Callable[[], bool] | None = None,
) -> Exact | None:
    """Solve a fleet's problem by its exact model.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    time_s : float or None
        For how long [s]; None for as many nodes of the search as `NODES`, so that the answer is the
        same on every machine.
    solver : Solver, optional
        One that runs already.
    most : int
        How many entries the model may have.
    stop : callable, optional
        Asked now and then whether to give up.

    Returns
    -------
    Exact or None
        None if the model would be too large, or nothing was found in time.

    Raises
    ------
    PlatoonError
        The solver ended badly, or waiting has a price.
    """
    programme = programme_of(instance, most)
    if programme is None:
        return None
    own = solver or Solver()
    try:
        found = own.solve(programme, time_s, stop=stop)
    finally:
        if solver is None:
            own.close()
    if found is None:
        return None
    values, value, bound = found
    alone = int(instance.alone_cost.sum())
    # The model counts all that is driven: what is saved is against driving alone.
    saving, most = alone + round(value), alone + math.ceil(bound + LAST_DIGITS * alone)
    proved = most - saving <= max(2.0, 10 * LAST_DIGITS * alone)
    return Exact(ways_of(instance, programme, values), saving, max(saving, most), proved)


def _never() -> bool:
    return False


def _serve(pipe: Connection, parent: int) -> None:
    """Solve what comes until nobody asks any more; in the process."""
    # Ctrl-C is for whoever asked, who ends this process when it wants.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_follow, args=(parent,), daemon=True).start()
    # HiGHS greets on standard output, whatever it is told.
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    while True:
        try:
            programme, time_s, relaxed = pipe.recv()
        except (EOFError, KeyboardInterrupt):
            return
        try:
            pipe.send(_solved(programme, time_s, relaxed))
        except Exception as error:
            pipe.send(f"{type(error).__name__}: {error}")


def _follow(parent: int) -> None:
    """End this process when the one that started it has ended."""
    while os.getppid() == parent:
        time.sleep(0.5)
    os._exit(1)


def _solved(
    programme: Programme, time_s: float | None, relaxed: bool
) -> tuple[Floats, float, float] | None:
    import highspy
    from scipy.sparse import csc_array

    scale = LARGEST_GAIN / max(1.0, float(np.abs(programme.gain).max(initial=1)))
    rows, columns = len(programme.low), len(programme.gain)
    matrix = csc_array(
        (programme.value.astype(np.float64), (programme.row, programme.column)),
        shape=(rows, columns),
    )
    model: Any = highspy.HighsLp()
    model.num_col_, model.num_row_ = columns, rows
    model.col_cost_ = -scale * programme.gain
    model.col_lower_, model.col_upper_ = np.zeros(columns), programme.upper
    model.row_lower_, model.row_upper_ = programme.low, programme.high
    model.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    model.a_matrix_.start_, model.a_matrix_.index_ = matrix.indptr, matrix.indices
    model.a_matrix_.value_ = matrix.data
    if not relaxed:
        kinds = (highspy.HighsVarType.kContinuous, highspy.HighsVarType.kInteger)
        model.integrality_ = [kinds[int(whole)] for whole in programme.whole]
    solver: Any = highspy.Highs()  # type: ignore[no-untyped-call]  # it has no types
    solver.setOptionValue("output_flag", False)
    if time_s is None:
        solver.setOptionValue("mip_max_nodes", NODES)
    else:
        solver.setOptionValue("time_limit", float(time_s))
    # One thread, so that the same programme has the same answer.
    solver.setOptionValue("threads", 1)
    solver.setOptionValue("mip_rel_gap", 0.0)
    solver.passModel(model)
    solver.run()
    told = solver.getInfo()
    values = np.array(solver.getSolution().col_value)
    if len(values) != columns or told.primal_solution_status != 2:
        return None
    value = -told.objective_function_value / scale
    bound = value if relaxed else -told.mip_dual_bound / scale
    return values, value, bound
