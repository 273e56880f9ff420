"""Positions along each way, and who leads in words: against a count over the plan's stretches."""

from datetime import datetime, timedelta

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network, problems

import platoon_osm as po
from platoon_osm.plans.positions import lead_runs, positions_of

SIX = datetime(2026, 3, 2, 6)


def planned(net, trips, **options):
    return po.plan_joint(net, po.paper_weights(net, positions="plafosim"), trips, **options)


@settings(max_examples=40, deadline=None)
@given(problems(), st.sampled_from(["master", "rotated"]), st.booleans())
def test_spans_are_the_whole_way_in_its_positions(problem, lead, timed):
    net, _, trips = problem
    if timed:
        trips = [po.Trip(one.vehicle, one.origin, one.destination, SIX) for one in trips]
    plan = planned(net, trips, lead=lead)
    for index, way in enumerate(plan.ways):
        told = []
        for span in (one for one in positions_of(plan) if one.vehicle == index):
            assert span.from_m == pytest.approx(told[-1][0] if told else 0)
            told.append((span.to_m, (span.position, span.size)))
            if timed:
                legs = plan.times[index].legs
                assert (span.start_s, span.end_s) == (legs[span.first][0], legs[span.last][1])
        changes, at = [], 0.0
        for number in way:
            stretch = plan.stretches[number]
            at += stretch.length_m
            here = (stretch.vehicles.index(index) + 1, len(stretch.vehicles))
            if changes and changes[-1][1] == here:
                changes.pop()
            changes.append((at, here))
        assert [here for _, here in told] == [here for _, here in changes]
        assert [at for at, _ in told] == pytest.approx([at for at, _ in changes])
    led = [0.0] * len(trips)
    for run in (one for group in lead_runs(plan) for one in group):
        led[run.vehicle] += run.length_m
    together = [one for one in plan.stretches if one.together]
    for index, metres in enumerate(led):
        assert metres == pytest.approx(
            sum(one.length_m for one in together if one.vehicles[0] == index)
        )
    assert ("leads its fair share" in plan.summary()) is (plan.rotation is not None)


def test_who_leads_is_told_in_a_line():
    net = network(range(20), range(1, 21), [10e3] * 20)
    trips = [po.Trip(name, 0, 20, SIX) for name in "AB"]
    plan = planned(net, trips, lead="rotated")
    place = plan.rotation.changes[0].point.name
    begins, ends = (net.place_name(node) for node in (0, 20))
    assert (
        f"A leads from {begins} to {place} (100 km), then B to {ends} (100 km).\n"
        "Each leads its fair share to within 0 km; nobody hands on the lead before 40 km in front."
    ) in plan.summary()
    assert "A keeps its route; with B as master it would be the same." in plan.summary()
    frame = plan.to_frame("positions")
    assert list(frame["position"]) == [1, 2, 2, 1]
    assert list(frame["to_km"]) == pytest.approx([100, 200, 100, 200])
    assert list(frame["place"]) == [begins, place, begins, place]
    half = timedelta(seconds=plan.times[0].legs[0][1])
    assert next(iter(frame["end"])) == SIX + half
    untimed = planned(net, [po.Trip(name, 0, 20) for name in "AB"])
    assert "start" not in untimed.to_frame("positions")
