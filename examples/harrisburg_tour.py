"""A city tour with a low bridge: trucks go around, a van does not.

Three vehicles go from depot to depot in the east of Harrisburg, Pennsylvania, on roads down to
tertiary ones; the last yards to a depot beside the road are a straight way. South of Rutherford
Milroy Road dives below the tracks. The map tells no height there, nor anywhere, so a copy of it is
made with a sign on that way, and the trucks are planned twice: as if nobody asked for their height,
and as they are.

The sign is made up: no published height of this underpass was found. Its figure, 12 ft 6 in, is
that of a railway bridge some miles to the west, over Front Street in Harrisburg, where trucks get
stuck (City of Harrisburg and PennDOT, August 2022). Do not drive by it. Run it with

    python examples/harrisburg_tour.py [harrisburg.osm.pbf] [page.html]

The extract is data of OpenStreetMap (© OpenStreetMap contributors, ODbL).
"""

import sys
from itertools import groupby
from pathlib import Path
from tempfile import TemporaryDirectory

import platoon_osm as po

EXTRACT = Path(__file__).resolve().parents[2] / "shared/data/osm/harrisburg.osm.pbf"
MAIN = ("motorway", "trunk", "primary", "secondary", "tertiary")
CLASSES = [*MAIN, *(f"{kind}_link" for kind in MAIN)]
MILROY_ROAD = 146079011  # the way of the underpass
SIGN = {"maxheight": "12'6\""}

# Depots made up for the example, beside streets that lead to them.
CHAMBERS_HILL = po.Place((-76.7480, 40.2585), label="Chambers Hill depot")
GRAYSON_ROAD = po.Place((-76.7880, 40.2580), label="Grayson Road depot")
NYES_ROAD = po.Place((-76.7700, 40.3095), label="Nyes Road depot")
UNION_DEPOSIT = po.Place((-76.7510, 40.2925), label="Union Deposit depot")

TRUCK = "us-80k-lb"
ANY_HEIGHT = {"base": TRUCK, "height_m": 2.8, "name": f"{TRUCK}, its height not asked"}


def with_tags(source, target, way, tags):
    """Copy a map, with more tags on one way."""
    import osmium

    with osmium.SimpleWriter(str(target)) as writer:
        for thing in osmium.FileProcessor(str(source)):
            if thing.is_way() and thing.id == way:
                writer.add_way(thing.replace(tags={**dict(thing.tags), **tags}))
            else:
                writer.add(thing)


def tour(truck):
    """Return the trips of two trucks, as given, and a van."""
    return [
        po.Trip("T1", CHAMBERS_HILL, NYES_ROAD, profile=truck),
        po.Trip("T2", GRAYSON_ROAD, NYES_ROAD, profile=truck),
        po.Trip("Van", CHAMBERS_HILL, UNION_DEPOSIT, profile="van-3.5t"),
    ]


def main(extract=EXTRACT, page=None):
    """Plan the tour on a map with the sign, for trucks that heed it and for those that do not."""
    if not Path(extract).exists():
        print(f"Skipped: there is no extract at {extract}; give the path of one as argument.")
        return
    with TemporaryDirectory() as folder:
        signed = Path(folder) / "harrisburg-with-sign.osm.pbf"
        with_tags(extract, signed, MILROY_ROAD, SIGN)
        net = po.load_network(signed, CLASSES)

    plans = {
        title: po.plan_joint(net, po.PaperCosts(), tour(truck))
        for title, truck in (("Heights not asked", ANY_HEIGHT), ("Low bridge avoided", TRUCK))
    }
    for title, plan in plans.items():
        print(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}\n")
        for vehicle in plan.vehicles:
            names = (net.edge_name(edge) for edge in vehicle.edges)
            below = MILROY_ROAD in net.way_id[list(vehicle.edges)]
            way = "takes Milroy Road" if below else "not by Milroy Road"
            print(
                f"{vehicle.vehicle}: {vehicle.length_m / 1000:.1f} km, "
                f"{vehicle.time_s / 60:.0f} min, {way}; "
                f"{', '.join(name for name, _ in groupby(filter(None, names)))}"
            )
    if page:
        po.write_comparison(
            list(plans.values()), net, page, titles=list(plans), title="A low bridge on the tour"
        )
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
