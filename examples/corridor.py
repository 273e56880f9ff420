"""Plan a corridor on the bundled map of Italy and write its report: the API in one page."""

from pathlib import Path

import platoon_osm as po

net = po.load_network("italy-motorways")
print(net.report())  # what the loader kept, dropped, capped and defaulted

costs = po.paper_weights(net, tau=1.0, xi=0.18)
trips = [
    po.Trip("A", net.locate("Torino", "origin"), net.locate("Trieste", "destination")),
    po.Trip("B", net.locate("Genova", "origin"), net.locate("Belluno", "destination")),
    po.Trip("C", net.locate((9.03, 45.83), "origin"), net.locate("Brennero", "destination")),
]
plan = po.plan_joint(net, costs, trips, case="best")
print(plan.summary())

for vehicle in plan.members:
    print(
        vehicle.vehicle, vehicle.merge.name, "to", vehicle.separation.name, f"{vehicle.saving:.1%}"
    )

out = Path("out")
out.mkdir(exist_ok=True)
po.write_html(plan, net, out / "corridor.html", title="Torino to Trieste with company")
po.write_geopackage(plan, net, out / "corridor.gpkg")
plan.write_json(out / "corridor.json")
