"""Who leads a plan, and who else was tried, in a sentence."""

from __future__ import annotations

from dataclasses import replace

from plan_kinds import plan_kind

from platoon_osm.plans.leading import leading_text
from platoon_osm.plans.records import MasterTried


def test_who_was_tried_along_two_routes_is_named_once() -> None:
    plan, _ = plan_kind("three vehicles")
    chosen = next(one.master for one in plan.platoons if one.master is not None)
    first, second = (k for k in range(3) if k != chosen)
    cost = plan.joint_cost
    tried = [(chosen, cost), (first, 1.1 * cost), (first, 1.1 * cost), (chosen, 1.2 * cost)]
    saved = f"{1 - 1.1 * cost / plan.solo_cost:.1%}"
    for more, named in (([], "A{}"), ([(second, 1.1 * cost)], "any of A{} and A{}")):
        masters = tuple(MasterTried(who, "C", price) for who, price in [*tried, *more])
        text = leading_text(replace(plan, masters=masters))
        names = [plan.trips[k].vehicle for k in (first, second)]
        shown = named.replace("A{}", "{}").format(*names)
        assert f"; with {shown} in front it would be {saved} saved in all." in text
