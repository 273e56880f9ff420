"""Every plan that a test, an example or the command makes goes through the checker as it leaves.

A plan may be late, which it says itself; it may break no rule that it was made by, and it may not
contradict itself. What is proved was compared to the end.
"""

from __future__ import annotations

import functools
import importlib
from typing import Any

__all__ = ["inspect_every_plan"]


def inspect_every_plan() -> None:
    """Have the planner's answers checked from now on, in this process and its forks."""
    # Not as attributes of the package: its front door names functions like modules.
    joint = importlib.import_module("platoon_osm.planning.joint")
    verdict = importlib.import_module("platoon_osm.inspection.verdict")
    solve = joint.solve
    if getattr(solve, "is_inspected", False):
        return

    @functools.wraps(solve)
    def inspected(problem: Any) -> Any:
        plan = solve(problem)
        if plan.timetable is not None:
            found = [one for one in verdict.inspect_plan(plan) if one.violation.article != "window"]
            assert not found, f"a plan breaks what it was made by: {found[:3]}"
        told = " ".join(plan.proof.conditions)
        assert plan.proof.kind != "exact" or "ended before" not in told, told
        return plan

    inspected.is_inspected = True  # type: ignore[attr-defined]
    joint.solve = inspected
