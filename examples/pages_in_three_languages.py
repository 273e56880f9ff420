"""One plan told in English, German and Italian, set against other rules, and drawn for print.

Run it with

    python examples/pages_in_three_languages.py

It writes into a folder of its own beside where it is run.
"""

from datetime import datetime, timedelta
from pathlib import Path

import platoon_osm as po

six = datetime.fromisoformat("2026-03-02T06:00+01:00")
net = po.load_network("italy-motorways")
costs = po.paper_weights(net)
trips = [
    po.Trip("Torino 1", "Torino", "Trieste", six, latest_arrival=six + timedelta(hours=9)),
    po.Trip("Genova 4", "Genova", "Belluno", six, latest_arrival=six + timedelta(hours=9)),
    po.Trip("Milano 2", "Milano", "Bolzano", six, latest_arrival=six + timedelta(hours=8)),
]
plan = po.plan_joint(net, costs, trips)
print(plan.summary())

folder = Path("pages")
# Texts, numbers and dates are in the language's form; each page leads to the others.
for page in po.write_pages(plan, net, folder, languages=("en", "de", "it")):
    print(f"Written: {page}")

plans = {
    "The longest leads": po.plan_joint(net, costs, trips, master="longest"),
    "At most two together": po.plan_joint(net, costs, trips, max_platoon=2),
    "The best": plan,
}
comparison = folder / "rules.html"
# Each figure with its difference to the paper's rule.
po.write_comparison(
    list(plans.values()), net, comparison, titles=list(plans), baseline="The longest leads"
)
print(f"Written: {comparison}")

# Among them the time-distance diagram of the platoon.
for path in po.write_figures(plan, net, folder / "figures", language="de"):
    print(f"Written: {path}")
