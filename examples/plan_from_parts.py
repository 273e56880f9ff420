"""What `plan_joint` does, step by step, from the parts it is made of.

Each part can be used, replaced or looked at by itself. Run it with

    python examples/plan_from_parts.py [page.html]
"""

import sys
from dataclasses import replace

import platoon_osm as po
from platoon_osm.costs.placed_weights import placed_weights
from platoon_osm.planning.ends import located, resolve_trips
from platoon_osm.planning.master import longest_route
from platoon_osm.planning.places import placed
from platoon_osm.planning.problem import Problem
from platoon_osm.planning.routers import DijkstraRouter
from platoon_osm.planning.star import Star
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.planning.writing import written_plan
from platoon_osm.plans.proof import Proof
from platoon_osm.plans.records import Platoon
from platoon_osm.search.trees import Trees


def plan_from_parts(problem):
    """Return the best plan of cases A, B and C of a problem."""
    # 1. Where the trips start and end. For a place between two junctions, or beside the road, the
    #    network is cut and gets a node there.
    places = placed(problem.net, located(problem.net, problem.trips))
    net = places.net
    problem = replace(problem, net=net)

    # 2. What every edge costs, alone and in a platoon: the objective says.
    weights = placed_weights(problem.objective, net, "plan")

    # 3. One engine for the solo weight, kept with the network, and the searches of this plan, each
    #    of which is made once.
    engine = net.attached(po.Searches).under(weights.solo, expected=20)
    trees = Trees(engine)

    # 4. From places to nodes: of all carriageways and ramps near a place the pair that suits.
    ends = resolve_trips(net, weights, trees, problem.trips, places.ends)

    # 5. Routes alone, and the master: the longest of them.
    router = DijkstraRouter(trees)
    routes = [router.route(one.origin, one.destination) for one in ends]
    master = longest_route([net.length_m[route].sum() for route in routes])

    # 6. Where members merge with the master and separate from it. The cases share all tables.
    star = Star(net, weights, ends, master, router)
    choices = [star.choose(case, problem.optimum) for case in ("A", "B", "C")]
    best = choices[0]
    for choice in choices[1:]:
        if choice.cost < best.cost * (1 - 1e-9):
            best = choice

    # 7. Write it down: who drives what with whom becomes stretches and ways, each with its shares.
    joined = [star.members[k] for k in (best.points.merge_index >= 0).nonzero()[0]]
    alone = set(range(len(ends))) - {master, *joined}
    name = ends[master].vehicle
    reasons = [
        f"driving alone costs less than any way with {name}" if k in alone else ""
        for k in range(len(ends))
    ]
    conditions = ("waiting at merging points is free", "the master keeps its own route")
    plan = written_plan(
        problem, weights, ends, star.alone, star.routes(best.points),
        [Platoon(tuple(sorted([master, *joined])), master, best.case)], reasons, best.case,
        Proof.of(best.cost, best.bound, conditions),
    )  # fmt: skip

    # 8. When everyone drives, if a trip names a time.
    return with_times(plan, problem.trips), engine, trees


def main(page=None):
    """Plan three trucks across northern Italy, and compare with `plan_joint`."""
    problem = Problem(
        net=po.load_network("italy-motorways"),
        trips=[
            po.Trip("A", "Torino", "Trieste"),
            po.Trip("B", "Genova", "Belluno"),
            po.Trip("C", (9.03, 45.83), "Brennero"),
        ],
        objective=po.PaperCosts(tau=1.0, xi=0.18),
    )
    plan, engine, trees = plan_from_parts(problem)
    print(plan.summary())
    print(f"\n{trees.searches} searches on the {engine.name} engine")
    print(f"the same as plan_joint: {plan == po.plan_joint(problem)}")
    if page:
        po.write_html(plan, problem.net, page, title="A plan from its parts")
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
