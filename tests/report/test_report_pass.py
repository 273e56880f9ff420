"""One pass from a plan to its page: each thing is worked out once, and no line is decoded again."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import report_document, write_figures, write_flows, write_html
from platoon_osm.report.document import document as one_pass
from platoon_osm.report.document import findings
from platoon_osm.report.document.as_json import as_json
from platoon_osm.report.document.document import document_of
from platoon_osm.report.drawing import lines, polyline

ONCE = {
    findings: [
        "check_plan", "check_styles", "with_alone_costs", "plan_unit", "vehicle_styles",
        "opposite_gaps", "platoon_parts", "solo_parts", "journey",
    ],
    one_pass: [
        "find", "title_of", "subtitle_of", "totals", "groups", "timeline", "inferred_routes",
        "surroundings", "plan_frame", "junction_labels", "provenance",
    ],
}  # fmt: skip


def figures(plan: JointPlan, net: RoadNetwork, folder: Path) -> None:
    write_figures(plan, net, folder, formats=("svg",))


@pytest.mark.parametrize("write", [write_html, write_flows, figures])
def test_each_builder_is_called_once(
    write: Callable[..., Any],
    plan: JointPlan,
    net: RoadNetwork,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    calls: Counter[str] = Counter()

    def counted(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            calls[name] += 1
            return function(*arguments, **options)

        return call

    for module, names in ONCE.items():
        for name in names:
            monkeypatch.setattr(module, name, counted(name, getattr(module, name)))
    monkeypatch.setattr(findings, "moment_of", counted("moment_of", findings.moment_of))
    write(plan, net, tmp_path if write is figures else tmp_path / "page.html")
    assert calls.pop("moment_of") == 4
    assert calls == dict.fromkeys([name for names in ONCE.values() for name in names], 1)


@pytest.mark.parametrize("write", [write_html, write_flows, figures])
def test_nothing_is_decoded_that_was_encoded_here(
    write: Callable[..., Any],
    plan: JointPlan,
    net: RoadNetwork,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def never(*_: Any) -> Any:
        raise AssertionError("a line was decoded")

    for name in ("decode_polyline", "decode_lines"):
        monkeypatch.setattr(polyline, name, never)
    if write is not write_html:
        # Only a live map carries encoded lines.
        monkeypatch.setattr(lines, "encode_steps", never)
    write(plan, net, tmp_path if write is figures else tmp_path / "page.html")


def test_json_has_the_fields_of_the_records(plan: JointPlan, net: RoadNetwork) -> None:
    document = document_of(plan, net)
    found = report_document(plan, net)
    assert found == as_json(document)
    shown = [one.name for one in fields(document) if one.metadata.get("json", True)]
    # Money and chances are told where the plan has them.
    absent = [name for name in ("bill", "gain", "chances") if getattr(document, name) is None]
    assert absent == ["bill", "gain", "chances"]
    assert list(found) == [name for name in shown if name not in absent]

    def compare(record: Any, data: Any) -> None:
        if is_dataclass(record) and isinstance(data, dict):
            shown = [one.name for one in fields(record) if one.metadata.get("json", True)]
            assert list(data) == shown
            for name in shown:
                compare(getattr(record, name), data[name])
        elif isinstance(record, tuple) and isinstance(data, list):
            assert len(record) == len(data)
            for one, other in zip(record, data, strict=True):
                compare(one, other)

    for name, value in found.items():
        compare(getattr(document, name), value)
    # What drawings alone need is not told to readers.
    assert list(found["cost_unit"]) == ["label", "note", "name"]
