"""Who gets what a plan saves, against the definitions: all groups, orders and ways to split."""

from dataclasses import replace
from functools import cache
from itertools import combinations, permutations

import numpy as np
import pytest
from coalition_games import coalitions, shapley_by_orders, split_best
from made_networks import both_ways, degrees
from made_networks import network as made
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.fleet import Fleet
from platoon_osm.planning.planned_company import PlannedCompany
from platoon_osm.plans.bill import Bill, VehicleBill
from platoon_osm.plans.records import Stretch
from platoon_osm.vehicles.pace import drive_times
from platoon_osm.vehicles.profile import Vehicle

SMALL = Vehicle("small", height_m=3.5, width_m=2.5, mass_t=12)
LARGE = Vehicle("large", height_m=4.0, width_m=2.5, mass_t=40)
RATES = {"small": 0.7, "large": 1.0}


class Tolls:
    """Money by the kilometre, with savings by place; large vehicles save more."""

    name, unit = "tolls", "EUR"

    def __init__(self, lead=0.05, middle=0.22, last=0.2):
        self.lead, self.middle, self.last = lead, middle, last
        self.params = {"preset": "tolls", "lead": lead, "middle": middle, "last": last}

    def rate(self, vehicle):
        return RATES.get(getattr(vehicle, "name", ""), 1.0)

    def saved(self, place, size, vehicle):
        """Return the euros a kilometre that a vehicle saves at a place."""
        if size < 2:
            return 0.0
        part = self.lead if place == 0 else self.last if place == size - 1 else self.middle
        return part * self.rate(vehicle) ** 2

    def weights(self, net, vehicle=None):
        km = net.length_m / 1000
        alone, at = self.rate(vehicle), self.rate(vehicle) ** 2
        lead, middle, last = (
            km * (alone - part * at) for part in (self.lead, self.middle, self.last)
        )
        return po.EdgeWeights(
            solo=km * alone, platoon=np.maximum(middle, last), master=lead, unit="EUR",
            params=self.params, network=net.identity(), middle=middle, last=last,
        )  # fmt: skip

    def waiting(self, seconds):
        return 0.0 * seconds


@cache
def corridor():
    """A road of seven junctions 40 km apart, a town beside each, and local roads between towns."""
    nodes = [(40_000 * k, 0) for k in range(7)] + [(40_000 * k, 6_000) for k in range(7)]
    road = [(k, k + 1) for k in range(6)]
    links = [(k, k + 7) for k in range(7)]
    local = [(k + 7, k + 8) for k in range(6)]
    return made(nodes, both_ways(road + links + local), speed_mps=22.0)


@cache
def drawn(seed, count=None, costs=None, master=None):
    """Draw trips along the corridor, one in four westward, of unlike vehicles, and plan them."""
    draw = np.random.default_rng(seed)
    trips = []
    for k in range(count or int(draw.integers(2, 6))):
        start, end = draw.integers(0, 3), draw.integers(4, 7)
        if count is None and draw.random() < 0.25:
            start, end = end - 1, start
        place = int(start) + 7 * int(draw.integers(0, 2))
        if draw.random() < 0.3:  # within an edge
            lon, lat = degrees(40_000 * start + draw.uniform(5_000, 35_000), 0)
            place = float(lon), float(lat)
        profile = SMALL if draw.random() < 0.4 else LARGE
        trips.append(po.Trip(f"v{k}", place, int(end) + 7 * int(draw.integers(0, 2)),
                             profile=profile))  # fmt: skip
    problem = po.Problem(corridor(), trips, costs or Tolls(), optimum="system", master=master)
    return problem, po.solve(problem)


def groups_of(plan):
    """Return who is linked with whom, from the companies of the plan's stretches."""
    found = [{k} for k in range(len(plan.trips))]
    for stretch in plan.stretches:
        linked = [one for one in found if one & set(stretch.vehicles)]
        found = [one for one in found if one not in linked] + [set().union(*linked)]
    return found


