"""How likely a plan's merges succeed if vehicles run late, and what is left of its saving."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

__all__ = ["Chances", "MeetingChance"]


@dataclass(frozen=True, slots=True)
class MeetingChance:
    """How likely one merge is.

    Attributes
    ----------
    event : int
        The merge, its position in the plan's events.
    chance : float
        Probability that it succeeds.
    mean_s, spread_s : float
        By how much the movers come after the others on average, and the standard deviation [s].
    expected_wait_s : float
        How long the side that is there first waits on average, as long as it waits at most [s].
    window_s : float
        How long it could wait within its own day [s].
    wait_up_to_s : float
        How long it should wait before it gives up [s]; 0 if it should not wait at all.
    gain : float
        What hangs on the merge, in the plan's unit.
    missed_cost : float
        What the mover pays more than planned if it is missed, in the plan's unit.
    movers_wait_up_to_s : float
        How long a mover that is there first should wait for the others [s]; `window_s` and
        `wait_up_to_s` are those of the others, who wait for the movers.
    missed_late_s : float
        How late the mover arrives at its destination if it just misses the others [s].
    """

    event: int
    chance: float
    mean_s: float
    spread_s: float
    expected_wait_s: float
    window_s: float
    wait_up_to_s: float
    gain: float
    missed_cost: float
    movers_wait_up_to_s: float = 0.0
    missed_late_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Chances:
    """How likely the merges of a plan are.

    Attributes
    ----------
    kind : str
        Of the delays: "normal" or "lognormal".
    seed : int or None
        Of the simulation; None without one.
    runs : int
        How many days were simulated.
    meetings : tuple of MeetingChance
        One for each merge.
    planned_saving : float
        What the plan saves if nobody is late, in its unit.
    expected_saving : float
        What it saves on average, counted on the days that were simulated.
    saving_error : float
        Standard error of that.
    closed_form_saving : float or None
        The same in closed form; None where merges depend on each other, and it has none.
    """

    kind: str
    seed: int | None
    runs: int
    meetings: tuple[MeetingChance, ...]
    planned_saving: float
    expected_saving: float
    saving_error: float = 0.0
    closed_form_saving: float | None = None

    def of_event(self, event: int) -> MeetingChance | None:
        """Return how likely a merge is.

        Parameters
        ----------
        event : int
            Its position in the plan's events.

        Returns
        -------
        MeetingChance or None
            None for a separation.
        """
        return next((one for one in self.meetings if one.event == event), None)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Chances:
        """Rebuild it from plain JSON types.

        Parameters
        ----------
        data : mapping
            Its fields by name.

        Returns
        -------
        Chances
            The same.
        """
        return cls(**{**data, "meetings": tuple(MeetingChance(**one) for one in data["meetings"])})
