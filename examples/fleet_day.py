"""A day of a fleet: trips drawn between the towns of the map, planned, and written for dispatchers.

The plan says what it saves and how much more could be saved at most. Run it with

    python examples/fleet_day.py [FOLDER]
"""

import sys
from pathlib import Path

import platoon_osm as po


def main(folder="fleet"):
    """Draw a day, plan it for a few rounds, and write it into a folder."""
    net = po.load_network("italy-motorways")
    trips = po.draw_trips(net, 40, day="peaked", flexibility_min=60, min_km=250, seed=1)
    # Rounds instead of seconds: the plan is then the same on every machine.
    limits = po.Limits(time_s=None, rounds=6, seed=1)
    problem = po.Problem(net, trips, po.FuelCosts(), max_platoon=5)
    plan = po.plan_fleet(problem, limits, write_to=Path(folder) / "fleet.json")
    po.write_fleet_folder(plan, net, folder, sheets=False)
    print(plan.summary())
    print(f"Written: {', '.join(sorted(path.name for path in Path(folder).iterdir()))}")


if __name__ == "__main__":
    main(*sys.argv[1:])
