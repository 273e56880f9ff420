"""What climbs and tolls add to a joint trip over a pass: neither is in the plan's cost yet.

The map is made here: the motorway over the Brenner with heights of some of its junctions, as `ele`
of nodes. Germany and Austria charge by the kilometre, Italy at barriers. Run it with

    python examples/climb_and_toll.py
"""

import tempfile
from pathlib import Path

import numpy as np

import platoon_osm as po
from platoon_osm.costs.climb_fuel import ClimbFuel
from platoon_osm.costs.tolls.charges import route_tolls
from platoon_osm.costs.tolls.table import looked_up
from platoon_osm.network.grades import graded_share

JUNCTIONS = (
    ("Rosenheim", 12.08, 47.83, 460), ("Kufstein", 12.15, 47.58, 490),
    ("Innsbruck", 11.42, 47.25, 580), ("Brenner", 11.505, 47.01, 1370),
    ("Sterzing", 11.44, 46.89, 940), ("Brixen", 11.65, 46.71, None), ("Bozen", 11.33, 46.48, 260),
)  # fmt: skip
"""Name, longitude, latitude and height [m] where the map has it; all of them rounded."""


def write_map(file):
    """Write the motorway as OSM XML, a way from each junction to the next."""
    lines = ['<osm version="0.6">']
    for number, (name, lon, lat, height) in enumerate(JUNCTIONS, 1):
        ele = "" if height is None else f'<tag k="ele" v="{height}"/>'
        lines.append(
            f'<node id="{number}" lon="{lon}" lat="{lat}"><tag k="highway" v="motorway_junction"/>'
            f'<tag k="name" v="{name}"/>{ele}</node>'
        )
    for number in range(1, len(JUNCTIONS)):
        nodes = (number, number + 1, number + 2) if number == 5 else (number, number + 1)
        if number == 6:
            continue  # Brixen lies in the middle of a way, without a height of its own
        toll = '<tag k="toll" v="yes"/>' if number > 3 else ""
        lines.append(
            f'<way id="{number}">{"".join(f"<nd ref={chr(34)}{n}{chr(34)}/>" for n in nodes)}'
            f'<tag k="highway" v="motorway"/><tag k="oneway" v="no"/>{toll}</way>'
        )
    file.write_text("\n".join([*lines, "</osm>"]), encoding="utf-8")


def main():
    """Plan two trucks over the pass and tell what their roads rise and cost."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "brenner.osm"
        write_map(file)
        net = po.load_network(file)
    trips = [po.Trip("A", "Rosenheim", "Bozen"), po.Trip("B", "Innsbruck", "Brixen")]
    plan = po.plan_joint(net, po.PaperCosts(), trips)
    print(plan.summary())
    litres = ClimbFuel().extra_l(net)
    for vehicle in plan.vehicles:
        edges = np.concatenate([leg.edges for leg in vehicle.legs]).astype(int)
        climb, descent = (float(values[edges].sum()) for values in (net.climb_m, net.descent_m))
        share = np.average(graded_share(net)[edges], weights=net.length_m[edges])
        print(
            f"\n{vehicle.vehicle}: {climb:,.0f} m up, {descent:,.0f} m down, known on {share:.0%} "
            f"of the way; {litres[edges].sum():+.1f} l against level road"
        )
        for toll in route_tolls(net, edges):
            known = toll.due_km - toll.unknown_km
            told = [f"{toll.amount:.2f} {toll.currency} for {known:.0f} km"] if known else []
            told += [f"{toll.unknown_km:.0f} km at a rate not known"] if toll.unknown_km else []
            print(f"  {toll.country}: {toll.km:.0f} km, toll {', '.join(told) or 'none'}")
    print(f"\nTable of tolls of {looked_up():%d %B %Y}; each rate has its year and source.")


if __name__ == "__main__":
    main()
