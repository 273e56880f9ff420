"""Connectors put back at interchanges that an extract without ramps has lost."""

import numpy as np
import pytest
from made_networks import both_ways, network

from platoon_osm.network.geodesy import bearing_deg
from platoon_osm.network.preparing.inferred_links import SHORTEST_RAMP_M, infer_links
from platoon_osm.search.engine import many_to_many

FAR = 10_000
GAP = 30


def crossing_motorways():
    """Two motorways of two carriageways each that cross without a common node."""
    nodes = [
        (-FAR, 0), (FAR, 0),  # 0 -> 1 eastbound
        (FAR, GAP), (-FAR, GAP),  # 2 -> 3 westbound
        (GAP, -FAR), (GAP, FAR),  # 4 -> 5 northbound
        (0, FAR), (0, -FAR),  # 6 -> 7 southbound
    ]  # fmt: skip
    return network(
        nodes, [(0, 1), (2, 3), (4, 5), (6, 7)], ref=["A1", "A1", "A2", "A2"], way_id=[1, 2, 3, 4]
    )


STARTS = {"east": 0, "west": 2, "north": 4, "south": 6}
ENDS = {"east": 1, "west": 3, "north": 5, "south": 7}
BACK = {"east": "west", "west": "east", "north": "south", "south": "north"}


def ways(net, starts, ends):
    table = many_to_many(net, net.length_m, list(starts.values()), list(ends.values()))
    return {
        (a, b): table[i, j] for i, a in enumerate(starts) for j, b in enumerate(ends)
    }  # fmt: skip


def connectors(net):
    """Each connector with the turn it asks for, from the road before it to the road after."""
    found = []
    for e in np.flatnonzero(net.inferred):
        before = [x for x in range(net.m) if net.head[x] == net.tail[e] and not net.inferred[x]]
        after = [x for x in range(net.m) if net.tail[x] == net.head[e] and not net.inferred[x]]
        assert before, "a connector that comes from nowhere"
        assert after, "a connector that leads nowhere"
        turns = []
        for x in before:
            for y in after:
                a, b = net.shape(x)[-2:], net.shape(y)[:2]
                turn = float(bearing_deg(*b[0], *b[1]) - bearing_deg(*a[0], *a[1]))
                turns.append(abs((turn + 180) % 360 - 180))
        found.append((int(e), min(turns)))
    return found


def test_a_crossing_joins_every_direction_to_every_other():
    before = ways(crossing_motorways(), STARTS, ENDS)
    assert {pair for pair, km in before.items() if np.isfinite(km)} == {(d, d) for d in STARTS}
    joined = infer_links(crossing_motorways())
    after = ways(joined, STARTS, ENDS)
    for start in STARTS:
        for end in ENDS:
            if end != BACK[start]:
                # 20 km of road and at most one short ramp on either side.
                assert 19_000 < after[start, end] < 21_000, (start, end)


def test_no_connector_turns_back():
    joined = infer_links(crossing_motorways())
    for edge, turn in connectors(joined):
        pair = {int(joined.tail[edge]), int(joined.head[edge])}
        # Only where both carriageways of a road end at the edge of the data is there a way back.
        at_the_edge = pair <= set(STARTS.values()) | set(ENDS.values())
        assert turn < 150 or at_the_edge


def test_opposite_carriageways_are_never_joined_along_the_road():
    # One motorway, its ends farther apart than the reach: nothing to infer at all.
    nodes = [(0, 0), (FAR, 0), (FAR - 500, GAP), (500, GAP)]
    joined = infer_links(network(nodes, [(0, 1), (2, 3)]))
    assert not joined.inferred.any()
    assert joined.m == 2


