"""Days of late vehicles against a slow player of one day, and counts against closed forms."""

import json
import math
from datetime import datetime, timedelta
from types import SimpleNamespace

import numpy as np
import pytest
from random_networks import network
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.course import course_of
from platoon_osm.planning.late_days import played
from platoon_osm.planning.meeting_chances import runs_for, with_chances
from platoon_osm.plans.plan import Plan

DAY = datetime(2026, 3, 2, 6)
FREE = SimpleNamespace(waiting=lambda _: 0.0)


def priced(waiting, delay=0.0):
    """Prices of a second's waiting and delay."""
    return SimpleNamespace(waiting=lambda s: waiting * s, delay=lambda s: delay * s)


def corridor(seed, vehicles=4, nodes=6, longer=1.0, **options):
    """A plan of vehicles that come onto one road and leave it at places of their own."""
    rng = np.random.default_rng(seed)
    road = [(k, k + 1) for k in range(nodes - 1)]
    feeders = [(nodes + k, k) for k in range(nodes)]
    exits = [(k, 2 * nodes + k) for k in range(nodes)]
    ends = sorted([*road, *feeders, *exits])
    length = [longer * float(rng.uniform(2e4, 6e4)) for _ in ends]
    net = network([a for a, _ in ends], [b for _, b in ends], length)
    trips = []
    for k in range(vehicles):
        on = int(rng.integers(0, nodes - 2))
        off = int(rng.integers(on + 1, nodes))
        trips.append(
            po.Trip(
                "ABCDEFGH"[k], nodes + on, 2 * nodes + off,
                DAY + timedelta(minutes=int(rng.integers(0, 40))),
                flexibility_min=float(rng.integers(10, 200)) if rng.random() < 0.6 else None,
            )
        )  # fmt: skip
    costs = po.PaperCosts(positions="plafosim") if rng.random() < 0.5 else po.PaperCosts()
    return po.plan_joint(net, po.paper_weights(net, costs), trips, **options)


def pair(seed=3):
    """A plan of two vehicles that merge on the way."""
    return next(plan for s in range(seed, 400) if len(merges(plan := corridor(s, 2))) == 1)


def merges(plan):
    return [event for event in plan.events if event.kind == "merge"]


# -- a slow player of one day ----------------------------------------------------------------------


def one_day(plan, late, waits):
    """Play one day by sets of vehicles: what each pays, when it arrives, which merges succeed."""
    course = course_of(plan)
    steps = {step.stretch: step for step in course.steps}
    met, done = {}, {}

    def groups(stretch):
        """The companies that really drive a stretch, and when they start."""
        if stretch not in done:
            done[stretch] = played_out(steps[stretch])
        return done[stretch]

    def played_out(step):
        coming = {}
        for vehicle, last, stands in zip(step.vehicles, step.before, step.stands_s, strict=True):
            if last < 0:
                ready = course.departures_s[vehicle] + late[vehicle] + stands
                coming[frozenset([vehicle])] = ready
                continue
            for company, start in groups(last):
                if vehicle in company:
                    own = company & set(step.vehicles)
                    ready = start + steps[last].drive_s + stands
                    coming[own] = max(coming.get(own, -math.inf), ready)
        for merge in step.merges:
            host = next(one for one in coming if merge.host in one)
            there = coming[host]
            wait, early = waits[merge.event]
            came = [one for one in coming if one & set(merge.movers)]
            joining = [one for one in came if -early <= coming[one] - there <= wait]
            leaves = max([there, *(coming[one] for one in joining)])
            if any(coming[one] - there > wait for one in came):
                leaves = max(leaves, there + wait)
            met[merge.event] = len(joining) == len(came)
            for one in came:
                if one in joining:
                    del coming[one]
                elif coming[one] - there < -early:
                    coming[one] += early
            del coming[host]
            coming[host.union(*joining)] = leaves
        return list(coming.items())

    paid = np.zeros(len(plan.trips))
    arrival = np.zeros(len(plan.trips))
    for vehicle, way in enumerate(plan.ways):
        for k in way:
            stretch = plan.stretches[k]
            company, start = next(one for one in groups(k) if vehicle in one[0])
            order = [one for one in stretch.vehicles if one in company]
            place = order.index(vehicle)
            share = stretch.share_of(vehicle)
            if len(order) == len(stretch.vehicles):
                paid[vehicle] += share.cost
            elif len(order) == 1:
                paid[vehicle] += share.alone_cost
            else:
                like = 0 if place == 0 else -1 if place == len(order) - 1 else 1
                model = stretch.shares[like]
                paid[vehicle] += share.alone_cost * model.cost / model.alone_cost
            arrival[vehicle] = start + stretch.drive_s
    return paid, arrival, met


