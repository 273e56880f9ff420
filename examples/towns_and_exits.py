"""Towns and exits on a map that names neither: motorways alone, with numbers at their exits.

Run it with

    python examples/towns_and_exits.py
"""

import platoon_osm as po

# A sketch of motorways in the plain of the Po, as an extract without towns would have them.
net = po.RoadNetwork.from_edges(
    [0, 1, 1, 2, 2, 3, 3, 4, 4, 5],
    [1, 0, 2, 1, 3, 2, 4, 3, 5, 4],
    lon=[9.26, 9.48, 9.72, 9.97, 10.29, 10.98],
    lat=[45.41, 45.28, 45.06, 45.16, 45.48, 45.39],
    node_ref=["1", "12A;12B", "4", "7", "", "9"],
    ref=["A 1"] * 4 + ["A 21"] * 4 + ["A 4"] * 2,
    node_id=[101, 102, 103, 104, 105, 106],
)

# A town by any of its names; an exit by road and number, by a number on a sign with two, by an
# OpenStreetMap id, and called as the firm calls it.
trips = [
    po.Trip("A", "Mailand", "Verona"),
    po.Trip("B", "exit 12B", "A 21 exit 7"),
    po.Trip("C", po.Place(osmid=103, label="Depot"), "Brescia"),
]
plan = po.plan_joint(net, po.paper_weights(net), trips, "C", master="A")
print(plan.summary())

# What the plan prints, it finds again.
for vehicle in plan.vehicles:
    for point in (vehicle.merge, vehicle.separation):
        if point is not None:
            print(f"{point.name}: node {net.locate(point.name).node}")

# A name that is several places, and one that is none, say what to do.
for text in ("A 2 exit 4", "Milanno", "Naples"):
    try:
        net.locate(text)
    except po.NetworkError as error:
        print(error)
