"""Who leads when? Four trucks to the south of Italy hand on the lead at junctions.

Run it with

    python examples/rotating_the_lead.py [page.html]
"""

import sys
from datetime import datetime

import platoon_osm as po


def main(page=None):
    """Plan once with the master in front all the way and once with all in turns."""
    net = po.load_network("italy-motorways")
    trips = [
        po.Trip("Milano", "Milano", "Napoli", datetime(2026, 3, 2, 6)),
        po.Trip("Torino", "Torino", "Napoli", datetime(2026, 3, 2, 4)),
        po.Trip("Venezia", "Venezia", "Roma", datetime(2026, 3, 2, 5)),
        po.Trip("Brescia", "Brescia", "Roma", datetime(2026, 3, 2, 5)),
    ]
    costs = po.paper_weights(net, positions="plafosim", fuel_l_per_100km=32)
    plans = {lead: po.plan_joint(net, costs, trips, lead=lead) for lead in ("master", "rotated")}

    print(f"{'fuel saved by':16}{'master leads':>14}{'in turns':>12}{'leads':>10}{'fair':>10}")
    turns = plans["rotated"].rotation
    for k, trip in enumerate(trips):
        own = [plan.vehicles[k] for plan in plans.values()]
        saved = [1 - one.fuel_l / one.alone.fuel_l for one in own]
        led = (turns.led_m[k] / 1000, turns.fair_m[k] / 1000)
        print(f"{trip.vehicle:16}{saved[0]:14.1%}{saved[1]:12.1%}", end="")
        print(f"{led[0]:7.0f} km{led[1]:7.0f} km")
    print()
    frame = plans["rotated"].to_frame("positions")
    frame["start"] = frame["start"].dt.strftime("%H:%M")
    print(frame[frame["company_size"] > 1].drop(columns="end").to_string(index=False))
    print()
    print(plans["rotated"].summary())
    if page:
        po.write_html(plans["rotated"], net, page, title="To the south, in turns")
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
