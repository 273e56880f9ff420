"""Plan the trips of a table as a European spreadsheet saves it: semicolons and decimal commas."""

from pathlib import Path

import platoon_osm as po

trips = po.read_trips(Path(__file__).with_name("trips.csv"))  # or .xlsx, .gpkg; sheet="Monday"
for trip in trips:
    print(trip.vehicle, trip.origin, trip.earliest_departure, f"{trip.flexibility_min:g} min more")

net = po.load_network("italy-motorways")
plan = po.plan_joint(net, po.paper_weights(net), trips)
print(plan.summary())
