"""The lead handed on: against all choices of places, and what must stay of a plan whoever leads."""

import itertools
from dataclasses import replace
from datetime import datetime

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from paused_plans import day_with_breaks, night
from random_networks import network, problems

import platoon_osm as po
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.inspection.verdict import inspect_plan
from platoon_osm.planning.fleet import Fleet
from platoon_osm.planning.rotation.companies import companies_of
from platoon_osm.planning.rotation.rotated import with_rotated_lead
from platoon_osm.planning.rotation.turns import Row, turns_in_front
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.standing import standing

# -- one company -----------------------------------------------------------------------------------


def every_choice(row, places, length, least):
    """Yield who leads how much, and the number of changes, of all that is allowed."""
    n = len(row.owes_m)
    for inner in itertools.combinations_with_replacement((0.0, *places, length), n - 1):
        bounds = (0.0, *inner, length)
        led = [end - begin for begin, end in itertools.pairwise(bounds)]
        leaders = [j for j in range(n) if led[j] > 0]
        last = leaders[-1]
        before = 0 if row.since_m else None  # who led when the company set out
        changes, fits = 0, True
        for j in range(n):
            own = led[j] + (row.since_m if j == 0 else 0.0)
            if j == 0 and last == 0:
                continue
            if led[j] == 0:
                # Only who has led nothing, or enough, may be passed over in front.
                fits = fits and (j > 0 or row.since_m == 0 or row.since_m >= least)
            elif j != last or not row.goes_on[j]:
                fits = fits and own >= least
        for j in leaders:
            changes += before is not None and before != j
            before = j
        if fits:
            yield led, changes


@st.composite
def rows(draw):
    n = draw(st.integers(1, 4))
    places = sorted(draw(st.sets(st.integers(1, 29), max_size=6)))
    length = draw(st.integers(30, 40)) * 1000.0
    owes = tuple(draw(st.integers(-5, 25)) * 1000.0 for _ in range(n))
    goes_on = tuple(draw(st.booleans()) for _ in range(n))
    since = draw(st.sampled_from([0.0, 3000.0, 12000.0]))
    least = draw(st.sampled_from([0.0, 5000.0, 10000.0, 20000.0]))
    return Row(owes, goes_on, since), [at * 1000.0 for at in places], length, least


@settings(max_examples=150, deadline=None)
@given(rows())
@example((Row((10e3, 10e3, 40e3), (True, True, True)), [10e3, 20e3, 30e3], 40e3, 0.0))
def test_turns_are_the_best_of_all_choices(asked):
    row, places, length, least = asked

    def away(led):
        owes = [min(max(one, 0.0), length) for one in row.owes_m]
        return [abs(one - other) for one, other in zip(owes, led, strict=True)]

    # The lengths are whole kilometres: deviations within a metre are equal.
    best = min(
        (max(away(led)), changes, sum(one * one for one in away(led)))
        for led, changes in every_choice(row, places, length, least)
    )
    turns = turns_in_front(row, places, length, least)
    assert turns[0].begin_m == 0
    assert turns[-1].end_m == length
    led = [0.0] * len(row.owes_m)
    for one, other in itertools.pairwise(turns):
        assert one.end_m == other.begin_m
        assert one.place < other.place
    for turn in turns:
        led[turn.place] = turn.end_m - turn.begin_m
    changes = len(turns) - (not row.since_m or turns[0].place == 0)
    found = (max(away(led)), changes, sum(one * one for one in away(led)))
    assert found == pytest.approx(best)


# -- plans -----------------------------------------------------------------------------------------


def road(count, edges=20, km=10.0):
    """A road of some edges that so many drive from end to end."""
    net = network(range(edges), range(1, edges + 1), [km * 1000] * edges)
    return net, [po.Trip("ABCDEF"[k], 0, edges) for k in range(count)]


def planned(net, trips, **options):
    weights = options.pop("weights", None) or po.paper_weights(net, positions="plafosim")
    return po.plan_joint(net, weights, trips, lead="rotated", **options)


def order(plan):
    return [
        ("".join(plan.trips[k].vehicle for k in one.vehicles), round(one.length_m / 1000))
        for one in plan.stretches
    ]


@pytest.mark.parametrize(
    ("count", "found"),
    [
        (2, [("AB", 100), ("BA", 100)]),
        (4, [("ABCD", 50), ("BCDA", 50), ("CDAB", 50), ("DABC", 50)]),
        (5, [("ABCDE", 40), ("BCDEA", 40), ("CDEAB", 40), ("DEABC", 40), ("EABCD", 40)]),
    ],
)
def test_each_leads_the_same(count, found):
    plan = planned(*road(count))
    assert order(plan) == found
    assert plan.rotation.worst_m == pytest.approx(0, abs=1e-6)
    assert [one.point.km for one in plan.rotation.changes] == pytest.approx(
        np.cumsum([km for _, km in found])[:-1]
    )