def on_stretch(problem, plan, stretch, order):
    """Return the cents that vehicles save on a stretch in an order, leader first."""
    if isinstance(problem.objective, po.MoneyCosts):
        return at_the_slowest_pace(problem, plan, stretch, order)
    return {
        one: 100 * stretch.length_m / 1000
        * problem.objective.saved(place, len(order), plan.trips[one].profile)
        for place, one in enumerate(order)
    }  # fmt: skip


def at_the_slowest_pace(problem, plan, stretch, order):
    """Return the same under the prices of the package, edge by edge at the slowest pace."""
    net, edges = problem.net, np.array(stretch.edges)
    profiles = [plan.trips[one].profile for one in order]
    pace = np.maximum.reduce([drive_times(net, profile)[edges] for profile in profiles])
    found = {}
    for place, (one, profile) in enumerate(zip(order, profiles, strict=True)):
        by_place = problem.objective.weights(net, profile).by_place
        share = by_place.share(edges, place, len(order), pace)
        found[one] = 100 * (share.alone_cost - share.cost)
    return found


def own_ways(problem, plan, saved):
    """Return what each one's own way costs more than alone, in cents."""
    gained = dict.fromkeys(range(len(plan.trips)), 0.0)
    for stretch in plan.stretches:
        for one, cents in on_stretch(problem, plan, stretch, stretch.vehicles).items():
            gained[one] += cents
    return {one: gained[one] - saved[one] for one in gained}


def value_of(problem, plan, saved):
    """Return what any group of vehicles has by itself on the planned roads, as a function."""
    own = own_ways(problem, plan, saved)

    @cache
    def taking_part(group):
        total = -sum(own[one] for one in group)
        for stretch in plan.stretches:
            there = [one for one in stretch.vehicles if one in group]
            total += max(
                (
                    sum(on_stretch(problem, plan, stretch, order).values())
                    for size in range(2, len(there) + 1)
                    for some in combinations(there, size)
                    for order in ([one, *(k for k in some if k != one)] for one in some)
                ),
                default=0.0,
            )
        return total

    return cache(
        lambda group: max(taking_part(part) for part in coalitions_of(group))
    )  # fmt: skip


def coalitions_of(group):
    own = sorted(group)
    return [frozenset(part) for k in range(len(own) + 1) for part in combinations(own, k)]


def worst_of(groups, value, shares):
    """Return how many proper groups there are, and the most that one has beyond its shares."""
    excess = [
        value(part) - sum(shares[one] for one in part)
        for group in groups
        for part in coalitions_of(group)
        if 0 < len(part) < len(group)
    ]
    return len(excess), max(excess, default=None)


def equal_by_hand(problem, plan, saved):
    """Return what each saves as a follower, less its part of the leader's loss and its own way."""
    shares = {one: -cents for one, cents in own_ways(problem, plan, saved).items()}
    for stretch in plan.stretches:
        size = len(stretch.vehicles)
        if size < 2:
            continue
        follow = on_stretch(problem, plan, stretch, stretch.vehicles)
        leader, second = stretch.vehicles[0], [stretch.vehicles[1], stretch.vehicles[0]]
        leading = follow[leader]
        rest = [one for one in stretch.vehicles if one not in second]
        follow[leader] = on_stretch(problem, plan, stretch, [*second, *rest])[leader]
        for one in stretch.vehicles:
            shares[one] += follow[one] - (follow[leader] - leading) / size
    return shares


SEEDS = range(chosen(6, 60))


