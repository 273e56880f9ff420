"""Which roads are open to which vehicle, and what happens if one of them is closed.

On the true extract of California that comes with the package: how much of it is closed to a truck
and to a van, a plan for vehicles that differ, and the same with the Interstate 5 closed near
Coalinga. Run it with

    python examples/roads_for_trucks.py [page.html]
"""

import sys

import platoon_osm as po
from platoon_osm.vehicles.closures import Closures
from platoon_osm.vehicles.profile import VEHICLES

COALINGA = (-120.2415, 36.2508)


def main(page=None):
    """Plan three vehicles up the Central Valley, with and without its main road."""
    net = po.load_network("california-corridor")
    for name in ("us-80k-lb", "van-3.5t"):
        closed = net.attached(Closures).km_by_reason(VEHICLES[name])
        told = ", ".join(f"{reason} {km:,.1f} km" for reason, km in closed.items())
        print(f"{name}: {told or 'everything is open'}")

    trips = [
        po.Trip("A", "San Diego", "Redding"),
        po.Trip("B", "Long Beach", "Sacramento", profile={"base": "us-80k-lb", "height_m": 3.6}),
        po.Trip("C", "San Bernardino", "Oakland", profile="van-3.5t"),
    ]
    plans = {
        title: po.plan_joint(net, po.PaperCosts(), trips, profile="us-80k-lb", close=close)
        for title, close in (("As it is", ()), ("I 5 closed near Coalinga", [COALINGA]))
    }
    for title, plan in plans.items():
        print(f"\n{title}\n{'=' * len(title)}\n{plan.summary()}")
    if page:
        po.write_comparison(
            list(plans.values()), net, page, titles=list(plans), title="What if I 5 were closed?"
        )
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