def test_nobody_leads_less_than_the_least_distance():
    plan = planned(*road(3, edges=10))
    # A third of 100 km is too short, so one of three does not lead.
    assert order(plan) == [("ABC", 50), ("BCA", 50)]
    assert order(planned(*road(2, edges=7))) == [("AB", 70)]


def test_the_lead_changes_within_an_edge_only_if_that_is_long():
    (first, at), (second, then) = order(planned(*road(2, edges=1, km=200)))
    assert (first, at, second, then) == ("AB", 100, "BA", 100)
    plan = planned(*road(2, edges=3, km=65))
    assert [km for _, km in order(plan)] in ([65, 130], [130, 65])
    assert order(planned(*road(2, edges=1, km=200)))[0][1] == 100


def test_who_joins_comes_in_at_the_back_and_who_leaves_drops_out():
    # A drives from 0 to 24, B from 0 to 8, C joins at 8.
    net = network([*range(24), 25], [*range(1, 25), 8], [10_000.0] * 24 + [5_000.0],
                  np.linspace(9, 12, 26), np.full(26, 45.0))  # fmt: skip
    trips = [po.Trip("A", 0, 24), po.Trip("B", 0, 8), po.Trip("C", 25, 24)]
    plan = planned(net, trips, master="A")
    assert [one for one in order(plan) if len(one[0]) > 1] == [
        ("AB", 40), ("BA", 40), ("AC", 80), ("CA", 80),
    ]  # fmt: skip
    assert len(plan.rotation.changes) == 2


def test_what_was_led_in_companies_before_counts():
    # A leads 20 km before C joins and 20 km more before D does: enough to hand on the lead there.
    net = network([*range(8), 9, 10], [*range(1, 9), 2, 4], [10e3] * 8 + [5e3] * 2,
                  np.linspace(9, 12, 11), np.full(11, 45.0))  # fmt: skip
    trips = [po.Trip(name, start, 8) for name, start in zip("ABCD", (0, 0, 9, 10), strict=True)]
    plan = planned(net, trips, master="A")
    assert [one for one in order(plan) if len(one[0]) > 1] == [
        ("AB", 20), ("ABC", 20), ("BCDA", 40),
    ]  # fmt: skip


SAME_EVENTS = ("kind", "point", "movers", "others")


@settings(max_examples=40, deadline=None)
@given(problems(), st.sampled_from(["A", "C", "D", "best"]), st.booleans())
def test_nothing_else_changes(problem, case, system):
    net, _, trips = problem
    trips = trips[:2] if case == "D" else trips
    weights = po.paper_weights(net, positions="plafosim")
    options = {"case": case, "optimum": "system" if system else "member"}
    before = po.plan_joint(net, weights, trips, **options)
    plan = planned(net, trips, weights=weights, **options)
    together = [one for one in before.stretches if one.together]
    if not together:
        assert plan == before
        return
    assert Plan.from_dict(plan.to_dict()) == plan
    assert plan.joint_cost == pytest.approx(before.joint_cost, rel=1e-12)
    assert plan.proof == before.proof
    for one, other in zip(plan.vehicles, before.vehicles, strict=True):
        assert one.length_m == pytest.approx(other.length_m)
        assert one.time_s == pytest.approx(other.time_s)
        assert (one.role, one.platoon_m) == (other.role, pytest.approx(other.platoon_m))
        own = sum(leg.alone_cost for leg in one.legs)
        assert own == pytest.approx(sum(leg.alone_cost for leg in other.legs))
    events = [[tuple(getattr(one, name) for name in SAME_EVENTS) for one in some.events]
              for some in (plan, before)]  # fmt: skip
    assert events[0] == events[1]
    if plan.rotation is None:  # the order that was planned is the only one that all agree to
        return
    lengths = sum(one.length_m for one in together)
    assert sum(plan.rotation.led_m) == pytest.approx(lengths)
    assert sum(plan.rotation.fair_m) == pytest.approx(lengths)
    led = [0.0] * len(trips)
    for one in plan.stretches:
        if one.together:
            led[one.vehicles[0]] += one.length_m
    assert led == pytest.approx(plan.rotation.led_m)
    check_changes(plan)


def check_changes(plan):
    """Changes are where the leader becomes another within one company, and never too close."""
    told = {one.stretch: one.former for one in plan.rotation.changes}
    found = {}
    for company in companies_of(plan.stretches, plan.ways):
        for one, other in itertools.pairwise(company.stretches):
            first, second = plan.stretches[one].vehicles, plan.stretches[other].vehicles
            if first[0] != second[0]:
                turned = second.index(first[0])
                assert second[turned:] + second[:turned] == first
                found[other] = first[0]
    for index, way in enumerate(plan.ways):
        for one, other in itertools.pairwise(way):
            first, second = plan.stretches[one].vehicles, plan.stretches[other].vehicles
            # Of those who drive on together another one leads.
            if first[0] == index and len(second) > 1 and second[0] in first[1:]:
                found[other] = index
    assert found.items() <= told.items()
    for number, former in told.items():
        way = plan.ways[former]
        place = way.index(number)
        led = 0.0
        for k in reversed(way[:place]):
            if plan.stretches[k].vehicles[0] != former or not plan.stretches[k].together:
                break
            led += plan.stretches[k].length_m
        assert led >= plan.rotation.least_m - 1.5


