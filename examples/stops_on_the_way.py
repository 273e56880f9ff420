"""Where a truck may stop on its way: rest areas, their spaces, and how far apart they are.

On the bundled map of Italy, from Napoli to the Brenner. Run it with

    python examples/stops_on_the_way.py
"""

import platoon_osm as po

BREAK_AFTER_H = 4.5
"""A driver rests 45 minutes after this much driving at the latest (EC 561/2006, art. 7)."""


def main():
    """Print the stops of a journey, and the last one before the driver must rest."""
    net = po.load_network("italy-motorways")
    plan = po.plan_joint(net, po.PaperCosts(), [po.Trip("A", "Napoli", "Brennero")])
    edges, driven_h = [], []
    hours = 0.0
    for stretch in (plan.stretches[k] for k in plan.ways[0]):
        edges += stretch.edges
        for edge in stretch.edges:
            driven_h.append(hours)
            hours += net.length_m[edge] / net.speed_mps[edge] / 3600

    print(plan.summary())
    print(f"\n{len(net.stops())} stops on the map, these on the way:")
    last = None
    for passed in po.stops_along(net, edges):
        edge = edges[passed.place]
        at_h = driven_h[passed.place] + passed.access.share * (
            net.length_m[edge] / net.speed_mps[edge] / 3600
        )
        spaces = f", {passed.stop.capacity} trucks" if passed.stop.capacity else ""
        print(f"{passed.at_m / 1000:6.0f} km {at_h:5.1f} h  {passed.stop.name}{spaces}")
        if at_h <= BREAK_AFTER_H and "parking" in passed.stop.offers:
            last = passed
    print(f"Rest at {last.stop.name} at the latest, after {last.at_m / 1000:.0f} km.")


if __name__ == "__main__":
    main()
