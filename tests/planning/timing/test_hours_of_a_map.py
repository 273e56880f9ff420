"""From the tags of a map to a plan that keeps to them."""

from datetime import datetime

import pytest

import platoon_osm as po

NODES = {1: 11.0, 2: 11.5, 3: 12.0, 4: 12.5}
MOTORWAY = {"highway": "motorway", "oneway": "yes", "maxspeed": "100"}


def written(folder, **tags):
    """Write a motorway of three ways with junctions between them; the middle one has more tags."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6">']
    for node, lon in NODES.items():
        lines.append(
            f'<node id="{node}" lon="{lon}" lat="46.0">'
            f'<tag k="highway" v="motorway_junction"/><tag k="name" v="J{node}"/></node>'
        )
        lines.append(f'<node id="{node + 10}" lon="{lon}" lat="46.05"/>')
    for way, node in enumerate((1, 2, 3), 100):
        own = {**MOTORWAY, "ref": f"A {node}", **(tags if node == 2 else {})}
        told = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in own.items())
        lines.append(f'<way id="{way}"><nd ref="{node}"/><nd ref="{node + 1}"/>{told}</way>')
    for node in NODES:
        ends = f'<nd ref="{node}"/><nd ref="{node + 10}"/>'
        lines.append(
            f'<way id="{node + 200}">{ends}<tag k="highway" v="motorway_link"/>'
            '<tag k="oneway" v="yes"/></way>'
        )
    path = folder / "hours.osm"
    path.write_text("\n".join([*lines, "</osm>"]), "utf-8")
    return path


@pytest.mark.parametrize(
    ("tags", "leaves"),
    [
        ({}, "2026-03-02T22:00"),
        ({"hgv:conditional": "no @ (22:00-05:00)"}, "2026-03-03T04:31"),
        ({"hgv:conditional": "no @ (22:00-05:00 AND weight>44)"}, "2026-03-02T22:00"),
        ({"hgv:forward:conditional": "no @ (22:00-05:00)"}, "2026-03-03T04:31"),
        ({"hgv:backward:conditional": "no @ (22:00-05:00)"}, "2026-03-02T22:00"),
        ({"motor_vehicle:conditional": "no @ (Mo-Fr 21:00-23:00)"}, "2026-03-02T22:31"),
        ({"maxweight:conditional": "30 @ (22:00-05:00)"}, "2026-03-03T04:31"),
    ],
)
def test_a_motorway_with_hours_is_passed_while_it_is_open(tmp_path, tags, leaves):
    net = po.load_network(written(tmp_path, **tags), country="DE")
    trip = po.Trip("A", "J1", "J4", datetime(2026, 3, 2, 22))
    plan = po.plan_joint(net, po.paper_weights(net), [trip])
    left = plan.timetable.clock.moment(plan.timetable.vehicles[0].departure_s)
    assert abs((left - datetime.fromisoformat(leaves)).total_seconds()) < 150
    assert any("keeps to the hours of A 2" in remark for remark in plan.remarks) == (
        left != datetime(2026, 3, 2, 22)
    )
