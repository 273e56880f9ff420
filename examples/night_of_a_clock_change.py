"""Two trucks through the night in which clocks go back: every time in the offset that holds then.

Writes the plan to a file, and reads it again where no zone is needed.
"""

import json
import tempfile
from datetime import datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import platoon_osm as po

NIGHT = datetime(2026, 10, 25, 0, 30, tzinfo=ZoneInfo("Europe/Rome"))

net = po.load_network("italy-motorways")
trips = [
    po.Trip("A", "Torino", "Trieste", NIGHT),
    po.Trip("B", "Genova", "Belluno", NIGHT.replace(minute=45)),
]
plan = po.plan_joint(net, po.paper_weights(net), trips, "C")
print(plan.summary())

assert plan.timetable is not None
clock = plan.timetable.clock
print("\nAll times are of", clock.zone)
for times in plan.timetable.vehicles:
    driven = (times.arrival_s - times.departure_s) / 3600
    print(
        f"{times.vehicle}: {clock.text(times.departure_s)} to {clock.text(times.arrival_s)}, "
        f"{driven:.2f} h that pass"
    )

with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "plan.json"
    path.write_text(json.dumps(plan.to_dict()), encoding="utf-8")
    again = po.Plan.from_dict(json.loads(path.read_text(encoding="utf-8")))
    assert again.summary() == plan.summary()
