"""A run solved by hand, and against the planner it must agree with."""

import numpy as np
import pytest
from hand_made import KM, ramps

from platoon_osm.costs.fatigue import fatigue_heuristic
from platoon_osm.costs.paper import paper_weights
from platoon_osm.planning.cases import plan_members
from platoon_osm.planning.ends import TripEnds
from platoon_osm.planning.fleet import Fleet
from platoon_osm.planning.joint import plan_joint
from platoon_osm.planning.routers import DijkstraRouter
from platoon_osm.planning.star import Star
from platoon_osm.plans.trip import Trip
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.trees import Trees
from platoon_osm.study.one_run import (
    DRIVES_AFTER,
    DRIVES_BEFORE,
    JOINED,
    MASTER_GOES_ON,
    MASTER_UNDERWAY,
    plan_draw,
)
from platoon_osm.study.random_network import RandomNetwork
from platoon_osm.study.settings import Study

W_SOLO = 3 + 1 / 12  # 1 + (1 + 2700 / 32400) + 1
W_PLATOON = 1 + 1 + 0.18 * 0.82  # at tau = 1, xi = 0.18
ALL = JOINED | DRIVES_BEFORE | DRIVES_AFTER | MASTER_UNDERWAY | MASTER_GOES_ON


def plan(draw, **options):
    study = Study(
        **{"tau": (1.0,), "xi": (0.18,), "points": (), "mixings": ("printed",), **options}
    )
    return plan_draw(study, study.factors(), draw)


def test_a_member_that_merges_and_separates_by_hand():
    found = plan(ramps())
    assert found["master"] == 0
    assert found["optimum"] == pytest.approx([300 * KM * W_SOLO, 120 * KM * W_SOLO])
    joint = found["joint_cost"][0, :, 0]
    # The member drives 10 + 10 km alone and 100 km together.
    assert joint[1] == pytest.approx(20 * KM * W_SOLO + 100 * KM * W_PLATOON)
    assert joint[0] == pytest.approx(200 * KM * W_SOLO + 100 * KM * W_PLATOON)
    assert found["platoon_m"][0, :, 0] == pytest.approx([100 * KM, 100 * KM])
    assert found["merge"][0, :, 0].tolist() == [-1, 1]
    assert found["separation"][0, :, 0].tolist() == [-1, 2]
    assert found["how"][0, :, 0].tolist() == [JOINED, ALL]


def test_members_that_start_or_end_with_the_master_by_hand():
    # 0 to 5 starts with the master; 4 to 3 ends with it; 2 to 5 never meets its way.
    found = plan(ramps((0, 0, 4, 2), (3, 5, 3, 5)))
    how = found["how"][0, :, 0].tolist()
    assert how[1] == JOINED | DRIVES_AFTER | MASTER_GOES_ON
    assert how[2] == JOINED | DRIVES_BEFORE | MASTER_UNDERWAY
    assert how[3] == 0
    assert found["joint_cost"][0, 3, 0] == found["optimum"][3]
    # Somebody is with the master all the way.
    assert found["joint_cost"][0, 0, 0] == pytest.approx(300 * KM * W_PLATOON)


def test_case_a_needs_the_destination_on_the_route_and_b_the_origin():
    draw = ramps((0, 0, 4, 4), (3, 5, 3, 5))
    a, b = plan(draw, case="A"), plan(draw, case="B")
    assert a["applicable"][0].tolist() == [True, False, True, False]
    assert (a["merge"][0, :, 0] >= 0).tolist() == [False, False, True, False]
    assert b["applicable"][0].tolist() == [True, True, False, False]
    assert (b["merge"][0, :, 0] >= 0).tolist() == [False, True, False, False]


def test_access_edges_are_not_roads():
    draw = ramps()
    by_road = plan(draw)["how"][0, 1, 0]
    ramp = np.asarray(draw.net.tail == 4)
    on_foot = type(draw)(
        draw.net, draw.origins, draw.destinations, ramp, draw.x_m, draw.y_m
    )  # fmt: skip
    assert by_road & DRIVES_BEFORE
    assert not plan(on_foot)["how"][0, 1, 0] & DRIVES_BEFORE


