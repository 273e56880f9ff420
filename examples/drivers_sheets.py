"""A sheet and a calendar for each driver, and one file with all sheets for the printer.

Run it with

    python examples/drivers_sheets.py

It writes into a folder of its own beside where it is run.
"""

from datetime import datetime, timedelta
from pathlib import Path

import platoon_osm as po

six = datetime.fromisoformat("2026-03-02T06:00+01:00")
net = po.load_network("italy-motorways")
trips = [
    po.Trip("Torino 1", "Torino", "Trieste", six, latest_arrival=six + timedelta(hours=9)),
    po.Trip("Genova 4", "Genova", "Belluno", six, latest_arrival=six + timedelta(hours=9)),
    po.Trip("Milano 2", "Milano", "Bolzano", six, latest_arrival=six + timedelta(hours=8)),
]
plan = po.plan_joint(net, po.paper_weights(net), trips)
print(plan.summary())

folder = Path("sheets")
# Nobody waits for another longer than 20 minutes.
written = po.write_sheets(plan, net, folder, patience_min=20)
written += po.write_sheets(plan, net, folder / "all.html", patience_min=20)
for path in written:
    print(f"Written: {path}")
