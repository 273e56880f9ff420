"""What is an hour of waiting worth? Three trucks to Napoli that all have to leave at six.

Where waiting is free, trucks stand by the road until all are together. An objective with a price of
an hour's waiting, here in km-equivalents, lets only those wait who gain more; under the law it
weighs how long a platoon stands at its breaks. Run it with

    python examples/price_of_waiting.py [folder]

and find a figure in the folder.
"""

import sys
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

import platoon_osm as po

SIX = datetime(2026, 3, 3, 6)
PRICES = (0, 100, 300)
"""Of an hour, in km-equivalents."""


@dataclass(frozen=True)
class PricedTime:
    """The paper's costs, and prices of an hour's waiting and of arriving an hour later than alone.

    Any object with these members is an objective; `delay` may be left out.
    """

    waiting_km_h: float = 0.0
    delay_km_h: float = 0.0
    driving: po.PaperCosts = field(default_factory=po.PaperCosts)
    name = "priced time"
    unit = "m"

    @property
    def params(self):
        """What the record of a plan tells."""
        return {"waiting_km_h": self.waiting_km_h, "delay_km_h": self.delay_km_h}

    def weights(self, net, vehicle=None):
        """Return what driving costs."""
        return self.driving.weights(net, vehicle)

    def waiting(self, seconds):
        """Return what waiting costs [m]."""
        return self.waiting_km_h * 1000 * seconds / 3600

    def delay(self, seconds):
        """Return what it costs to arrive later than alone [m]."""
        return self.delay_km_h * 1000 * seconds / 3600


def main(folder=None):
    """Print what each price leads to, with and without driving rules; draw it if asked."""
    net = po.load_network("italy-motorways")
    starts = ("Milano", "Torino", "Venezia")
    trips = [po.Trip(one, one, "Napoli", SIX, latest_departure=SIX) for one in starts]
    told = {}
    for rules in ("none", "eu561"):
        print(f"{rules}: km-equivalents for an hour of waiting, saving, h standing, last arrival")
        rows = told[rules] = []
        for price in PRICES:
            plan = po.plan_joint(net, PricedTime(price), trips, rules=rules)
            times = plan.timetable
            stands = times.waiting_s / 3600
            last = times.clock.moment(max(one.arrival_s for one in times.vehicles))
            rows.append((price, plan.saving, stands))
            print(f"  {price:4d}  {plan.saving:6.1%}  {stands:5.2f}  {last:%H:%M}")
    print()
    print(plan.summary())
    if folder:
        print(f"Figure: {drawn(told, Path(folder))}")


def drawn(told, folder):
    """Draw saving against the hours that all stand; each point is a price."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.5, 3.4), layout="constrained")
    axes = figure.subplots()
    names = {"none": "without driving rules", "eu561": "under (EC) 561/2006, breaks included"}
    for (rules, rows), marker in zip(told.items(), "os", strict=True):
        axes.plot([row[2] for row in rows], [100 * row[1] for row in rows], marker,
                  label=names[rules])  # fmt: skip
        same = {}
        for price, saving, stands in rows:
            same.setdefault((stands, 100 * saving), []).append(str(price))
        for place, prices in same.items():
            axes.annotate(", ".join(prices), place, (6, 5), textcoords="offset points", fontsize=8)
    axes.set(xlabel="all stand on the road [h]", ylabel="saving [%]")
    axes.margins(x=0.15, y=0.2)
    axes.set_title("By the price of an hour's waiting [km-equivalents]", fontsize=10)
    axes.legend(fontsize=8, frameon=False)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "price-of-waiting.png"
    figure.savefig(path, dpi=150)
    return path


if __name__ == "__main__":
    main(*sys.argv[1:])
