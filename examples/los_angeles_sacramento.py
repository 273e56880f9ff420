"""Three trucks up California under 49 CFR 395.3: the same planner, other rules.

A driver may drive 11 hours within 14, and needs 30 minutes off driving after 8 hours of it. The
bundled map of California holds no rest areas, so a break is at a junction, and the plan says that
no parking is known there. Run it with

    python examples/los_angeles_sacramento.py
"""

from datetime import datetime, timedelta

import platoon_osm as po

six = datetime.fromisoformat("2026-03-02T06:00-08:00")
net = po.load_network("california-corridor")
driven = {"driven_since_break_h": 2, "driven_today_h": 2, "duty_h": 2}
trips = [
    # Two hours at the wheel already: 6 h are left before a break, and 9 h before a rest.
    po.Trip("Los Angeles", "Los Angeles", "Sacramento", six, driver=driven,
            latest_arrival=six + timedelta(hours=9)),
    po.Trip("San Diego", "San Diego", "Sacramento", six - timedelta(hours=2),
            latest_arrival=six + timedelta(hours=9)),
    po.Trip("Bakersfield", "Bakersfield", "Sacramento", six,
            latest_arrival=six + timedelta(hours=9)),
]  # fmt: skip

plan = po.plan_joint(net, po.PaperCosts(), trips, rules="us395")
print(plan.summary())
pauses = plan.to_frame("pauses")
print(pauses[["vehicle", "purpose", "start", "lasts_min", "at_km", "place_kind"]].to_string())
for rules in ("us395", "eu561"):
    found = po.inspect_plan(plan, rules)
    print(f"\nBy {rules}: {len(found)} violations")
    for vehicle, _, violation in found:
        print(f"  {vehicle}: {violation.article}: {violation.text}")
