"""The paper's A* by both rules, and what eq. 11 may add up: a small study, and one plan.

The paper opens a node again when a cheaper way to it is found; many programmes do not.
"""

import platoon_osm as po
from platoon_osm.study.measures import Measures

STUDY = po.Study(
    runs=5,
    methods=("dijkstra", "astar", "astar-closed-once"),
    terms=("distance+time+fuel", "distance+time", "time"),
)
result = po.run_study(STUDY, seed=0)
for k, method in enumerate(STUDY.methods):
    above = result.solo_cost[:, k].sum() / result.optimum.sum() - 1
    print(f"{method}: routes alone lie {above:.0%} above the least")
for x, reading in enumerate(STUDY.readings):
    saved = Measures(result, 0, x).saving_at("members", 1.0, 0.18)
    print(f"{reading.terms}, {reading.mixing}: members save {saved.value:.1%}")

net = po.load_network("italy-motorways")
trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
for name in ("astar", "astar-closed-once", "dijkstra"):
    plan = po.plan_joint(net, po.paper_weights(net), trips, "C", method=name)
    print(f"{name}: {plan.joint_cost / 1000:,.0f} km-equivalents")
print(plan.summary())