@soaked
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("rule", ["equal", "shapley", "least-core"])
def test_shares_add_up_and_all_groups_are_asked(seed, rule):
    problem, plan = drawn(seed)
    gain = po.share_gain(plan, problem, rule).gain
    saved = [one.saved_cents for one in gain.vehicles]
    shares = [one.share_cents for one in gain.vehicles]
    assert saved == [round(100 * (one.solo_cost - one.joint_cost)) for one in plan.vehicles]
    assert sum(saved) == sum(shares) == gain.gain_cents
    assert (gain.rule, gain.currency) == (rule, "EUR")
    assert gain.nobody_is_worse_off
    count, worst = worst_of(groups_of(plan), value_of(problem, plan, saved), shares)
    assert gain.coalitions == count
    assert gain.worst_cents == (None if worst is None else pytest.approx(worst, abs=1e-5))


def test_the_plans_that_are_drawn_have_what_matters():
    plans = [drawn(seed)[1] for seed in SEEDS]
    stretches = [stretch for plan in plans for stretch in plan.stretches if stretch.together]
    assert any(stretch.span != (0.0, 1.0) for stretch in stretches)
    assert any(len(stretch.vehicles) > 3 for stretch in stretches)
    assert any(len({plan.trips[k].profile for k in s.vehicles}) == 2
               for plan in plans for s in plan.stretches)  # fmt: skip
    assert any(len(groups_of(plan)) > 1 for plan in plans)


@soaked
@pytest.mark.parametrize("seed", SEEDS)
def test_equal_parts_are_those_of_the_leaders_loss(seed):
    problem, plan = drawn(seed)
    gain = po.share_gain(plan, problem).gain
    right = equal_by_hand(problem, plan, [one.saved_cents for one in gain.vehicles])
    if min(right.values()) >= 0:
        assert gain.remark == ""
        for one, share in right.items():
            assert gain.vehicles[one].share_cents == pytest.approx(share, abs=1)


@soaked
@pytest.mark.parametrize("seed", SEEDS)
def test_the_shapley_value_is_the_mean_over_all_orders(seed):
    problem, plan = drawn(seed)
    gain = po.share_gain(plan, problem, "shapley").gain
    saved = [one.saved_cents for one in gain.vehicles]
    value = value_of(problem, plan, saved)
    for group in groups_of(plan):
        names = sorted(group)

        def worth(part, names=names, group=group):
            own = frozenset(names[k] for k in part)
            return sum(saved[k] for k in group) if own == group else value(own)

        right = shapley_by_orders(len(names), worth)
        if min(right) >= 0:
            for one, share in zip(names, right, strict=True):
                assert gain.vehicles[one].share_cents == pytest.approx(share, abs=1)


@soaked
@pytest.mark.parametrize("seed", SEEDS)
def test_in_the_least_core_nobody_has_more_to_gain_than_under_other_rules(seed):
    problem, plan = drawn(seed)
    worst = {
        rule: po.share_gain(plan, problem, rule).gain.worst_cents
        for rule in ("equal", "shapley", "least-core")
    }
    if worst["equal"] is not None:
        rounding = len(plan.trips)
        assert worst["least-core"] <= min(worst["equal"], worst["shapley"]) + rounding


def test_vehicles_alike_bear_the_lead_together_and_stay_in_the_core():
    costs = Tolls(lead=0.0, middle=0.2, last=0.2)
    trips = [po.Trip(name, 0, 6) for name in "ABC"]
    problem = po.Problem(corridor(), trips, costs)
    gain = po.share_gain(po.solve(problem), problem).gain
    # 240 km, two of three save 0.2 EUR a kilometre: 96 EUR, 32 for each; two alone have 48.
    assert [one.share_cents for one in gain.vehicles] == [3200, 3200, 3200]
    assert sorted(one.payment_cents for one in gain.vehicles) == [-1600, -1600, 3200]
    assert gain.worst_cents == pytest.approx(4800 - 6400, abs=0.1)
    assert gain.coalitions == 6