@soaked
@pytest.mark.parametrize("seed", range(chosen(12, 150)))
def test_days_are_those_of_a_slow_player(seed):
    plan = corridor(seed, 2 + seed % 5)
    course = course_of(plan)
    rng = np.random.default_rng(seed)
    late = rng.normal(0, 900, (len(plan.trips), 40))
    waits = {
        merge.event: tuple(rng.choice([0.0, 300.0, 900.0, math.inf], 2)) for merge in course.merges
    }
    days = played(plan, course, late, lambda merge, _: waits[merge.event])
    for run in range(late.shape[1]):
        paid, arrival, met = one_day(plan, late[:, run], waits)
        assert np.allclose(days.paid[:, run], paid)
        assert np.allclose(days.arrival_s[:, run], arrival)
        assert {event: bool(found[run]) for event, found in days.met.items()} == met
    assert (days.waited_s >= 0).all()
    driven = [vehicle.time_s for vehicle in plan.vehicles]
    spent = days.arrival_s - late - np.array(course.departures_s)[:, None]
    assert np.allclose(spent, np.array(driven)[:, None] + days.waited_s)


@soaked
@pytest.mark.parametrize("seed", range(chosen(8, 80)))
def test_if_nobody_is_late_the_plan_comes_out(seed):
    plan = corridor(seed, 4)
    found = po.simulate_delays(plan, po.Delays(0), runs=3)
    assert found.chances.planned_saving == pytest.approx(plan.solo_cost - plan.joint_cost)
    assert found.saved == pytest.approx(plan.solo_cost - plan.joint_cost)
    assert found.met.all()
    assert (found.in_time == 1).all()
    assert found.chances.saving_error == pytest.approx(0, abs=1e-9 * plan.solo_cost)
    days = played(plan, course_of(plan), np.zeros((4, 1)))
    planned = [times.arrival_s for times in plan.times]
    assert np.allclose(days.arrival_s[:, 0], planned, atol=0.01)
    assert np.allclose(days.paid[:, 0], [vehicle.joint_cost for vehicle in plan.vehicles])


def test_breaks_keep_their_length_and_are_no_wait():
    plan = corridor(5, 3, longer=2.2, rules="eu561")
    assert merges(plan)
    assert any(pause.is_break for times in plan.times for pause in times.pauses)
    days = played(plan, course_of(plan), np.array([[0.0, 600.0]] * 3))
    planned = [times.arrival_s for times in plan.times]
    assert np.allclose(days.arrival_s[:, 0], planned, atol=0.01)
    assert np.allclose(days.arrival_s[:, 1], np.array(planned) + 600, atol=0.01)  # all are late
    for one in po.simulate_delays(plan, po.Delays(5), runs=100).chances.meetings:
        assert one.window_s > 60


# -- closed forms and counts -----------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["normal", "lognormal"])
@pytest.mark.parametrize("waiting", [0.0, 0.6, 3.0])
def test_one_merge_in_closed_form_is_what_counting_gives(kind, waiting):
    for seed in (3, 40, 90):
        plan = pair(seed)
        delays = po.Delays(25, correlation=0.3, kind=kind)
        found = po.simulate_delays(
            plan, delays, runs=chosen(20_000, 200_000), seed=5, objective=priced(waiting)
        )
        (meeting,) = found.chances.meetings
        chance = meeting.chance
        error = math.sqrt(chance * (1 - chance) / found.chances.runs)
        assert abs(found.met.mean() - chance) <= 4 * error + 1e-3
        closed = found.chances.closed_form_saving
        assert closed is not None
        assert abs(found.chances.expected_saving - closed) <= (
            4 * found.chances.saving_error + 1e-3 * abs(meeting.gain)
        )
        waited = found.waited_s.sum(axis=0)
        assert abs(waited.mean() - meeting.expected_wait_s) <= (
            4 * waited.std() / math.sqrt(len(waited)) + 1.0
        )


def test_the_gain_of_a_merge_is_what_all_pay_more_without_it():
    plan = pair()
    (meeting,) = po.simulate_delays(plan, po.Delays(10), runs=10).chances.meetings
    (merge,) = merges(plan)
    together = [stretch for stretch in plan.stretches if stretch.together]
    shares = [share for stretch in together for share in stretch.shares]
    gain = sum(share.alone_cost - share.cost for share in shares)
    assert meeting.gain == pytest.approx(gain)
    own = [stretch.share_of(merge.movers[0]) for stretch in together]
    assert meeting.missed_cost == pytest.approx(sum(one.alone_cost - one.cost for one in own))


def test_nobody_waits_longer_than_all_can_and_dear_waiting_is_given_up():
    plan = pair()
    delays = po.Delays(20)
    free, dear = (
        po.simulate_delays(plan, delays, runs=500, objective=priced(price)).chances.meetings[0]
        for price in (0.0, 1e6)
    )
    assert free.wait_up_to_s == free.window_s
    (merge,) = merges(plan)
    host = merge.others[0]
    latest = plan.timetable.vehicles[host].latest_arrival_s
    if latest is None:
        latest = plan.timetable.patient_until_s(host, plan.trips[host].alone.time_s)
    room = latest - plan.timetable.vehicles[host].arrival_s
    assert free.window_s == pytest.approx(room + plan.timetable.vehicles[host].waiting_s, abs=0.01)
    assert (dear.wait_up_to_s, dear.movers_wait_up_to_s) == (0.0, 0.0)
    assert dear.chance < free.chance


