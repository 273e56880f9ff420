"""Plans made anew for values of a figure, against plan_joint and against bills added up by hand."""

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from hypothesis import given, settings
from random_networks import problems

import platoon_osm as po
from platoon_osm.planning.kept_plan import KeptPlan
from platoon_osm.plans.paid import paid
from platoon_osm.plans.standing import standing
from platoon_osm.plans.what_if_lines import threshold_text, what_if_lines
from platoon_osm.vehicles.profile import vehicle_of

SIX = datetime(2026, 3, 3, 6)
KMH = 80 / 3.6


def at(minutes):
    """Leave then, and not otherwise."""
    return {"earliest_departure": SIX + timedelta(minutes=minutes)} | {
        "latest_departure": SIX + timedelta(minutes=minutes)
    }


@pytest.fixture(scope="module")
def net():
    """A road 0 to 3 of 300 km; 4 joins it at 1, at 2 one may leave it for 5."""
    return po.RoadNetwork.from_edges(
        [0, 1, 2, 4, 2], [1, 2, 3, 1, 5], [100e3, 150e3, 50e3, 40e3, 30e3], speed_mps=KMH,
        lon=[9.0, 10.0, 11.0, 12.0, 9.5, 11.5], lat=[45.0, 45.0, 45.0, 45.0, 45.4, 45.4],
    )  # fmt: skip


@pytest.fixture(scope="module")
def asked(net):
    trips = [
        po.Trip("A", 0, 3, **at(0)),
        po.Trip("B", 4, 5, **at(38)),
        po.Trip("C", 4, 3, **at(35)),
    ]
    return po.Problem(net, trips, po.money_costs("eu", positions="nacfe"), case="C")


@pytest.fixture(scope="module")
def by_price(asked):
    return po.what_if(asked, "fuel_per_l", [0.2, 1.3, 2.0, 4.0])


def by_hand(plan, net, costs):
    """What all pay as planned, from lengths, the physics and the times of the plan alone."""
    speed, total = np.array([KMH]), 0.0
    tested = costs.consumption.air_share(
        vehicle_of({"mass_t": costs.saving.tested_t}), costs.saving.tested_kmh / 3.6
    )
    for index, way in enumerate(plan.ways):
        for stretch in (plan.stretches[k] for k in way):
            place, size = stretch.vehicles.index(index), len(stretch.vehicles)
            saved = costs.saving.by_position(size)[place] / float(tested) if size > 1 else 0.0
            for edge in stretch.edges:
                litres = float(costs.consumption.litres(
                    net, edges=np.array([edge]), speed_mps=speed, air_saved=saved
                )[0])  # fmt: skip
                hours = net.length_m[edge] / KMH / 3600
                total += litres * costs.fuel_per_l + hours * costs.driver_per_h
                total += litres * costs.to_wheel_kg_per_l / 1000 * costs.co2_per_t
        stands = sum(pause.duration_s for pause in standing(plan.times[index]))
        total += stands / 3600 * costs.waiting_per_h
    return total


@pytest.mark.parametrize(
    ("figure", "values"),
    [
        ("fuel_per_l", [0.3, 2.5]),
        ("driver_per_h", [0.0, 5.0, 50.0]),
        ("positions", ["eddi", "bhoopalam"]),
        ("co2_per_t", [100.0]),
        ("drag", [1.2]),
    ],
)
def test_rows_are_plans_and_the_kept_plan_is_paid_by_hand(net, asked, figure, values):
    found = po.what_if(asked, figure, values)
    kept = po.plan_joint(asked)
    cent = 0.005 * 6 * len(asked.trips) + 1e-9
    for row, value in zip(found.values, values, strict=True):
        more = {figure: value} | ({"positions": "nacfe"} if figure != "positions" else {})
        costs = po.money_costs("eu", **more)
        plan = po.plan_joint(net, costs, asked.trips, "C")
        assert (row.alone, row.joint) == paid(plan)
        assert row.proof == plan.proof
        assert row.platoon_m == plan.platoon_m
        assert row.saved_kg == plan.bill.saved_kg
        assert row.saved_l == pytest.approx(plan.bill.saved_fuel_l)
        assert row.kept == pytest.approx(by_hand(kept, net, costs), abs=cent)
        assert row.worth >= -(plan.joint_cost - plan.proof.any_plan) - cent
        assert row.most_saved >= row.saved


