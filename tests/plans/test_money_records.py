"""Bills, shares and chances: sums, both ways through JSON, and what is refused."""

import json
from dataclasses import replace

import pytest

import platoon_osm as po
from platoon_osm.costs.cost_figure import CostFigure
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.bill import Bill, VehicleBill
from platoon_osm.plans.chances import Chances, MeetingChance
from platoon_osm.plans.gain import GainShare, GainSharing
from platoon_osm.plans.plan import Plan

BILL = Bill(
    "EUR",
    ("fuel", "driver"),
    (
        VehicleBill((1000, 500), (970, 510), 10.0, 9.7, (25.0, 32.0), (24.0, 31.0)),
        VehicleBill((1200, 600), (1150, 600), 12.0, 11.5, (31.0, 38.0), (30.0, 36.5)),
        VehicleBill((700, 300), (700, 300), 7.0, 7.0, (18.0, 22.0), (18.0, 22.0)),
    ),
    (CostFigure("fuel_per_l", 1.6, "EUR/l", "somebody, 2026"),),
)
GAIN = GainSharing(
    "equal", "EUR", (GainShare(20, 30), GainShare(50, 35), GainShare(0, 5)), 7, -1.5,
    "planned anew",
)  # fmt: skip


@pytest.fixture(scope="module")
def plan():
    net = RoadNetwork.from_edges(
        [0, 1, 2, 4], [1, 2, 3, 1], [50e3] * 4,
        lon=[9.0, 9.5, 10.0, 10.5, 9.0], lat=[45.0, 45.0, 45.0, 45.0, 45.4],
    )  # fmt: skip
    trips = [po.Trip("A", 0, 3), po.Trip("B", 4, 3), po.Trip("C", 0, 1)]
    return po.plan_joint(net, po.paper_weights(net), trips)


@pytest.fixture(scope="module")
def chances(plan):
    merge = next(k for k, event in enumerate(plan.events) if event.kind == "merge")
    meeting = MeetingChance(merge, 0.8, 60.0, 300.0, 120.0, 1800.0, 1800.0, 12.5, 9.0)
    return Chances("normal", 7, 1000, (meeting,), 20.0, 16.0)


def test_a_bill_adds_up():
    assert BILL.alone_cents == 4300
    assert BILL.joint_cents == 4230
    assert BILL.saved_cents == 70
    assert BILL.of_term("fuel") == (2900, 2820)
    assert sum(BILL.of_term(term)[0] for term in BILL.terms) == BILL.alone_cents
    assert BILL.saved_kg == (2.0, 2.5)
    assert BILL.saved_fuel_l == pytest.approx(0.8)
    assert [one.saved_cents for one in BILL.vehicles] == [20, 50, 0]


def test_what_is_paid_is_received():
    assert [one.payment_cents for one in GAIN.vehicles] == [10, -15, 5]
    assert GAIN.gain_cents == 70
    assert GAIN.nobody_is_worse_off


def test_all_comes_back_from_json(plan, chances):
    full = replace(plan, bill=BILL, gain=GAIN, chances=chances)
    assert Plan.from_dict(json.loads(json.dumps(full.to_dict()))) == full
    assert full.chances.of_event(chances.meetings[0].event) == chances.meetings[0]
    assert full.chances.of_event(99) is None


def test_a_plan_of_version_6_has_none_of_it(plan):
    data = plan.to_dict() | {"plan_version": 6}
    for name in ("bill", "gain", "chances"):
        assert data.pop(name) is None
    assert Plan.from_dict(data) == plan


@pytest.mark.parametrize(
    ("part", "change", "told"),
    [
        ("bill", {"vehicles": BILL.vehicles[:2]}, "bill is that of 2 vehicles"),
        ("bill", {"vehicles": (replace(BILL.vehicles[0], joint_cents=(1.5, 2)),) * 3},
         "no whole cents"),
        ("bill", {"vehicles": (replace(BILL.vehicles[0], alone_fuel_l=float("nan")),) * 3},
         "not finite"),
        ("gain", {"vehicles": GAIN.vehicles[:1]}, "shared by 1 vehicles"),
        ("gain", {"vehicles": (GainShare(20, 31), *GAIN.vehicles[1:])}, "not what is received"),
        ("chances", {"planned_saving": float("inf")}, "not finite"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(plan, chances, part, change, told):
    own = {"bill": BILL, "gain": GAIN, "chances": chances}[part]
    with pytest.raises(ScenarioError, match=told):
        replace(plan, **{part: replace(own, **change)})


@pytest.mark.parametrize("change", [{"event": 99}, {"chance": 1.2}, {"mean_s": float("nan")}])
def test_a_chance_must_be_that_of_a_merge(plan, chances, change):
    wrong = replace(chances, meetings=(replace(chances.meetings[0], **change),))
    with pytest.raises(ScenarioError, match="damaged"):
        replace(plan, chances=wrong)


def test_a_bill_has_one_amount_a_term():
    with pytest.raises(ScenarioError, match="one amount a term"):
        replace(BILL, terms=("fuel",))


@pytest.mark.parametrize("part", ["bill", "gain", "chances"])
@pytest.mark.parametrize("rubbish", [{}, [], 3, {"vehicles": 3}])
def test_rubbish_is_refused_in_one_line(plan, part, rubbish):
    with pytest.raises(ScenarioError) as told:
        Plan.from_dict(plan.to_dict() | {part: rubbish})
    assert "\n" not in str(told.value)
