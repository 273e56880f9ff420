"""The search where each platoon has to save so much: those that save less are kept apart."""

from __future__ import annotations

from ..errors import ScenarioError
from ..plans.convoys import convoys_of
from ..plans.plan import Plan
from .run import FEW_MOVES, FleetRun

__all__ = ["WorthwhileRun"]

REFUSALS = 40
"""How often platoons that save too little are kept apart, and the rest planned again."""

HEATS = (0.2, 0.1, 0.0)
"""Of the rounds of the plan after each refusal."""


class WorthwhileRun(FleetRun):
    """A search for platoons that save enough; its parameters are those of `FleetRun`."""

    def plan(self) -> Plan:
        """Search to the end of the course, refuse what saves too little, and return the plan."""
        ended = self._searched()
        for refusals in range(REFUSALS):
            small = self._too_small(self._finished(ended, write=False))
            if not small:
                return self._finished("refused" if refusals else ended)
            self.apart = self.apart.also(small)
            self.exact = None
            self.search = self._searching()
            self.search.construct(*self._guiding)
            for heat in HEATS:
                self.search.improve(*self._guiding, FEW_MOVES, heat, _whole_round)
        raise ScenarioError(
            "fleet: some platoons save less than min_gain whoever is kept apart; give a smaller one"
        )

    def _too_small(self, plan: Plan) -> list[tuple[int, ...]]:
        """Return who drives in platoons that save too little, but need not drive together."""
        return [
            platoon.vehicles
            for platoon in convoys_of(plan)
            if (platoon.saving or 0.0) < self.limits.min_gain
            and not any({*group} <= {*platoon.vehicles} for group in self.together.groups)
        ]


def _whole_round() -> bool:
    """Let a round be done whole."""
    return False