def test_a_kept_plan_with_places_off_the_junctions_costs_what_it_did(net):
    """Places within edges and beside the road, and stretches that end within an edge."""
    trips = [po.Trip("A", (9.4, 45.0), 3), po.Trip("B", 4, (11.61, 45.02)), po.Trip("C", 0, 3)]
    problem = po.Problem(net, trips, po.money_costs("eu", positions="nacfe"))
    plan = po.plan_joint(problem)
    assert any(one.access for one in plan.stretches)
    assert any(one.span != (0, 1) and one.together for one in plan.stretches)
    again = KeptPlan.of(plan, problem).priced(problem, plan)
    assert again.bill == plan.bill


def test_the_wage_takes_waiting_along_only_where_waiting_is_the_hour(net, asked):
    assert po.what_if(asked, "driver_per_h", [0.0]).values[0].saved > 10
    priced = replace(asked, objective=po.money_costs("eu", positions="nacfe", waiting_per_h=70.0))
    row = po.what_if(priced, "driver_per_h", [0.0]).values[0]
    same = po.money_costs("eu", positions="nacfe", waiting_per_h=70.0, driver_per_h=0.0)
    assert (row.alone, row.joint) == paid(po.plan_joint(net, same, asked.trips, "C"))


def test_what_changes_is_told(by_price):
    rows = by_price.values
    assert by_price.asked == 1.3
    assert rows[1].changes == ()
    assert rows[1].worth == 0
    assert [one.text for one in rows[0].changes] == ["B stays alone", "C stays alone"]
    assert rows[0].company == rows[0].leads == ()
    told = [one.text for one in rows[2].changes]
    assert "A drives with B and C" in told
    assert "C separates at road near Rovigo instead of road near Mirandola" in told
    assert rows[3].worth > rows[2].worth > 0


def test_company_begins_to_pay_where_a_plan_of_its_own_says_so(net, asked, by_price):
    found = by_price.threshold
    assert found.from_above
    assert found.above - found.below <= 3.8 / 100
    for value, pays in ((found.below, False), (found.above, True)):
        costs = po.money_costs("eu", positions="nacfe", fuel_per_l=value)
        plan = po.plan_joint(net, costs, asked.trips, "C")
        assert any(one.together for one in plan.stretches) is pays
    assert not found.is_proved
    assert threshold_text(by_price).startswith("Company begins to pay between 0.")
    rough = po.what_if(asked, "fuel_per_l", [0.2, 1.3], tolerance=10)
    assert (rough.threshold.below, rough.threshold.above) == (0.2, 1.3)


def test_company_is_said_to_pay_from_there_on_only_where_that_is_proved(net):
    """A detour: where the hour costs much, nobody makes it for company, which is proved."""
    road = po.RoadNetwork.from_edges(
        [0, 0, 2, 1, 3], [1, 2, 1, 3, 4], [100e3, 50e3, 53e3, 10e3, 10e3], speed_mps=KMH,
        lon=[9.0, 10.0, 9.5, 10.1, 10.2], lat=[45.0, 45.0, 45.4, 45.0, 45.0],
    )  # fmt: skip
    trips = [po.Trip("A", 2, 1), po.Trip("B", 0, 1)]
    costs = po.money_costs("eu", positions="bhoopalam", fuel_per_l=1.0)
    problem = po.Problem(road, trips, costs)
    found = po.what_if(problem, "driver_per_h", [0.0, 1.0, 33.0])
    assert [bool(row.company) for row in found.values] == [True, True, False]
    assert found.values[2].proof.kind == "exact"
    assert found.threshold.is_proved
    assert not found.threshold.from_above
    below, above = found.threshold.below, found.threshold.above
    assert above - below <= 0.33
    assert threshold_text(found) == f"Company pays up to {below:.6g} EUR/h."
    wages = [*np.linspace(0, below, 7), *np.linspace(above, 33, 7)]
    rows = po.what_if(problem, "driver_per_h", wages).values
    assert [bool(row.company) for row in rows] == [True] * 7 + [False] * 7
    names = po.what_if(problem, "positions", ["eddi", "bhoopalam"])
    assert names.threshold is None