@pytest.mark.parametrize("rule", ["equal", "shapley", "least-core"])
def test_slow_vehicles_slow_those_they_drive_with(rule):
    slow = replace(LARGE, name="slow", limiter_kmh=75.0)
    trips = [
        po.Trip("A", 0, 6, profile=LARGE),
        po.Trip("B", 1, 6, profile=slow),
        po.Trip("C", 0, 5, profile=LARGE),
        po.Trip("D", 1, 5, profile=LARGE),
    ]
    costs = po.MoneyCosts("eu", positions="plafosim", driver_following=0.5)
    problem = po.Problem(corridor(), trips, costs)
    plan = po.solve(problem)
    assert any({1, 0} <= set(stretch.vehicles) for stretch in plan.stretches)
    gain = po.share_gain(plan, problem, rule).gain
    saved = [one.saved_cents for one in gain.vehicles]
    shares = [one.share_cents for one in gain.vehicles]
    count, worst = worst_of(groups_of(plan), value_of(problem, plan, saved), shares)
    assert (gain.coalitions, gain.worst_cents) == (count, pytest.approx(worst, abs=1e-5))
    if rule == "equal":
        right = equal_by_hand(problem, plan, saved)
        assert shares == pytest.approx([right[one] for one in range(4)], abs=1)


def company_of(costs, profiles):
    """Return vehicles side by side on the first two edges eastward, and what they save there."""
    net = corridor()
    edges = [int(np.flatnonzero((net.tail == k) & (net.head == k + 1))[0]) for k in (0, 1)]
    paces = {profile: drive_times(net, profile) for profile in profiles}
    for profile in profiles:
        same = (one for one in paces.values() if np.array_equal(one, paces[profile]))
        paces[profile] = next(same)
    fleet = Fleet(
        [costs.weights(net, profile) for profile in profiles],
        None,
        [paces[profile] for profile in profiles],
    )
    order = tuple(range(len(profiles)))
    shares = tuple(fleet.share(order, place, np.array(edges), 80_000.0) for place in order)
    stretch = Stretch(tuple(edges), order, 80_000.0, 3600.0, shares)
    return PlannedCompany(stretch, fleet)


def test_who_would_lose_by_company_drives_its_stretch_alone():
    # Two save 0.1 + 0.3 EUR a kilometre; who drives between them loses 0.25.
    company = company_of(Tolls(lead=0.1, middle=-0.25, last=0.3), [LARGE] * 3)
    pair = pytest.approx(80 * 40, abs=0.1)
    assert company.as_planned.sum() == pytest.approx(80 * 15, abs=1)
    values = company.values()
    assert [values[3], values[5], values[6], values[7]] == [pair] * 4


@pytest.mark.parametrize("positions", ["eddi", "plafosim"])
def test_no_group_saves_more_than_the_game_of_the_best_places(positions):
    slow, slower = (replace(LARGE, name=f"{v}", limiter_kmh=v) for v in (78.0, 70.0))
    costs = po.MoneyCosts("eu", positions=positions)
    company = company_of(costs, [LARGE, slow, LARGE, slower, SMALL])
    values, best = company.values(), company.best_game()
    assert (best.values() >= values - 1e-9).all()
    if positions == "eddi":  # all followers save alike, so two alike have nothing better
        assert values[5] == pytest.approx(best.value([0, 2]))
    assert best.losses.min() >= 0


def test_who_would_be_worse_off_by_the_rule_is_named_and_is_not():
    costs = Tolls(lead=0.0, middle=0.3, last=0.3)
    problem = po.Problem(corridor(), [po.Trip("A", 0, 6), po.Trip("B", 0, 6)], costs)
    plan = po.solve(problem)
    follower = plan.stretches[0].vehicles[1]
    # It saves 72 EUR as a follower and waits for 65; half of what the leader loses is 36.
    bill = bill_of(plan, waiting={follower: 6500})
    gain = po.share_gain(replace(plan, bill=bill), problem).gain
    assert gain.vehicles[follower].saved_cents == 700
    assert gain.vehicles[follower].share_cents == 0
    assert gain.vehicles[1 - follower].share_cents == 700
    assert f"{'AB'[follower]} would be worse off" in gain.remark
    assert (gain.coalitions, gain.worst_cents) == (2, 0)


