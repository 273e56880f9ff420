"""Who drives on together to a common end does not separate there."""

from __future__ import annotations

import pytest
from plan_kinds import italy, plan_kind

import platoon_osm as po
from platoon_osm.report import report_document


@pytest.mark.parametrize("kind", ["all end together", "the same trip thrice"])
def test_vehicles_that_end_together_arrive_together(kind: str) -> None:
    plan, net = plan_kind(kind)
    document = report_document(plan, net)
    assert any(event.kind == "separation" for event in plan.events)
    assert {event["kind"] for event in document["events"]} == {"merge"}
    assert "separation" not in document["subtitle"]
    assert "arriving together at Trieste" in document["events"][-1]["detail"]


def test_who_parts_on_the_way_separates() -> None:
    plan, net = plan_kind("three vehicles")
    events = report_document(plan, net)["events"]
    assert [event["kind"] for event in events].count("separation") == 2
    assert not any("together" in event["detail"] for event in events)


@pytest.mark.parametrize(
    ("ends", "told"),
    [
        (("Trieste", "A4/A22 Verona", "A4/A22 Verona"), "B and C arrive"),
        (("Trieste", "Brennero", "A4/A22 Verona"), "B and C leave"),
        (("Trieste", "Brennero", "Brennero"), "B and C leave"),
    ],
)
def test_an_end_of_some_is_a_separation(ends: tuple[str, ...], told: str) -> None:
    net = italy()
    trips = [po.Trip(name, "Torino", end) for name, end in zip("ABC", ends, strict=True)]
    plan = po.plan_joint(net, po.PaperCosts(), trips, "B", master="A")
    events = report_document(plan, net)["events"]
    assert [event["text"] for event in events if event["kind"] == "separation"][:1] == [told]