def test_less_relief_is_not_compared(net, asked):
    ruled = replace(asked, rules="eu561", task_relief=0.5, trips=asked.trips[1:])
    rows = po.what_if(ruled, "task_relief", [0.0, 1.0]).values
    assert rows[0].kept is None
    assert rows[0].worth is None
    assert "clock slows less" in rows[0].kept_note
    assert rows[1].worth is not None
    for row, relief in zip(rows, (0.0, 1.0), strict=True):
        assert row.joint == paid(po.plan_joint(replace(ruled, task_relief=relief)))[1]


def test_the_papers_weights_can_be_varied_too(net, asked):
    problem = replace(asked, objective=po.PaperCosts())
    found = po.what_if(problem, "xi", [0.0, 0.18, 0.3])
    for row, xi in zip(found.values, (0.0, 0.18, 0.3), strict=True):
        plan = po.plan_joint(net, po.PaperCosts(xi=xi), asked.trips, "C")
        assert row.joint == pytest.approx(plan.joint_cost)
        assert row.kept == pytest.approx(plan.joint_cost)  # nobody drives otherwise
        assert row.saved_kg is None
    assert list(found.to_frame()["saved_to_wheel_kg"]) == ["", "", ""]


def test_the_table_is_narrow_and_tells_everything(by_price, tmp_path):
    lines = what_if_lines(by_price)
    assert max(map(len, lines)) <= 100
    assert sum(line.startswith(("0.2 ", "1.3 ", "2 ", "4 ")) for line in lines) == 4
    by_price.write_csv(tmp_path / "a.csv")
    head, *rows = (tmp_path / "a.csv").read_text().splitlines()
    assert len(rows) == 4
    assert head.startswith("figure,value,figure_unit,alone_EUR,planned_EUR,saved_EUR,")


@pytest.mark.parametrize(
    ("figure", "values", "said"),
    [
        ("fuel", [1.0], "figure 'fuel' is unknown; those of 'eu' are fuel_per_l, driver_per_h"),
        (7, [1.0], "figure 7 is unknown"),
        ("fuel_per_l", [], "no values"),
        ("fuel_per_l", [1.0] * 201, "201 values of fuel_per_l; give 200 at most"),
        ("fuel_per_l", 1.0, "are no list"),
        ("fuel_per_l", "12", "are no list"),
        ("fuel_per_l", [-1.0], "must be a number in"),
        ("fuel_per_l", [float("nan")], "is no value"),
        ("fuel_per_l", ["eddi"], "give a number"),
        ("fuel_per_l", [True], "give a number"),
        ("positions", [1.0], "give a name"),
        ("positions", ["nobody"], "nobody"),
        ("task_relief", [2.0], "give a number from 0 to 1"),
        ("preset", ["us"], "is unknown"),
    ],
)
def test_what_cannot_be_is_refused_before_anything_is_planned(
    asked, figure, values, said, monkeypatch
):
    monkeypatch.setattr("platoon_osm.planning.what_if.solve", None)
    with pytest.raises(po.ScenarioError, match=r"what_if|figure|task_relief") as caught:
        po.what_if(asked, figure, values)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_bare_weights_have_no_figures(net, asked):
    weights = replace(asked, objective=po.paper_weights(net))
    with pytest.raises(po.ScenarioError, match="is unknown"):
        po.what_if(weights, "fuel_per_l", [1.0])
    with pytest.raises(po.ScenarioError, match="is no Problem"):
        po.what_if(net, "fuel_per_l", [1.0])
    with pytest.raises(po.ScenarioError, match="tolerance"):
        po.what_if(asked, "fuel_per_l", [1.0], tolerance=0)


@settings(max_examples=6, deadline=None)
@given(problems(most_trips=3))
def test_a_kept_plan_costs_what_a_new_one_does_where_nothing_changes(problem):
    """Any network: at the value as asked, and never less than what no plan undercuts."""
    net, _, trips = problem
    asked = po.Problem(net, trips, po.money_costs("eu", positions="nacfe"))
    found = po.what_if(asked, "fuel_per_l", [0.1, 1.3, 30.0])
    for row in found.values:
        cent = 0.005 * 6 * len(trips) + 1e-9
        least = row.proof.any_plan if row.proof.any_plan is not None else row.proof.bound
        assert row.worth >= -(row.joint - least) - cent
        if not row.changes:
            assert row.kept == pytest.approx(row.joint, abs=cent)
