"""What eq. 11 and 12 may add up: factors by hand, and the planner run for each reading."""

import numpy as np
import pytest

import platoon_osm as po
from platoon_osm.costs.paper import PaperCosts
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.cases import plan_members
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.study.comparison import compare
from platoon_osm.study.measures import Measures
from platoon_osm.study.monte_carlo import run_study
from platoon_osm.study.one_run import plan_draw
from platoon_osm.study.random_network import RandomNetwork
from platoon_osm.study.readings import (
    ALL_TERMS,
    TERM_SUMS,
    Reading,
    alone_per_metre,
    check_terms,
    factors_of,
)
from platoon_osm.study.settings import Study
from platoon_osm.study.shown_tables import shown_tables

REST = 1 / 12
ALONE = {"distance": 1.0, "time": 1 + REST, "fuel": 1.0}


def together(term, mixing, tau, xi):
    """What a metre of one term costs in a platoon, by hand."""
    if term == "distance":
        return 1.0
    if mixing == "printed":
        return tau if term == "time" else xi * 0.82
    return 1 + (1 - tau) * REST if term == "time" else 1 - xi


@pytest.mark.parametrize("mixing", ["printed", "gain"])
def test_factors_by_hand(mixing):
    points = np.array([(0.0, 0.0), (0.3, 1.0), (1.0, 0.18), (1.0, 1.0)])
    readings = [Reading(terms, mixing) for terms in TERM_SUMS]
    found = factors_of(PaperCosts(), readings, points)
    assert found.scale[0] == 1
    assert (np.diff(found.different) > 0).all()
    for x, reading in enumerate(readings):
        chosen = reading.terms.split("+")
        alone = sum(ALONE[term] for term in chosen)
        assert alone_per_metre(PaperCosts(), reading.terms) == pytest.approx(alone)
        assert found.scale[x] == pytest.approx(alone / (37 / 12))
        for p, (tau, xi) in enumerate(points):
            platoon = sum(together(term, mixing, tau, xi) for term in chosen)
            assert found.different[found.at[x, p]] * found.scale[x] == pytest.approx(platoon)


def test_all_terms_are_the_costs_themselves():
    study = Study(terms=(ALL_TERMS, "time"))
    factors = study.factors()
    for x, reading in enumerate(study.readings[:2]):
        for p, (tau, xi) in enumerate(study.grid_points()):
            costs = PaperCosts(tau=tau, xi=xi, mixing=reading.mixing)
            assert factors.different[factors.at[x, p]] == pytest.approx(costs.platoon_factor())
    assert study.alone_factor == pytest.approx(PaperCosts().solo_factor())


@pytest.mark.parametrize("terms", TERM_SUMS[1:])
@pytest.mark.parametrize("mixing", ["printed", "gain"])
def test_other_terms_are_the_planner_run_point_by_point(terms, mixing):
    study = Study(
        network=RandomNetwork(spawn_diameter_m=3e5, spawning="nodes", min_route_m=4e5),
        mixings=(mixing,), terms=(ALL_TERMS, terms), tau=(0.0, 0.3), xi=(0.18, 1.0), points=(),
    )  # fmt: skip
    factors, joined = study.factors(), 0
    for seed in range(2):
        draw = study.network.draw(np.random.default_rng(seed))
        found = plan_draw(study, factors, draw)
        master = int(found["master"])
        others = np.delete(np.arange(10), master)
        for p, (tau, xi) in enumerate(study.grid_points()):
            parts = terms.split("+")
            alone = draw.net.length_m * sum(ALONE[term] for term in parts)
            shared = draw.net.length_m * sum(together(term, mixing, tau, xi) for term in parts)
            weights = EdgeWeights(alone, shared, shared, "m", {})
            route = (
                ReferenceEngine(draw.net, weights.solo)
                .tree(int(draw.origins[master]))
                .path(int(draw.destinations[master]))
            )
            plans = plan_members(
                draw.net, weights, route, draw.origins[others], draw.destinations[others], "C",
                engine="reference",
            )  # fmt: skip
            at = factors.at[1, p]
            cost = found["joint_cost"][0, others, at] * factors.scale[1]
            assert cost == pytest.approx(plans.cost, rel=1e-12)
            assert found["merge"][0, others, at].tolist() == plans.merge.tolist()
            assert found["separation"][0, others, at].tolist() == plans.separation.tolist()
            joined += (plans.merge >= 0).sum()
    assert joined > 0


@pytest.fixture(scope="module")
def result():
    study = Study(
        network=po.RandomNetwork(spawn_diameter_m=3e5, vehicles=5), runs=4, tau=(0.0, 1.0),
        xi=(0.0, 1.0), methods=("dijkstra", "astar", "astar-closed-once"), terms=TERM_SUMS,
    )  # fmt: skip
    return run_study(study, seed=1)


def test_a_reading_is_the_study_of_its_terms_alone(result):
    readings = result.study.readings
    for terms in ("time", "distance+fuel"):
        alone = run_study(
            Study(
                network=result.study.network, runs=4, tau=(0.0, 1.0), xi=(0.0, 1.0),
                methods=result.study.methods, terms=(terms,),
            ),
            seed=1,
        )  # fmt: skip
        for mixing in ("printed", "gain"):
            x, own = (
                readings.index(Reading(terms, mixing)),
                alone.study.readings.index(Reading(terms, mixing)),
            )
            for k in range(3):
                assert result.joint(k, x) == pytest.approx(alone.joint(k, own), rel=1e-9)
                assert result.solo(k, x) == pytest.approx(alone.solo(k, own), rel=1e-9)
                assert (result.of("merge", k, x) == alone.of("merge", k, own)).all()


def test_distance_by_itself_saves_nothing(result):
    for x, reading in enumerate(result.study.readings):
        saved = Measures(result, 0, x).saving("system")[0]
        assert (np.abs(saved) < 1e-12).all() == (reading.terms == "distance")


def test_every_reading_has_its_rows_and_its_lines(result):
    rows = compare([result])
    keys = {(r.terms, r.mixing, r.method) for r in rows}
    assert len(keys) == len(TERM_SUMS) * 2 * 3
    tables = shown_tables([result], rows)
    # Two of savings, involvement, costs, two of terms, two of draws; all methods side by side.
    assert len(tables) == 2 + 1 + 1 + 2 + 2
    for table in (*tables[:3], tables[-1]):
        groups = {group for group, _ in table.heads}
        assert {"A*, nodes opened again", "A*, each node once"} <= groups
    sums, ranges = tables[-4:-2]
    assert [line[0] for line in ranges.rows] == [terms.replace("+", " + ") for terms in TERM_SUMS]
    assert len(sums.rows) == len(TERM_SUMS) * 2
    for table in tables:
        assert all(len(line) == len(table.header) for line in table.rows)
        assert not any("-0.0" in cell for line in table.rows for cell in line)


@pytest.mark.parametrize(
    "terms", [(), "time", ("time", "time"), ("speed",), ("fuel+time",), ("time+time",), (None,), 3]
)
def test_what_is_no_sum_of_terms_is_refused(terms):
    with pytest.raises(ScenarioError, match="terms = ") as caught:
        Study(terms=terms)
    assert "\n" not in str(caught.value)


def test_a_sum_that_is_not_in_the_comparison_is_one_too():
    check_terms("time+fuel")
    assert alone_per_metre(PaperCosts(), "time+fuel") == pytest.approx(2 + REST)
