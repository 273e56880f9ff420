"""A truck is late: how likely it is still met, how long it is waited for, and what is left.

A truck from Milano and one from Brescia drive south together. Each may be late by some minutes; the
plan tells the chance of their merge, when to give up waiting, and what it saves on average. A
robust plan weighs that in the choice. Run it with

    python examples/late_member.py
"""

from dataclasses import replace
from datetime import datetime

import platoon_osm as po

SIX = datetime(2026, 3, 3, 6)
SPREADS_MIN = (5, 10, 20)


def main():
    """Print chances by the spread of delays, a closed form beside days drawn, and a robust plan."""
    net = po.load_network("italy-motorways")
    costs = po.PaperCosts(tau=1.0, xi=0.18)
    trips = [
        po.Trip("M", "Milano", "Napoli", SIX, flexibility_min=25),
        po.Trip("B", "Brescia", "Roma", SIX, flexibility_min=45),
    ]
    problem = po.Problem(net, trips, costs, delays=po.Delays(10, correlation=0.3))
    print("spread  chance  wait up to  saved, in closed form  on 10,000 days  by the robust plan")
    for spread in SPREADS_MIN:
        asked = replace(problem, delays=po.Delays(spread, correlation=0.3))
        plan, robust = (po.solve(replace(asked, robust=one)) for one in (False, True))
        told = plan.chances
        (merge,) = told.meetings
        print(
            f"{spread:3d} min  {merge.chance:6.1%}  {merge.wait_up_to_s / 60:6.0f} min  "
            f"{told.closed_form_saving / plan.solo_cost:21.2%}  "
            f"{told.expected_saving / plan.solo_cost:14.2%}  "
            f"{robust.chances.expected_saving / plan.solo_cost:18.2%}"
        )
    days = po.simulate_delays(robust, po.Delays(20, correlation=0.3), seed=7)
    shares = zip(robust.trips, days.in_time, strict=True)
    late = ", ".join(f"{trip.vehicle} {share:.0%}" for trip, share in shares)
    print(f"In time with a spread of 20 min, by the last of these plans: {late}")
    print()
    print(po.solve(replace(problem, robust=True)).summary())


if __name__ == "__main__":
    main()