@pytest.mark.parametrize("case", ["A", "B", "C"])
@pytest.mark.parametrize("mixing", ["printed", "gain"])
def test_the_grid_is_the_planner_run_point_by_point(case, mixing):
    study = Study(
        network=RandomNetwork(spawn_diameter_m=3e5, spawning="nodes", min_route_m=4e5),
        case=case, mixings=(mixing,), tau=(0.0, 0.3, 1.0), xi=(0.0, 0.18, 1.0),
    )  # fmt: skip
    joined = 0
    for seed in range(4):
        draw = study.network.draw(np.random.default_rng(seed))
        factors = study.factors()
        found, at = plan_draw(study, factors, draw), factors.at[0]
        others = np.delete(np.arange(10), int(found["master"]))
        for p, (tau, xi) in enumerate(study.grid_points()):
            weights = paper_weights(draw.net, tau=float(tau), xi=float(xi), mixing=mixing)
            master = int(found["master"])
            route = (
                ReferenceEngine(draw.net, weights.solo)
                .tree(int(draw.origins[master]))
                .path(int(draw.destinations[master]))
            )
            plans = plan_members(
                draw.net, weights, route, draw.origins[others], draw.destinations[others], case,
                engine="reference",
            )  # fmt: skip
            assert found["merge"][0, others, at[p]].tolist() == plans.merge.tolist()
            assert found["separation"][0, others, at[p]].tolist() == plans.separation.tolist()
            assert found["joint_cost"][0, others, at[p]] == pytest.approx(plans.cost, rel=1e-12)
            assert found["applicable"][0, others].tolist() == plans.applicable.tolist()
            joined += (plans.merge >= 0).sum()
    assert joined > 0


def test_a_run_is_the_star_of_its_longest_route_and_a_joint_plan_is_no_dearer():
    study = Study(tau=(1.0,), xi=(0.18,), points=(), mixings=("printed",))
    draw = study.network.draw(np.random.default_rng(11))
    found = plan_draw(study, study.factors(), draw)
    trips = [
        Trip(f"V{k}", int(o), int(g))
        for k, (o, g) in enumerate(zip(draw.origins, draw.destinations, strict=True))
    ]
    weights = paper_weights(draw.net, tau=1.0, xi=0.18)
    ours = found["joint_cost"][0, :, 0]
    router = DijkstraRouter(Trees(ReferenceEngine(draw.net, weights.solo)))
    ends = [
        TripEnds(trip.vehicle, o, g, frozenset([o]), frozenset([g]), "", "")
        for trip, o, g in zip(trips, draw.origins.tolist(), draw.destinations.tolist(), strict=True)
    ]
    fleet = Fleet.alike(draw.net, weights, len(trips))
    star = Star(draw.net, fleet, ends, int(found["master"]), [router] * len(trips))
    choice = star.choose("C", "member")
    assert ours[star.members] == pytest.approx(choice.points.cost, rel=1e-9)
    assert ours.sum() == pytest.approx(choice.cost, rel=1e-9)
    # The planner counts company off the master's route too, and lets others lead.
    for master in ("longest", None):
        whole = plan_joint(draw.net, weights, trips, "C", master=master)
        assert whole.joint_cost <= ours.sum() * (1 + 1e-9)


def test_astar_pairs_are_searched_one_by_one():
    study = Study(tau=(0.2, 1.0), xi=(0.18,), points=(), mixings=("printed",), methods=("astar",))
    draw = study.network.draw(np.random.default_rng(5))
    found = plan_draw(study, study.factors(), draw)
    # Never below the optimum, and the heuristic is far above what remains.
    assert (found["solo_cost"][0] >= found["optimum"] * (1 - 1e-12)).all()
    assert (found["solo_cost"][0] > found["optimum"] * 1.01).any()
    assert np.median(found["overestimate"]) > 10
    joined = found["how"][0] & JOINED > 0
    members = np.arange(10) != int(found["master"])
    better = found["joint_cost"][0] <= found["solo_cost"][0][:, None] * (1 + 1e-9)
    assert better[members].all()
    assert joined[members].any()


def test_the_heuristic_prefers_to_be_far_away():
    km = np.arange(0.0, 1200.0)
    heuristic = fatigue_heuristic(km * KM, 2e6, 110 / 3.6)
    assert heuristic.argmax() == 365
    assert heuristic[1000] < heuristic[0] < heuristic[365]
