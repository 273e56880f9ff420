"""Whole fleets under driving rules: what is saved with breaks and rests in every timetable.

The days of `benchmarks.fleets`, all trucks with one rested driver under eu561. A window is so much
longer than each trip takes alone, without law or within it.

    python -m benchmarks.lawful_fleets            # the table of docs/fleets.md, some minutes
    python -m benchmarks.lawful_fleets IT 30      # one row: place, window in minutes
"""

from __future__ import annotations

import sys

from benchmarks.fleets import LEAST_KM, SAVED, SHARED

TRUCKS = 1000
SECONDS = 60.0
ROWS = (("DE", 30.0), ("DE", 90.0), ("IT", 30.0), ("IT", 90.0))


def row(place: str, window_min: float) -> str:
    """Plan one day without law and within it, and return a row of the table."""
    import platoon_osm as po
    from platoon_osm.fleets.warmth import warm_up
    from platoon_osm.inspection.verdict import inspect_plan

    warm_up(law=True)
    folder = SHARED / place
    net = po.load_network(folder / "graph.graphml")
    trips = po.draw_trips(
        net, TRUCKS, flows=folder / "traffic.csv", flexibility_min=window_min, min_km=LEAST_KM,
        seed=1,
    )  # fmt: skip
    length = net.length_m
    costs = po.EdgeWeights(
        solo=length, platoon=(1 - SAVED) * length, master=length, unit="m", params={}
    )
    limits = po.Limits(time_s=SECONDS, seed=1)
    free, law = (
        po.plan_fleet(po.Problem(net, trips, costs, rules=rules), limits)
        for rules in ("none", "eu561")
    )
    assert free.fleet is not None
    assert law.fleet is not None
    assert law.timetable is not None
    broken = len(inspect_plan(law))
    stand = sum(bool(times.pauses) for times in law.timetable.vehicles)
    return (
        f"| {place} | {window_min:g} | {100 * free.fleet.saved_share:.3f} | "
        f"{100 * law.fleet.saved_share:.3f} | "
        f"{100 * law.fleet.bound / law.fleet.alone_cost:.3f} | {100 * law.fleet.gap:.1f} | "
        f"{stand} | {broken} | {law.fleet.seconds:.0f} |"
    )


def main() -> None:
    """Print one row, or the table."""
    asked = sys.argv[1:]
    rows = [(asked[0], float(asked[1]))] if asked else list(ROWS)
    print(
        "| place | window [min] | saved without law [%] | saved within it [%] | bound [%] | "
        "gap on savings [%] | trucks that stand | rules broken | seconds |\n" + "|---" * 9 + "|"
    )
    for place, window_min in rows:
        print(row(place, window_min), flush=True)


if __name__ == "__main__":
    main()
