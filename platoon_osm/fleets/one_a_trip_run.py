"""The search where a trip has one platoon at most: the plan at once, then its bound.

The bound is that of all plans, with any number of platoons a trip. With two trucks in a platoon the
plan is proved to be the best (`pairs`); of larger ones it is grown (`growing`), without proof.
"""

from __future__ import annotations

import math

from .exact import Ways
from .exact_told import ExactTold
from .one_platoon import one_platoon
from .run import FleetRun

__all__ = ["OneATripRun"]

ONE_PLATOON = 0.5
"""With one platoon of more than two a trip, the plan is made in this share of the time."""


class OneATripRun(FleetRun):
    """A search for a plan with one platoon a trip; its parameters are those of `FleetRun`."""

    @property
    def cost(self) -> int:
        """What the plan costs [grains]."""
        return self.search.cost if self.exact is None else self.exact.cost

    def _best_ways(self) -> Ways:
        """Return lanes and instants of the plan."""
        return super()._best_ways() if self.exact is None else self.exact.ways

    def _searched(self) -> str:
        """Make the plan, then raise the bound; return why it ended."""
        at, limit = self.course, self.limits.time_s
        ways, saving = one_platoon(
            self.together.whole_instance() if self.together else self.model.instance,
            self.limits.seed,
            math.ceil(self.limits.min_gain * self.model.lanes.grains),
            self.apart.pairs,
            self.together.platoons() if self.together else (),
            self.together.drive,
            stop=at.until(ONE_PLATOON),
            time_s=None if limit is None else ONE_PLATOON * limit,
        )
        cost = self.alone - saving
        proved = self.model.instance.largest == 2 and not self.together
        self.exact = ExactTold(ways, cost, cost if proved else 0)
        self._tell()
        stop = at.until(1.0)
        while not (self._proved or stop() or at.share >= 1.0):
            if self.bound.settled and not self._refined():
                break
            self._raise(stop)
            at.rounds += 1
            self._tell()
        return self._why_ended(1.0)