def test_where_all_together_lose_somebody_must():
    costs = Tolls(lead=0.0, middle=0.3, last=0.3)
    problem = po.Problem(corridor(), [po.Trip("A", 0, 6), po.Trip("B", 0, 6)], costs)
    plan = po.solve(problem)
    bill = bill_of(plan, waiting={0: 9000})
    for rule in ("equal", "shapley", "least-core"):
        gain = po.share_gain(replace(plan, bill=bill), problem, rule).gain
        assert gain.gain_cents == -1800
        assert not gain.nobody_is_worse_off
        assert "all together lose" in gain.remark
        assert gain.worst_cents > 0


def bill_of(plan, waiting):
    """Return the bill of a plan, with what some pay for waiting."""
    vehicles = tuple(
        VehicleBill(
            (round(100 * one.solo_cost), 0), (round(100 * one.joint_cost), waiting.get(k, 0)),
            0.0, 0.0, (0.0, 0.0), (0.0, 0.0),
        )
        for k, one in enumerate(plan.vehicles)
    )  # fmt: skip
    return Bill("EUR", ("fuel", "waiting"), vehicles)


@cache
def anew(part):
    """Return what some of four vehicles save with a plan of their own."""
    if len(part) < 2:
        return 0
    problem, _ = drawn(3, 4)
    own = po.solve(replace(problem, trips=[problem.trips[k] for k in sorted(part)]))
    return max(sum(round(100 * (one.solo_cost - one.joint_cost)) for one in own.vehicles), 0)


@pytest.mark.parametrize("rule", ["equal", "shapley", "least-core"])
def test_coalitions_may_plan_anew(rule):
    problem, plan = drawn(3, 4)
    gain = po.share_gain(plan, problem, rule, anew=True).gain
    saved = [one.saved_cents for one in gain.vehicles]

    def value(part):
        return sum(saved) if len(part) == 4 else split_best(part, anew)

    shares = [one.share_cents for one in gain.vehicles]
    worst = max(
        value(part) - sum(shares[k] for k in part) for part in coalitions(4) if 0 < len(part) < 4
    )
    assert (gain.coalitions, gain.manner) == (14, "planned anew")
    assert gain.worst_cents == pytest.approx(worst, abs=1e-5)
    if rule == "shapley":
        right = shapley_by_orders(4, value)
        if min(right) >= 0:
            assert shares == pytest.approx(right, abs=1)


def test_where_groups_apart_save_more_the_plan_is_said_to_be_no_good_one():
    problem, plan = drawn(3, 4)
    best = sum(one.saved_cents for one in po.share_gain(plan, problem).gain.vehicles)
    trips = [problem.trips[k] for k in range(4)]
    worse = po.solve(po.Problem(corridor(), trips, Tolls(), optimum="system", case="A"))
    gain = po.share_gain(worse, problem, anew=True).gain
    apart = max(
        split_best(frozenset(range(4)), lambda part: anew(part) if len(part) < 4 else 0),
        gain.gain_cents,
    )
    assert best > gain.gain_cents
    more = apart - gain.gain_cents
    assert gain.remark == f"planned apart in groups all would save {more / 100:.2f} EUR more"
    assert gain.worst_cents > 0


def test_a_master_that_is_named_leads_only_where_it_is():
    problem, plan = drawn(5, 3, master="v1")
    gain = po.share_gain(plan, problem, anew=True).gain
    assert gain.coalitions == 6


