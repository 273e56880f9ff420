"""Four trucks to Napoli within the law, and what a change of the law would be worth.

Under Regulation (EC) 561/2006 the timetable holds each break at a real service area; its minutes
add up, and an independent checker looks at it. The same journeys are then planned by other rules,
and with a driving clock that slows or stands for those who follow. Run it with

    python examples/legal_day.py
"""

from datetime import datetime, timedelta

import platoon_osm as po
from platoon_osm.plans.standing import rested_s, standing, waited_s

six = datetime.fromisoformat("2026-03-04T06:00+01:00")
net = po.load_network("italy-motorways")
# Torino is more than ten hours away: whoever leaves there drives a part the evening before.
trips = [
    po.Trip("Milano", "Milano", "Napoli", six, latest_arrival=six + timedelta(hours=13)),
    po.Trip("Torino", "Torino", "Napoli", six - timedelta(hours=13),
            latest_arrival=six + timedelta(hours=13)),
    po.Trip("Venezia", "Venezia", "Napoli", six, latest_arrival=six + timedelta(hours=13)),
    po.Trip("Brescia", "Brescia", "Napoli", six, latest_arrival=six + timedelta(hours=13)),
]  # fmt: skip


def planned(rules, relief=0.0):
    """Return the best plan under some rules."""
    return po.plan_joint(net, po.PaperCosts(), trips, rules=rules, task_relief=relief)


def minutes(seconds):
    """Return a time span in whole minutes, as the sums below take it."""
    return f"{round(seconds / 60):>4} min"


def timetable(plan):
    """Yield the day of each truck, line by line, and its sum."""
    clock = plan.timetable.clock
    for times, vehicle in zip(plan.timetable.vehicles, plan.vehicles, strict=True):
        yield f"{times.vehicle}, leaves at {clock.text(times.departure_s)}"
        stands = {pause.before: pause for pause in standing(times)}
        for number, (leg, (begin, end)) in enumerate(zip(vehicle.legs, times.legs, strict=True)):
            if number in stands:
                pause = stands[number]
                what = pause.purposes[0].replace("company", "wait").replace("_", " ")
                where = f" at {pause.place.name}" if pause.place else ""
                yield f"  {clock.text(pause.start_s)} {minutes(pause.duration_s)} {what}{where}"
            company = f" with {', '.join(leg.partners)}" if leg.partners else ""
            yield f"  {clock.text(begin)} {minutes(end - begin)} driving{company}"
        yield f"  {clock.text(times.arrival_s)}          arrives"
        driven = sum(end - begin for begin, end in times.legs)
        parts = (driven, rested_s(times), waited_s(times))
        yield (
            f"  sum: {minutes(parts[0])} driving + {minutes(parts[1])} of breaks and rests + "
            f"{minutes(parts[2])} of waiting = {minutes(times.arrival_s - times.departure_s)}"
        )


plan = planned("eu561")
print(plan.summary())
print(*timetable(plan), sep="\n")
print(f"\nViolations of 561/2006 in this plan: {len(po.inspect_plan(plan))}")
free = planned("none")
for vehicle, _, violation in po.inspect_plan(free, "eu561"):
    print(f"Planned without rules, {vehicle}: {violation.article}: {violation.text}")

# Hours are from door to door, of all four; who may not drive on may have to leave a day earlier.
print("\nrules        relief   saved   breaks and rests      waits     hours   all there")
for rules, relief in (
    ("none", 0.0), ("spread-rest", 0.0), ("eu561", 0.0), ("eu561", 0.5), ("eu561", 1.0),
):  # fmt: skip
    one = plan if (rules, relief) == ("eu561", 0.0) else planned(rules, relief)
    days, clock = one.timetable.vehicles, one.timetable.clock
    hours = sum(times.arrival_s - times.departure_s for times in days) / 3600
    print(
        f"{rules:<12} {relief:>6} {one.saving:>7.1%} {minutes(sum(map(rested_s, days))):>18} "
        f"{minutes(sum(map(waited_s, days))):>10} {hours:>9.1f}   "
        f"{clock.moment(max(times.arrival_s for times in days)):%d %B %H:%M}"
    )
