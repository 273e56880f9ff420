"""Who waits at its merging point may drive there slower."""

from datetime import datetime, timedelta

import pytest
from bundled import italy as italy_map

import platoon_osm as po
from platoon_osm.planning import joint
from platoon_osm.planning.timing.slower_approach import slower_approaches
from platoon_osm.report.language.plan_sentences import in_language
from platoon_osm.report.language.speech import speaking
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE

DAY = datetime(2026, 3, 2, 6)


def plan_of(last_min):
    """Brescia joins Milano on its way to Napoli; it has to leave early."""
    net = italy_map()
    late = None if last_min is None else DAY + timedelta(minutes=last_min)
    trips = [
        po.Trip("Milano", "Milano", "Napoli", DAY, DAY),
        po.Trip("Brescia", "Brescia", "Roma", DAY - timedelta(hours=2), late),
    ]
    return net, po.plan_joint(net, po.paper_weights(net), trips, "C", master="Milano")


def test_a_wait_becomes_a_slower_way(monkeypatch):
    # The wait is looked at where it arises; in the plan it is at a parking before that.
    monkeypatch.setattr(joint, "with_waits_at_parkings", lambda plan, *_: plan)
    net, plan = plan_of(-20)
    wait = max(plan.timetable.vehicles[1].waits)
    (found,) = slower_approaches(plan, net, [DEFAULT_VEHICLE] * 2)
    assert (found.vehicle, found.leg) == (1, 0)
    assert found.wait_s == pytest.approx(wait)
    assert 0 < found.longer_s <= found.wait_s
    assert 60 <= found.speed_kmh < found.usual_kmh
    length = plan.vehicles[1].legs[0].length_m
    own = plan.stretches[plan.ways[1][0]].drive_s
    assert own + found.longer_s == pytest.approx(length / found.speed_kmh * 3.6, rel=0.02)
    (remark,) = (text for text in plan.remarks if "may drive at" in text)
    assert f"{found.saved_l:.1f} litres, which the plan's cost does not count" in remark
    for language in ("de", "it"):
        with speaking(language):
            assert in_language(remark) != remark


def test_who_can_leave_later_has_nothing_to_drive_slower_for():
    _, plan = plan_of(None)
    assert max(plan.timetable.vehicles[1].waits) == 0
    assert not any("may drive at" in text for text in plan.remarks)
