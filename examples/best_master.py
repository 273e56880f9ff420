"""Who should lead? Four trucks to the south of Italy, by the paper's rule and by the best.

Run it with

    python examples/best_master.py [page.html]
"""

import sys

import platoon_osm as po


def main(page=None):
    """Plan with the longest route in front, with the best master, and with company anywhere."""
    net = po.load_network("italy-motorways")
    costs = po.paper_weights(net, tau=1.0, xi=0.18)
    trips = [
        po.Trip("Milano", "Milano", "Napoli"),
        po.Trip("Torino", "Torino", "Napoli"),
        po.Trip("Venezia", "Venezia", "Salerno"),
        po.Trip("Brescia", "Brescia", "Roma"),
    ]
    for label, rule in (
        ("the longest route leads (the paper)", {"master": "longest", "company": "master"}),
        ("the longest leads, company anywhere", {"master": "longest"}),
        ("the best master", {}),
        ("the best master, at most two together", {"max_platoon": 2}),
    ):
        plan = po.plan_joint(net, costs, trips, "C", **rule)
        print(f"{plan.saving:6.1%}  {label}")
    best = po.plan_joint(net, costs, trips, "C")
    print()
    print(best.summary())
    if page:
        po.write_html(best, net, page, title="To the south, led by the best")
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