def test_of_many_a_bound_covers_all_groups():
    problem, plan = drawn(2, 14, Tolls(lead=0.0, middle=0.2, last=0.2))
    assert max(map(len, groups_of(plan))) > 12
    for rule in ("equal", "shapley", "least-core"):
        gain = po.share_gain(plan, problem, rule).gain
        assert gain.nobody_is_worse_off
        assert gain.gain_cents == sum(one.saved_cents for one in gain.vehicles)
        assert gain.coalitions == 0
        assert "a bound covers all groups of 14 linked vehicles" in gain.remark
        assert ("too many for the least core" in gain.remark) == (rule == "least-core")
        saved = [one.saved_cents for one in gain.vehicles]
        value = value_of(problem, plan, saved)
        shares = [one.share_cents for one in gain.vehicles]
        for pair in permutations(range(14), 2):
            assert value(frozenset(pair)) - sum(shares[k] for k in pair) <= gain.worst_cents + 1e-5


def test_a_plan_in_money_is_shared_by_the_rule_that_is_asked_for():
    trips = [po.Trip("A", 0, 6), po.Trip("B", 1, 6), po.Trip("C", 0, 5)]
    problem = po.Problem(corridor(), trips, po.MoneyCosts("eu"), share="least-core")
    plan = po.solve(problem)
    assert plan.gain == po.share_gain(plan, problem, "least-core").gain
    assert plan.gain != po.share_gain(plan, problem, "equal").gain
    assert plan.gain.gain_cents == plan.bill.saved_cents
    assert po.solve(replace(problem, objective=po.PaperCosts())).gain is None
    with pytest.raises(ScenarioError, match="share 'fair' is unknown"):
        replace(problem, share="fair")


def test_of_many_a_plan_says_that_groups_were_not_asked():
    trips = [po.Trip(f"v{k}", k % 3, 4 + k % 3) for k in range(13)]
    problem = po.Problem(corridor(), trips, po.MoneyCosts("eu"))
    plan = po.solve(problem)
    assert "what groups of 13 linked vehicles could gain was not worked out" in plan.gain.remark
    assert (plan.gain.coalitions, plan.gain.worst_cents) == (0, None)
    assert po.share_gain(plan, problem).gain.worst_cents is not None


def test_a_vehicle_alone_shares_with_nobody():
    problem = po.Problem(corridor(), [po.Trip("A", 0, 6)], Tolls())
    gain = po.share_gain(po.solve(problem), problem).gain
    assert [one.share_cents for one in gain.vehicles] == [0]
    assert (gain.coalitions, gain.worst_cents, gain.manner) == (0, None, "")


def test_a_plan_read_back_is_shared_alike(tmp_path):
    problem, plan = drawn(1)
    shared = po.share_gain(plan, problem)
    shared.write_json(tmp_path / "plan.json")
    again = po.Plan.read_json(tmp_path / "plan.json")
    assert again.gain == shared.gain
    assert po.share_gain(again, problem).gain == shared.gain


def test_what_cannot_be_shared_is_told_in_a_line():
    problem, plan = drawn(1, 3)
    with pytest.raises(ScenarioError, match="share 'by lot' is unknown; use equal"):
        po.share_gain(plan, problem, "by lot")
    with pytest.raises(ScenarioError, match="the plan is not that of this problem"):
        po.share_gain(plan, replace(problem, trips=problem.trips[:2]))
    with pytest.raises(ScenarioError, match="str and Problem were given"):
        po.share_gain("plan", problem)
    metres = replace(problem, objective=po.paper_weights(corridor()))
    with pytest.raises(ScenarioError, match="costs are in 'm', no money"):
        po.share_gain(po.solve(metres), metres)
    nodes = [(40_000 * k, 0) for k in range(14)]
    other = made(nodes, both_ways([(k, k + 1) for k in range(13)]))
    with pytest.raises(ScenarioError, match="the problem has another network"):
        po.share_gain(plan, replace(problem, net=other))
    many = [po.Trip(f"v{k}", 0, 6) for k in range(9)]
    nine = po.Problem(corridor(), many, Tolls())
    with pytest.raises(ScenarioError, match="9 vehicles have too many coalitions"):
        po.share_gain(po.solve(nine), nine, anew=True)
