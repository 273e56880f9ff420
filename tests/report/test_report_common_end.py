"""Who drives on together to a common end does not separate there."""

from __future__ import annotations

import pytest
from plan_kinds import plan_kind

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
