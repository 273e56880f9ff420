"""How far trucks must drive together for a detour, or a wait, to pay.

First in closed form, by what each place in a platoon saves and by the price of fuel. Then on the
map: two trucks that share a part of their ways at no detour, one of which has to wait for the
other, a little longer each time. They drive together as long as the closed form says that it pays.
Run it with

    python examples/break_even.py [folder]

and find a figure in the folder.
"""

import sys
from datetime import datetime, timedelta
from pathlib import Path

import platoon_osm as po

SIX = datetime(2026, 3, 3, 6)
SAVINGS = ("eddi", "nacfe", "nrel")
FUEL_PRICES = (1.0, 1.3, 1.6)


def main(folder=None):
    """Print the table and what plans do; draw the lines if a folder is named."""
    costs = {
        f"{name}, {price:.2f} EUR/l": po.money_costs("eu", fuel_per_l=price, positions=name)
        for name in SAVINGS
        for price in FUEL_PRICES
    }
    found = po.break_even({**costs, "paper": po.PaperCosts()}, optimum="system")
    print("Two trucks of 40 t at 80 km/h: km together that pay, counting what both save")
    print(f"{'':18} for 1 km of detour  for 1 min of waiting")
    for row in found.table:
        print(f"{row.name:18} {row.km_per_detour_km:19.1f} {row.km_per_waiting_min:21.1f}")

    net = po.load_network("italy-motorways")
    prices = po.money_costs("eu", positions="nacfe")
    row = po.break_even(prices, optimum="system").table[0]
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    plan = po.plan_joint(net, prices, trips)
    shared = next(one for one in plan.stretches if len(one.vehicles) > 1).length_m / 1000
    pays_min = shared / row.km_per_waiting_min
    print(f"\nA and B share {shared:.0f} km; that pays for {pays_min:.1f} min of waiting")
    # When each comes to the merging point if it leaves at six and waits for nobody.
    comes = [plan.stretches[way[0]].drive_s for way in plan.ways]
    for minutes in range(0, 21, 4):
        leaves = SIX + timedelta(seconds=comes[1] - comes[0], minutes=minutes)
        timed = [
            po.Trip("A", "Torino", "Trieste", leaves, latest_departure=leaves),
            po.Trip("B", "Genova", "Belluno", SIX, latest_departure=SIX),
        ]
        then = po.plan_joint(net, prices, timed)
        company = any(len(one.vehicles) > 1 for one in then.stretches)
        print(f"  A comes {minutes:2d} min after B: {'together' if company else 'alone'}")
        assert company == (minutes < pays_min)
    print()
    print(plan.summary())
    if folder:
        where = Path(folder)
        where.mkdir(parents=True, exist_ok=True)
        usual = {name: po.money_costs("eu", positions=name) for name in SAVINGS}
        po.write_break_even(po.break_even(usual, optimum="system"), where / "break-even.png")
        print(f"Figure: {where / 'break-even.png'}")


if __name__ == "__main__":
    main(*sys.argv[1:])
