"""A plan as tables of pandas, and the least ways between places."""

import platoon_osm as po

net = po.load_network("italy-motorways")
trips = [po.Trip("Torino", "Torino", "Trieste"), po.Trip("Genova", "Genova", "Belluno")]
plan = po.plan_joint(net, po.PaperCosts(), trips, "C")

# One row for each vehicle; units stand in the names of columns.
vehicles = plan.to_frame("vehicles")
print(vehicles[["vehicle", "role", "length_km", "driving_h", "fuel_l", "saving_share"]])

# One row for each vehicle on each stretch: who saves most a kilometre, and where?
stretches = plan.to_frame("stretches")
stretches["saved_m_eq"] = stretches["alone_cost_m_eq"] - stretches["cost_m_eq"]
print(stretches.groupby(["vehicle", "role"])[["length_km", "saved_m_eq"]].sum())

# As lines for a map, in EPSG:4326.
print(plan.to_geodataframe(net)[["vehicle", "role", "roads", "geometry"]])

# Hours from each place to each, for one truck alone.
print(po.place_table(net, ["Torino", "Genova", "Bologna"], measure="hours").round(1))

print(plan.summary())
