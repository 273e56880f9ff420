"""What other prices of fuel, of the hour and other savings by place would change.

Three trucks that do not leave together: company costs waiting. At each price of fuel they are
planned anew; beside it stands what the plan as asked would cost then. Run it with

    python examples/what_if.py [folder]

and find a table, a figure and a page in the folder.
"""

import sys
from datetime import datetime, timedelta
from pathlib import Path

import platoon_osm as po
from platoon_osm.plans.what_if_lines import what_if_lines

SIX = datetime(2026, 3, 3, 6)


def main(folder=None):
    """Print what changes; write table, figure and page if a folder is named."""
    net = po.load_network("italy-motorways")

    def trip(name, origin, destination, minutes):
        leaves = SIX + timedelta(minutes=minutes)
        return po.Trip(name, origin, destination, leaves, latest_departure=leaves)

    trips = [
        trip("A", "Torino", "Trieste", 0),
        trip("B", "Genova", "Belluno", 35),
        trip("C", "Milano", "Venezia", 100),
    ]
    problem = po.Problem(net, trips, po.money_costs("eu", positions="nacfe"), case="C")
    price = po.what_if(problem, "fuel_per_l", [0.7, 1.3, 1.9, 2.5, 5.0])
    wage = po.what_if(problem, "driver_per_h", [0, 10, 33], plan=price.plan)
    places = po.what_if(problem, "positions", ["eddi", "nacfe", "nrel"], plan=price.plan)
    for found in (price, wage, places):
        print("\n".join(what_if_lines(found)), end="\n\n")
    print(price.plan.summary())
    if folder:
        where = Path(folder)
        where.mkdir(parents=True, exist_ok=True)
        all_three = po.WhatIfs((price, wage, places))
        all_three.write_csv(where / "what-if.csv")
        for name in ("what-if.svg", "what-if.html"):
            po.write_what_if(all_three, where / name)
        print(f"Table, figure and page: {where}")


if __name__ == "__main__":
    main(*sys.argv[1:])
