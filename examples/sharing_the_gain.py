"""Three carriers to the south of Italy: what each saves, what is paid, and why all can say yes.

Who leads saves least, and who makes a detour saves least of all, so savings as planned are uneven.
Three rules say what each is to have in the end. Run it with

    python examples/sharing_the_gain.py
"""

import platoon_osm as po


def main():
    """Share what a plan saves by every rule, and ask all groups what they could do alone."""
    net = po.load_network("italy-motorways")
    trips = [
        po.Trip("Milano", "Milano", "Napoli"),
        po.Trip("Torino", "Torino", "Napoli"),
        po.Trip("Brescia", "Brescia", "Roma"),
    ]
    problem = po.Problem(net, trips, po.MoneyCosts("eu"))
    plan = po.solve(problem)
    for rule in ("equal", "shapley", "least-core"):
        on_road = po.share_gain(plan, problem, rule).gain
        anew = po.share_gain(plan, problem, rule, anew=True).gain
        print(
            f"{rule:<12}{'saves as planned':>18}{'pays':>9}{'receives':>10}{'has in the end':>16}"
        )
        for trip, one in zip(plan.trips, on_road.vehicles, strict=True):
            pays, receives = max(-one.payment_cents, 0), max(one.payment_cents, 0)
            print(
                f"  {trip.vehicle:<10}{euros(one.saved_cents):>18}{euros(pays):>9}"
                f"{euros(receives):>10}{euros(one.share_cents):>16}"
            )
        for gain in (on_road, anew):
            who = "nobody" if gain.nobody_is_worse_off else "somebody"
            print(f"  {gain.coalitions} groups asked, {gain.manner}: {gained(gain.worst_cents)};")
            print(f"  {who} is worse off than alone.")
        print()
    print(plan.summary())


def euros(cents):
    """Return cents as euros."""
    return f"{cents / 100:.2f}" if cents else "-"


def gained(worst):
    """Return in words what a group could gain at most by itself."""
    if worst > 0:
        return f"one could have {euros(worst)} EUR more by itself"
    return f"each would have at least {euros(-worst)} EUR less by itself"


if __name__ == "__main__":
    main()
