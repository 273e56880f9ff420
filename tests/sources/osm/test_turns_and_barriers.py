"""Turn restrictions and barriers of OSM files, driven by trucks and vans.

          8 (way 13, the longer way)
        /   \\
  1 - 2       3 - 4     one-way from west to east; way 11 is 1-2, way 14 is 3-4
        \\   /
          7 (way 12)
"""

import numpy as np
import pytest
from osm_files import MOTORWAY, write

import platoon_osm as po
from platoon_osm.errors import NoRouteError

NODES = {
    1: (11.00, 45.0, {"highway": "motorway_junction", "name": "Westheim"}),
    2: (11.10, 45.0, {}),
    3: (11.30, 45.0, {}),
    4: (11.40, 45.0, {"highway": "motorway_junction", "name": "Ostheim"}),
    7: (11.20, 44.99, {}),
    8: (11.20, 45.10, {}),
}
WAYS = {
    11: ([1, 2], MOTORWAY), 12: ([2, 7, 3], MOTORWAY), 13: ([2, 8, 3], MOTORWAY),
    14: ([3, 4], MOTORWAY),
}  # fmt: skip
TURN = [("way", 11, "from"), ("node", 2, "via"), ("way", 12, "to")]
KIND = {"type": "restriction"}


def load(folder, relations=None, nodes=None, ways=None, suffix=".osm"):
    path = write(
        folder, {**NODES, **(nodes or {})}, {**WAYS, **(ways or {})}, suffix, relations=relations
    )
    return po.load_network(path)


def ways_driven(net, profile="eu-40t", case="C"):
    plan = po.plan_joint(
        net, po.paper_weights(net), [po.Trip("A", "Westheim", "Ostheim")], case, profile=profile
    )
    edges = [e for k in plan.ways[0] for e in plan.stretches[k].edges]
    return [int(way) for way in dict.fromkeys(net.way_id[edges].tolist())]


def by(net):
    """Which way a truck drives, and which a van; 0 for none."""
    found = []
    for kind in ("eu-40t", "van-3.5t"):
        try:
            (middle,) = [way for way in ways_driven(net, kind) if way in (12, 13, 15)][:1] or [11]
        except NoRouteError:
            middle = 0
        found.append(middle)
    return tuple(found)


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
@pytest.mark.parametrize(
    ("members", "tags", "driven"),
    [
        (TURN, {"restriction": "no_right_turn"}, (13, 13)),
        (TURN, {"restriction:hgv": "no_right_turn"}, (13, 12)),
        (TURN, {"type": "restriction:hgv", "restriction": "no_right_turn"}, (13, 12)),
        (TURN, {"restriction": "no_right_turn", "except": "psv"}, (13, 13)),
        (TURN, {"restriction": "no_right_turn", "except": "psv;hgv"}, (12, 13)),
        (TURN, {"restriction:motorcar": "no_right_turn"}, (12, 12)),
        (TURN, {"restriction:conditional": "no_right_turn @ (weight>7.5)"}, (13, 12)),
        (TURN, {"restriction:hgv:conditional": "no_right_turn @ (length>12)"}, (13, 12)),
        (TURN, {"restriction:conditional": "no_right_turn @ (07:00-09:00)"}, (12, 12)),
        ([("way", 11, "from"), ("node", 2, "via"), ("way", 13, "to")],
         {"restriction": "only_left_turn"}, (13, 13)),
        ([("way", 11, "from"), ("node", 2, "via"), ("way", 13, "to")],
         {"restriction:hgv": "only_left_turn"}, (13, 12)),
        ([("way", 11, "from"), ("way", 12, "via"), ("way", 14, "to")],
         {"restriction": "no_straight_on"}, (13, 13)),
        ([("way", 11, "from"), ("way", 12, "via"), ("way", 14, "to")],
         {"restriction:goods": "no_straight_on"}, (13, 13)),
        ([("way", 12, "from"), ("node", 3, "via"), ("way", 14, "to")],
         {"restriction": "no_entry"}, (13, 13)),
        ([("way", 11, "from"), ("node", 2, "via"), ("way", 12, "to"), ("way", 13, "to")],
         {"restriction": "no_exit"}, (0, 0)),
        # None of these says which turn, or says it of others.
        (TURN[:2], {"restriction": "no_right_turn"}, (12, 12)),
        (TURN, {"restriction": "right_turn"}, (12, 12)),
        (TURN, {}, (12, 12)),
        ([("way", 11, "from"), ("node", 4, "via"), ("way", 12, "to")],
         {"restriction": "no_right_turn"}, (12, 12)),
        ([("way", 99, "from"), ("node", 2, "via"), ("way", 12, "to")],
         {"restriction": "no_right_turn"}, (12, 12)),
        (TURN, {"restriction": "no_right_turn", "day_on": "Monday"}, (12, 12)),
    ],
)  # fmt: skip
def test_turns(tmp_path, members, tags, driven, suffix):
    net = load(tmp_path, {1: (members, {**KIND, **tags})}, suffix=suffix)
    assert by(net) == driven
    counts = net.report().counts
    obeyed = counts.get("turn restrictions obeyed", 0)
    ignored = sum(n for name, n in counts.items() if name.startswith("turn restrictions ignored: "))
    assert counts["turn restrictions read"] == obeyed + ignored == 1
    conditional = any("07:00" in value for value in tags.values())
    assert obeyed == (driven != (12, 12) or conditional)