def test_who_has_to_leave_and_wait_has_that_wait_as_room():
    net = network([0, 1, 2, 4, 5], [1, 2, 3, 1, 6], [3e4, 4e4, 4e4, 3e4, 1e4])
    trips = [
        po.Trip("A", 0, 3, DAY, DAY, flexibility_min=60),
        po.Trip("B", 4, 3, DAY + timedelta(minutes=30), flexibility_min=60),
    ]
    plan = po.plan_joint(net, po.paper_weights(net), trips)
    host = 1 - merges(plan)[0].movers[0]
    assert sum(times.waiting_s for times in plan.times) == pytest.approx(1800)
    (meeting,) = po.simulate_delays(plan, po.Delays(5), runs=10).chances.meetings
    sides = {host: meeting.window_s, 1 - host: meeting.movers_wait_up_to_s}
    assert sides == pytest.approx({0: 3600, 1: 3600})
    assert abs(meeting.mean_s) == pytest.approx(1800)


@pytest.mark.parametrize("size", [1, 2])
def test_later_merges_wait_as_is_best_on_the_days_drawn(size):
    """The wait that is told for a merge is no worse than others, all else as it is."""
    for plan in (p for s in range(400) if len(merges(p := corridor(s, 4))) > 1):
        last = course_of(plan).merges[-1]
        if len(last.others) == size and not last.is_first:
            break
    course = course_of(plan)
    late = po.Delays(30, kind="lognormal").draws([t.vehicle for t in plan.trips], 800, 0).T
    inner = 0
    for price in np.geomspace(3, 90, chosen(5, 12)):
        found = po.simulate_delays(
            plan, po.Delays(30, kind="lognormal"), runs=800, objective=priced(price)
        )
        told = {
            one.event: (one.wait_up_to_s, one.movers_wait_up_to_s) for one in found.chances.meetings
        }
        meeting = found.chances.of_event(last.event)
        days = played(plan, course, late, lambda merge, _, told=told: told[merge.event])
        gaps = days.gaps_s[last.event]

        def value(wait, gaps=gaps, gain=meeting.gain, each=price * size):
            met = (gaps > 0) & (gaps <= wait)
            return gain * met.mean() - each * np.clip(gaps, 0, wait).mean()

        most = max(value(wait) for wait in np.linspace(0, meeting.window_s, 100))
        assert value(meeting.wait_up_to_s) >= most - 1e-9 * abs(meeting.gain)
        inner += 0 < meeting.wait_up_to_s < meeting.window_s
    assert inner


def test_a_price_of_delay_counts_and_has_no_closed_form():
    plan = pair()
    found = po.simulate_delays(plan, po.Delays(20), runs=400, objective=priced(0.2, 0.3))
    assert found.chances.closed_form_saving is None
    same = po.simulate_delays(plan, po.Delays(20), runs=400, objective=priced(0.2))
    assert found.chances.planned_saving <= same.chances.planned_saving
    assert np.all(found.saved <= po.simulate_delays(plan, po.Delays(20), runs=400).saved + 1e-6)


def test_trucks_in_one_jam_meet_more_often():
    plan = pair()
    chances = [
        po.simulate_delays(plan, po.Delays(60, correlation=share), runs=10).chances.meetings[0]
        for share in (-0.5, 0.0, 0.5, 1.0)
    ]
    values = [one.chance for one in chances]
    assert values == sorted(values)
    assert values[0] < values[2]
    assert chances[-1].spread_s == pytest.approx(0.0, abs=1e-6)


def test_a_plan_keeps_its_chances_in_its_file():
    plan = with_chances(pair(), po.Delays(8), FREE)
    assert plan.chances is not None
    assert Plan.from_dict(json.loads(json.dumps(plan.to_dict()))) == plan


def test_the_same_seed_gives_the_same_days():
    plan = pair()
    first, again, other = (
        po.simulate_delays(plan, po.Delays(60), runs=300, seed=seed).waited_s for seed in (1, 1, 2)
    )
    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)


def test_fewer_days_are_drawn_for_many_vehicles():
    assert runs_for(pair()) == 10_000
    assert runs_for(pair(), 50) == 200


def test_what_cannot_be_simulated_is_told_in_one_line():
    plan = pair()
    with pytest.raises(ScenarioError, match="float given; make it Delays"):
        po.simulate_delays(plan, 8.0)
    with pytest.raises(ScenarioError, match="runs is 0"):
        po.simulate_delays(plan, po.Delays(8), runs=0)
    net = network([0, 1, 2], [1, 2, 3], [1e4] * 3)
    untimed = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", 0, 3), po.Trip("B", 0, 2)])
    with pytest.raises(ScenarioError, match="no timetable"):
        po.simulate_delays(untimed, po.Delays(8))
    assert with_chances(untimed, po.Delays(8), FREE) is untimed
