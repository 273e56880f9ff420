"""What `plan_joint` does, step by step, from the parts it is made of.

Each part can be used, replaced or looked at by itself. Run it with

    python examples/plan_from_parts.py [page.html]
"""

import sys
from dataclasses import replace

import platoon_osm as po
from platoon_osm.planning.answers import improved, of_star
from platoon_osm.planning.best import best_answer
from platoon_osm.planning.company.platoons import platoons_of
from platoon_osm.planning.ends import located, resolve_trips
from platoon_osm.planning.fleet_of import fleet_of
from platoon_osm.planning.place_remarks import with_place_remarks
from platoon_osm.planning.places import placed
from platoon_osm.planning.problem import Problem
from platoon_osm.planning.question import Question
from platoon_osm.planning.reasons import reasons_alone
from platoon_osm.planning.road_closures import closed_roads
from platoon_osm.planning.tight_limits import tight_limits
from platoon_osm.planning.timing.bans import with_hours
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.planning.writing import written_plan
from platoon_osm.search.trees import Trees


def plan_from_parts(problem):
    """Return the best plan of a problem, and what each master would cost."""
    # 1. Where the trips start and end. For a place between two junctions, or beside the road, the
    #    network is cut and gets a node there.
    locations = located(problem.net, problem.trips)
    places = placed(problem.net, locations)
    net = places.net

    # 2. What every edge costs each vehicle, alone and in a platoon, and which it may not drive: the
    #    objective says the one, the vehicle and the map the other.
    fleet = fleet_of(problem, places, closed_roads(problem.net, problem.close))
    problem = replace(problem, net=net)

    # 3. One engine for the weight alone, kept with the network, and the searches of this plan, each
    #    of which is made once; these vehicles are alike, so they share them.
    engine = net.attached(po.Searches).under(fleet.alone(0), expected=20)
    trees = Trees(engine)
    shared = [trees] * len(fleet)

    # 4. From places to nodes: of all carriageways and ramps near a place the pair that suits.
    ends = resolve_trips(net, fleet, shared, problem.trips, places.ends)

    # 5. Routes alone, what it costs to join each of them, and how far company may move anybody.
    question = Question(problem, fleet, tuple(ends), shared)

    # 6. Every vehicle as master: where members merge and separate, then whoever drives side by side
    #    elsewhere, then each in turn around the others.
    for master in range(len(ends)):
        star = question.star(master)
        choices = [star.choose(case, problem.optimum) for case in ("A", "B", "C")]
        answer = of_star(question, star, sorted(choices, key=lambda choice: choice.cost))
        if answer is not None:
            after = improved(question, answer)
            name = ends[master].vehicle
            print(f"{name} as master: {answer.cost / 1e3:,.0f}, improved {after.cost / 1e3:,.0f}")

    # 7. The cheapest of them, and what is proved about it; `best_answer` does step 6 by itself.
    best = best_answer(question)
    answer = best.answer

    # 8. Write it down: who drives what with whom becomes stretches and ways, each with its shares.
    runs = answer.draft.runs()
    plan = written_plan(
        problem, fleet, ends, question.alone, runs,
        platoons_of(runs, answer.master, answer.case), reasons_alone(question, answer),
        answer.case, best.proof,
    )  # fmt: skip
    plan = replace(plan, masters=best.masters, remarks=(*best.remarks, *plan.remarks))
    plan = with_place_remarks(plan, net, locations)

    # 9. When everyone drives, if a trip names a time, and what hours and bans make of that; of a
    #    plan without times, what they leave open. Then limits that are passed with little room.
    vehicles = [problem.vehicle_of(trip) for trip in problem.trips]
    patience_s = problem.patience_min * 60
    plan = with_times(plan, problem.trips, patience_s)
    plan = with_hours(plan, net, problem.trips, vehicles, patience_s)
    plan = replace(plan, remarks=(*plan.remarks, *tight_limits(plan, net, vehicles)))
    return plan, engine, trees


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