def test_whoever_starts_at_the_node_may_drive_on(tmp_path):
    net = load(tmp_path, {1: (TURN, {**KIND, "restriction": "no_right_turn"})})
    plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", po.Place(osmid=2), "Ostheim")])
    edges = [e for k in plan.ways[0] for e in plan.stretches[k].edges]
    assert 12 in net.way_id[edges]


def test_a_trip_may_end_at_the_node_of_a_turn(tmp_path):
    named = {2: (11.10, 45.0, {"highway": "motorway_junction", "name": "Gabel"})}
    net = load(tmp_path, {1: (TURN, {**KIND, "restriction": "no_right_turn"})}, named)
    for place in ("Gabel", po.Place(osmid=2), (11.10, 45.0)):
        plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", "Westheim", place)])
        assert plan.vehicles[0].length_m == pytest.approx(net.length_m[0], rel=1e-3)


def test_no_u_turn_at_the_end_of_a_two_way_road(tmp_path):
    two_way = {"highway": "trunk", "maxspeed": "60"}
    nodes = {1: NODES[1], 2: NODES[2], 4: NODES[4]}
    ways = {21: ([1, 2], two_way), 22: ([2, 4], two_way)}
    turn = {1: ([("way", 21, "from"), ("node", 2, "via"), ("way", 21, "to")],
                {**KIND, "restriction": "no_u_turn"})}  # fmt: skip
    path = write(tmp_path, nodes, ways, relations=turn)
    net = po.load_network(path, ["trunk"])
    assert net.report()["turn restrictions obeyed"] == 1
    (leaving,) = np.flatnonzero(net.node_id[net.tail] == 1)
    assert net.node_id[net.head[leaving]] == 4


@pytest.mark.parametrize(
    ("tags", "driven"),
    [
        ({"barrier": "gate"}, (12, 12)),
        ({"barrier": "gate", "access": "no"}, (13, 13)),
        ({"barrier": "gate", "access": "private"}, (13, 13)),
        ({"barrier": "gate", "access": "no", "hgv": "yes"}, (12, 13)),
        ({"barrier": "gate", "locked": "yes"}, (13, 13)),
        ({"barrier": "lift_gate", "hgv": "no"}, (13, 12)),
        ({"barrier": "bollard"}, (13, 13)),
        ({"barrier": "bollard", "motor_vehicle": "yes"}, (12, 12)),
        ({"barrier": "height_restrictor", "maxheight": "3"}, (13, 12)),
        ({"barrier": "border_control"}, (12, 12)),
        ({"barrier": "toll_booth", "name": "Barriera"}, (12, 12)),
        ({"barrier": "yes"}, (12, 12)),
    ],
)
def test_barriers(tmp_path, tags, driven):
    net = load(tmp_path, nodes={7: (11.20, 44.99, tags)})
    assert by(net) == driven
    counts = net.report().counts
    assert counts["barriers on roads read"] == 1
    assert counts.get("barriers obeyed", 0) == (driven != (12, 12) or "motor_vehicle" in tags)


def test_a_barrier_where_roads_meet_is_counted(tmp_path):
    net = load(tmp_path, nodes={2: (11.10, 45.0, {"barrier": "bollard"})})
    assert by(net) == (12, 12)
    assert net.report()["barriers where roads meet, not obeyed"] == 1


def test_a_private_gate_is_open_to_who_lives_behind_it(tmp_path):
    yard = {"highway": "tertiary"}
    nodes = {5: (11.35, 45.02, {"barrier": "gate", "access": "private"}), 6: (11.35, 45.03, {}),
             9: (11.35, 45.0, {})}  # fmt: skip
    ways = {14: ([3, 9, 4], MOTORWAY), 16: ([9, 5, 6], yard)}
    path = write(tmp_path, {**NODES, **nodes}, {**WAYS, **ways})
    net = po.load_network(path, ["motorway", "tertiary"])
    weights = po.paper_weights(net)
    plan = po.plan_joint(net, weights, [po.Trip("A", "Westheim", po.Place(osmid=6))])
    edges = [e for k in plan.ways[0] for e in plan.stretches[k].edges]
    assert net.node_id[net.head[edges[-1]]] == 6


def test_copies_do_not_change_what_else_is_driven(tmp_path):
    plain = load(tmp_path)
    split = load(tmp_path, {1: (TURN, {**KIND, "restriction:hgv": "no_right_turn"})})
    assert split.m > plain.m
    both = (net.report()["ways kept"] for net in (plain, split))
    assert len(set(both)) == 1
    assert set(split.node_id.tolist()) - set(plain.node_id.tolist()) == {7, 8}