def test_everything_added_is_marked_and_nothing_else():
    net = crossing_motorways()
    joined = infer_links(net)
    added = joined.inferred
    assert added.any()
    assert joined.length_m[~added].sum() == pytest.approx(net.length_m.sum())
    assert set(joined.way_id[~added]) == {1, 2, 3, 4}
    assert set(joined.way_id[added]) == {0}
    assert {joined.edge_ref(int(e)) for e in np.flatnonzero(added)} == {""}
    assert (joined.length_m[added] >= SHORTEST_RAMP_M).all()
    assert (joined.road_class[added] == 1).all()
    assert joined.speed_mps[added] == pytest.approx(50 / 3.6)
    assert not joined.toll[added].any()


def test_the_report_counts_and_warns():
    joined = infer_links(crossing_motorways())
    report = joined.report()
    assert report["crossings of carriageways without a common node"] == 4
    assert report["connectors inferred"] == joined.inferred.sum()
    # With its four ends closed by ways back, all of the road hangs together.
    assert "were inferred, not mapped" in report.remarks[0]
    assert "100% of the carriageway-km instead of 0%" in report.remarks[0]


def test_a_crossing_that_is_already_joined_stays_as_it_is():
    nodes = [(-FAR, 0), (FAR, 0), (0, -FAR), (0, FAR), (0, 0)]
    net = network(nodes, both_ways([(0, 4), (4, 1), (2, 4), (4, 3)]))
    joined = infer_links(net)
    assert not joined.inferred.any()
    assert (joined.n, joined.m) == (net.n, net.m)
    assert joined.report()["connectors inferred"] == 0


def test_one_carriageway_that_ends_goes_on_to_the_one_ahead():
    # A ramp is missing: 0 -> 1 stops 100 m before the road 2 -> 3, which bends away to the right.
    net = network([(0, 0), (5_000, 0), (5_090, 40), (9_000, 40)], [(0, 1), (2, 3)])
    joined = infer_links(net)
    assert np.isfinite(many_to_many(joined, joined.length_m, [0], [3])[0, 0])
    # And no way from the second road back to the first.
    assert np.isinf(many_to_many(joined, joined.length_m, [2], [1])[0, 0])


def test_out_of_reach_nothing_is_joined():
    net = network([(0, 0), (5_000, 0), (5_400, 0), (9_000, 0)], [(0, 1), (2, 3)])
    assert not infer_links(net).inferred.any()
    assert infer_links(net, reach_m=500).inferred.any()


def test_a_carriageway_joins_the_middle_of_one_that_passes():
    # A motorway ends at right angles 80 m before another one, as at a T-shaped interchange.
    net = network([(0, 0), (8_000, 0), (4_000, -6_000), (4_000, -80)], [(0, 1), (2, 3)])
    joined = infer_links(net)
    onto = many_to_many(joined, joined.length_m, [2], [1])[0, 0]
    assert onto == pytest.approx(5_920 + SHORTEST_RAMP_M + 4_000, rel=0.02)
    assert np.isinf(many_to_many(joined, joined.length_m, [0], [3])[0, 0])


def test_where_both_carriageways_end_there_is_a_way_back():
    nodes = [(0, 0), (FAR, 0), (FAR, GAP), (0, GAP)]
    joined = infer_links(network(nodes, [(0, 1), (2, 3)]))
    added = np.flatnonzero(joined.inferred)
    assert {(int(joined.tail[e]), int(joined.head[e])) for e in added} == {(1, 2), (3, 0)}
    assert joined.report()["carriageway ends with a way back"] == 2
    assert (joined.strong_component() == 0).all()


def test_carriageways_that_run_side_by_side_are_joined():
    # Express lanes beside the main lanes, same direction, never touching.
    net = network([(0, 0), (FAR, 0), (1_000, 60), (FAR - 1_000, 60)], [(0, 1), (2, 3)])
    joined = infer_links(net)
    table = many_to_many(joined, joined.length_m, [0, 2], [1, 3])
    assert np.isfinite(table).all()


def test_a_road_under_a_long_bridge_of_itself_is_no_crossing():
    # A loop of one edge that crosses itself: the truck is on it already.
    net = network([(0, 0), (3_000, 3_000)], [(0, 1, [(3_000, 0), (3_000, 1_500), (1_000, -1_500)])])
    assert not infer_links(net).inferred.any()
