"""What is the hour worth? Four trucks to the south of Italy, each with a window.

For each departure of the master: what all pay, and who joins it. For each delay that all allow: the
largest saving. Then three trucks to Roma that keep Regulation (EC) 561/2006: when the master leaves
decides where its break falls, and who can share it. Run it with

    python examples/departure_curve.py [folder]

and find the figures in the folder.
"""

import sys
from datetime import datetime, timedelta
from pathlib import Path

import platoon_osm as po

DAY = datetime(2026, 3, 2)


def main(folder=None):
    """Print the curve, the frontier, and the plan; draw them if a folder is named."""
    net = po.load_network("italy-motorways")
    costs = po.paper_weights(net, tau=1.0, xi=0.18)

    def trip(name, origin, destination, leaves_h, slack_h):
        leaves = DAY + timedelta(hours=leaves_h)
        return po.Trip(name, origin, destination, leaves, flexibility_min=60 * slack_h)

    problem = po.Problem(
        net,
        (
            trip("Milano", "Milano", "Napoli", 6, 5),
            trip("Torino", "Torino", "Napoli", 5, 3),
            trip("Venezia", "Venezia", "Salerno", 8, 2),
            trip("Brescia", "Brescia", "Roma", 9, 1),
        ),
        costs,
    )
    curve = po.departure_curve(problem)
    tell(curve)

    frontier = po.delay_frontier(problem, (0, 30, 60, 120, 240, 480))
    print("\ndelay that all allow, and the most that all save")
    for row in frontier.rows():
        leads = f"{row['master']} leads {row['company']}" if row["master"] else "all alone"
        print(f"  {row['delay_min']:4.0f} min  {row['saving_share']:6.1%}  {leads}")

    print()
    print(po.plan_joint(problem).summary())

    to_roma = po.Problem(
        net,
        (
            trip("Milano", "Milano", "Roma", 6, 3),
            trip("Torino", "Torino", "Roma", 5, 2),
            trip("Brescia", "Brescia", "Roma", 7, 1),
        ),
        costs,
    )
    print("\nTo Roma, with breaks and rests under (EC) 561/2006")
    ruled = po.departure_curve(to_roma, "Milano", rules="eu561")
    tell(ruled)
    if folder:
        where = Path(folder)
        where.mkdir(parents=True, exist_ok=True)
        drawn = {"departure-curve": curve, "delay-frontier": frontier, "departure-curve-law": ruled}
        for name, one in drawn.items():
            one.write_csv(where / f"{name}.csv")
            po.write_curve(one, where / f"{name}.png")
        print(f"Figures: {where}")


def tell(curve):
    """Print the steps of a curve that last a minute or more, and the best departure."""
    print(f"{curve.master} leaves from .. to, and all save")
    for step in range(len(curve)):
        if curve.end_s[step] - curve.begin_s[step] < 60:
            continue
        begin, end = (curve.clock.moment(at) for at in (curve.begin_s[step], curve.end_s[step]))
        middle = (curve.begin_s[step] + curve.end_s[step]) / 2
        saved = 1 - curve.cost[step] / curve.solo_cost
        who = ", ".join(curve.company_at(middle)) or "nobody"
        print(f"  {begin:%H:%M} .. {end:%H:%M}  {saved:6.1%}  {who}")
    print(f"best: {curve.clock.moment(curve.best_s):%H:%M}, {curve.best_saving:.1%}")


if __name__ == "__main__":
    main(*sys.argv[1:])
