"""Trucks that start where they are: on the motorway between two exits, and at a depot beside it.

Run it with

    python examples/places.py [page.html]
"""

import sys

import platoon_osm as po

net = po.load_network("italy-motorways")

trips = [
    po.Trip("A", "Torino", "Trieste"),
    # Parked on the A 4 between Novara Est and Marcallo; it waits there for A.
    po.Trip("Parked", (8.774, 45.472), "Padova Est"),
    # A depot 4 km south of the A 4, which has to drive to the nearest exits first.
    po.Trip("Depot", po.Place((10.27, 45.46), label="Depot Brescia"), (12.05, 45.437)),
]
plan = po.plan_joint(net, po.PaperCosts(tau=1.0, xi=0.18), trips, "C", master="A")
print(plan.summary())

for vehicle in plan.vehicles:
    for leg in vehicle.legs:
        if leg.role == "access":
            print(f"{vehicle.vehicle}: {leg.length_m / 1000:.1f} km by {leg.access_at}")
    if vehicle.origin.edge is not None:
        share = vehicle.origin.share
        print(f"{vehicle.vehicle} starts {share:.0%} along edge {vehicle.origin.edge}")

if len(sys.argv) > 1:
    po.write_html(plan, net, sys.argv[1], title="Places as they are")