@settings(max_examples=60, deadline=None)
@given(problems(), st.integers(0, 2**16))
def test_no_member_pays_more_than_alone_by_it(problem, seed):
    net, _, trips = problem
    rng = np.random.default_rng(seed)
    # Leading costs more than driving alone: who leads much has nothing from company.
    solo = net.length_m
    weights = EdgeWeights(solo, solo * rng.uniform(0.8, 1), solo * rng.uniform(1, 1.2), "m", {})
    before = po.plan_joint(net, weights, trips)
    plan = po.plan_joint(net, weights, trips, lead="rotated")
    for one, other in zip(plan.vehicles, before.vehicles, strict=True):
        if other.joint_cost <= other.solo_cost * (1 + 1e-9):
            assert one.joint_cost <= one.solo_cost * (1 + 1e-9)


def test_who_would_pay_more_than_alone_leads_less():
    # B drives 4.5 km more for the company of A, which saves it 6 km-equivalents if it never leads.
    net = network([*range(20), 21, 21, 20], [*range(1, 21), 0, 22, 22],
                  [10e3] * 20 + [4e3, 203.5e3, 4e3],
                  np.linspace(9, 12, 23), np.full(23, 45.0))  # fmt: skip
    solo = net.length_m
    weights = EdgeWeights(solo, solo * 0.97, solo, "m", {})
    trips = [po.Trip("A", 0, 20), po.Trip("B", 21, 22)]
    plan = planned(net, trips, weights=weights, master="A")
    assert plan.rotation.spared == (1,)
    b = plan.vehicles[1]
    assert b.joint_cost <= b.solo_cost
    assert 0 < plan.rotation.led_m[1] < 100e3
    assert any("lead less than their share" in one and one.endswith(": B") for one in plan.remarks)
    system = planned(net, trips, weights=weights, master="A", optimum="system")
    assert system.rotation.led_m == pytest.approx((100e3, 100e3))


def test_unlike_vehicles_pay_by_their_own_weights():
    class ByMass:
        """A follower saves a tenth, and a heavy one a fifth."""

        unit = "m"
        params = {"name": "by mass"}  # noqa: RUF012 (nobody changes it)

        def weights(self, net, vehicle=None):
            own = 0.8 if vehicle is None else 0.9
            return EdgeWeights(net.length_m, net.length_m * own, net.length_m, "m", {})

        def waiting(self, seconds):
            del seconds
            return 0.0

    net, trips = road(2)
    light = replace(trips[1], profile={"mass_t": 20})
    plan = po.plan_joint(net, ByMass(), [trips[0], light], case="C", lead="rotated")
    half = 100e3
    assert [one.joint_cost for one in plan.vehicles] == pytest.approx([half * 1.8, half * 1.9])
    assert plan.proof.conditions[-1] == "before the lead changes"


def test_what_cannot_be_asked_is_told():
    net, trips = road(2)
    with pytest.raises(ScenarioError, match="lead 'all' is unknown; use master, rotated"):
        po.plan_joint(net, po.paper_weights(net), trips, lead="all")
    trips = [replace(one, earliest_departure=datetime(2026, 3, 2, 6)) for one in trips]
    with pytest.raises(ScenarioError, match="lead 'rotated' and task_relief"):
        planned(net, trips, rules="eu561", task_relief=0.5)


# -- with times ------------------------------------------------------------------------------------


@pytest.mark.parametrize("make", [day_with_breaks, night])
def test_days_keep_their_moments_pauses_and_drivers(make):
    before, net = make()
    fleet = Fleet.alike(net, po.paper_weights(net), len(before.trips))
    plan = with_rotated_lead(before, net, fleet, least_m=25e3)
    assert plan.rotation.changes
    assert len(plan.stretches) > len(before.stretches)
    assert len(inspect_plan(plan)) == len(inspect_plan(before))
    for index, (one, other) in enumerate(zip(plan.times, before.times, strict=True)):
        assert (one.departure_s, one.arrival_s) == (other.departure_s, other.arrival_s)
        assert {at for leg in other.legs for at in leg} <= {at for leg in one.legs for at in leg}
        assert [replace(p, before=0) for p in one.pauses] == [
            replace(p, before=0) for p in other.pauses
        ]
        assert standing(one) == tuple(
            replace(p, before=q.before) for p, q in zip(standing(other), standing(one), strict=True)
        )
        for now, then in zip(one.drivers, other.drivers, strict=True):
            assert seconds(one, now) == pytest.approx(seconds(other, then))
        for leg, k in enumerate(plan.ways[index]):
            begin, end = one.legs[leg]
            assert end - begin == pytest.approx(plan.stretches[k].drive_s, abs=0.01)


def seconds(times, driver):
    """How long a driver drives."""
    legs = range(len(times.legs)) if driver.drives is None else driver.drives
    return sum(times.legs[leg][1] - times.legs[leg][0] for leg in legs)
