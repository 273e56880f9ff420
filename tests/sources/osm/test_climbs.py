"""Heights of nodes and slopes of ways, as they are kept with edges."""

import itertools
import xml.sax.saxutils
from math import isnan

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.grades import grade, graded_share
from platoon_osm.sources.load import load_network

ROAD = {"highway": "primary"}
LON = 9.0
STEP = 0.01  # 788 m on the parallel of these maps


def write(file, nodes, ways):
    """Write nodes {id: (lon, lat, ele or None)} and ways {id: (nodes, tags)}."""

    def tags(items):
        return "".join(
            f"<tag k={xml.sax.saxutils.quoteattr(key)} v={xml.sax.saxutils.quoteattr(value)}/>"
            for key, value in items.items()
        )

    lines = ['<osm version="0.6">']
    for node, (lon, lat, ele) in nodes.items():
        own = {} if ele is None else {"ele": str(ele)}
        lines.append(f'<node id="{node}" lon="{lon!r}" lat="{lat!r}">{tags(own)}</node>')
    for way, (refs, own) in ways.items():
        nds = "".join(f'<nd ref="{ref}"/>' for ref in refs)
        lines.append(f'<way id="{way}">{nds}{tags({**ROAD, **own})}</way>')
    file.write_text("\n".join([*lines, "</osm>"]))
    return file


def line(*heights):
    return {k + 1: (LON + STEP * k, 45.0, ele) for k, ele in enumerate(heights)}


def load(tmp_path, nodes, ways, **more):
    return load_network(
        write(tmp_path / "map.osm", nodes, ways), classes=["primary"], country="IT", **more
    )


def edge(net, start, end):
    """Return the edge between two nodes by their ids."""
    ids = net.node_id
    (found,) = [
        e for e in range(net.m) if (ids[net.tail[e]], ids[net.head[e]]) == (start, end)
    ]  # fmt: skip
    return found


def told(net, start, end):
    """Return climb, descent [m] and known share of an edge."""
    e = edge(net, start, end)
    return (
        pytest.approx(float(net.climb_m[e]), abs=1e-3),
        pytest.approx(float(net.descent_m[e]), abs=1e-3),
        pytest.approx(float(graded_share(net)[e]), abs=1e-4),
    )


def test_the_difference_of_two_heights_is_climb_one_way_and_descent_the_other(tmp_path):
    net = load(tmp_path, line(200, 230), {1: ([1, 2], {})})
    assert told(net, 1, 2) == (30, 0, 1)
    assert told(net, 2, 1) == (0, 30, 1)
    assert net.report().counts["nodes with a height"] == 2
    assert net.report().counts["km of known grade"] == 2


def test_ups_and_downs_between_add_up(tmp_path):
    net = load(tmp_path, line(200, 230, 210, 215), {1: ([1, 2, 3, 4], {})})
    assert told(net, 1, 4) == (35, 20, 1)
    assert told(net, 4, 1) == (20, 35, 1)


def test_a_node_between_without_a_height_lies_on_the_slope(tmp_path):
    nodes = line(200, None, 230)
    nodes[2] = (LON + STEP / 2, 45.0, None)
    # A junction in the middle shows how much of the climb comes before it.
    nodes[9] = (LON + STEP / 2, 45.01, None)
    net = load(tmp_path, nodes, {1: ([1, 2, 3], {}), 2: ([2, 9], {})})
    assert told(net, 1, 2) == (7.5, 0, 1)
    assert told(net, 2, 3) == (22.5, 0, 1)
    assert told(net, 3, 2) == (0, 22.5, 1)
    assert told(net, 2, 9) == (0, 0, 0)


def test_beyond_the_last_height_nothing_is_known(tmp_path):
    net = load(tmp_path, line(None, 200, 230, None), {1: ([1, 2, 3, 4], {})})
    assert told(net, 1, 4) == (30, 0, 1 / 3)
    assert grade(net)[edge(net, 1, 4)] == pytest.approx(30 / 788.5, rel=1e-3)


def test_one_way_alone_says_nothing_of_another(tmp_path):
    net = load(tmp_path, line(200, None, 230), {1: ([1, 2], {}), 2: ([2, 3], {})})
    assert told(net, 1, 3) == (0, 0, 0)


def test_incline_holds_where_heights_are_not_known(tmp_path):
    nodes = line(200, 230, None)
    net = load(tmp_path, nodes, {1: ([1, 2, 3], {"incline": "-4%"})})
    assert told(net, 1, 3) == (30, pytest.approx(0.04 * 788.5, rel=1e-3), 1)
    assert told(net, 3, 1) == (pytest.approx(0.04 * 788.5, rel=1e-3), 30, 1)


def test_incline_is_that_of_the_way_as_it_is_drawn(tmp_path):
    nodes = line(None, None)
    against = load(tmp_path, nodes, {1: ([1, 2], {"incline": "4%", "oneway": "-1"})})
    assert told(against, 2, 1) == (0, pytest.approx(31.5, rel=2e-3), 1)
    back = load(tmp_path, nodes, {1: ([1, 2], {"incline:backward": "4%"})})
    assert told(back, 2, 1) == (pytest.approx(31.5, rel=2e-3), 0, 1)


def test_level_road_is_known_to_be_level(tmp_path):
    net = load(tmp_path, line(None, None), {1: ([1, 2], {"incline": "0%"})})
    assert told(net, 1, 2) == (0, 0, 1)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("up", "incline without a size (up, down)"),
        ("steep", "incline not understood"),
        ("75%", "incline of more than 30 %, ignored"),
    ],
)
def test_what_an_incline_does_not_say_is_counted_and_not_made_up(tmp_path, text, count):
    net = load(tmp_path, line(None, None, None), {1: ([1, 2], {"incline": text}), 2: ([2, 3], {})})
    assert net.report().counts[count] == 1
    for values in (net.climb_m, net.descent_m, net.graded_m):
        assert not values.any()
    assert "km of known grade" not in net.report().counts


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("high", "ele not understood"),
        ("12000", "ele too high or too low for a road, ignored"),
        (500, "stretches of more than 30 % between nodes with ele, ignored"),
    ],
)
def test_heights_that_cannot_be_are_counted_and_the_rest_is_used(tmp_path, text, count):
    net = load(tmp_path, line(200, text, 230), {1: ([1, 2, 3], {"incline": "1%"})})
    assert net.report().counts[count] == (2 if text == 500 else 1)
    climbed = 0.01 * 2 * 788.5 if text == 500 else 30
    assert told(net, 1, 3) == (pytest.approx(climbed, rel=2e-3), 0, 1)


def test_heights_beside_the_road_and_on_roads_of_other_classes_are_not_counted(tmp_path):
    nodes = {**line(200, 230, 260), 7: (LON, 45.3, "peak")}
    ways = {1: ([1, 2], {}), 2: ([2, 3], {"highway": "residential"})}
    net = load(tmp_path, nodes, ways)
    assert net.report().counts["nodes with a height"] == 2
    assert "ele not understood" not in net.report().counts


def test_a_node_that_is_missing_or_listed_twice(tmp_path):
    nodes = line(200, None, 230, None, 260)
    del nodes[4]
    net = load(tmp_path, nodes, {1: ([1, 2, 2, 3, 4, 5], {})})
    assert told(net, 1, 3) == (30, 0, 1)
    assert net.m == 2


def test_a_ring_comes_back_to_its_height(tmp_path):
    nodes = {
        1: (9.0, 45.0, 200), 2: (9.01, 45.0, 240), 3: (9.01, 45.01, None), 4: (8.99, 45.0, None),
    }  # fmt: skip
    net = load(tmp_path, nodes, {1: ([1, 2, 3, 1], {"oneway": "yes"}), 2: ([4, 1], {})})
    assert told(net, 1, 1) == (40, 40, 1)


def test_the_last_version_of_a_node_counts(tmp_path):
    file = tmp_path / "twice.osm"
    one = write(tmp_path / "one.osm", line(200, 210), {1: ([1, 2], {})}).read_text()
    other = write(tmp_path / "two.osm", line(200, 230), {2: ([1, 2], {"oneway": "yes"})})
    both = other.read_text().replace('<osm version="0.6">', "")
    file.write_text(one.replace("</osm>", "") + both)
    net = load_network(file, classes=["primary"], country="IT")
    assert told(net, 2, 1) == (0, 30, 1)


def test_a_height_that_was_taken_back_is_none_any_more(tmp_path):
    file = tmp_path / "history.osh"
    file.write_text(
        '<osm version="0.6"><node id="1" version="1" lon="9.0" lat="45.0"><tag k="ele" v="200"/>'
        '</node><node id="2" version="1" lon="9.01" lat="45.0"><tag k="ele" v="900"/></node>'
        '<node id="2" version="2" lon="9.01" lat="45.0"/><node id="3" version="1" lon="9.02" '
        'lat="45.0"><tag k="ele" v="230"/></node><way id="1" version="1"><nd ref="1"/>'
        '<nd ref="2"/><nd ref="3"/><tag k="highway" v="primary"/></way></osm>'
    )
    net = load_network(file, classes=["primary"], country="IT")
    assert told(net, 1, 3) == (30, 0, 1)


def brute_force(nodes, ways):
    """Return climb, descent, known length by (tail, head) of each segment, in plain loops."""
    found = {}
    for refs, tags in ways.values():
        heights = [nodes[ref][2] for ref in refs]
        lengths = [
            float(distance_m(*nodes[u][:2], *nodes[v][:2])) for u, v in itertools.pairwise(refs)
        ]
        own = float(tags.get("incline", "nan%").rstrip("%")) / 100
        for k, (u, v) in enumerate(itertools.pairwise(refs)):
            before = [i for i in range(k + 1) if heights[i] is not None]
            after = [i for i in range(k + 1, len(refs)) if heights[i] is not None]
            slope = own
            if before and after:
                i, j = before[-1], after[0]
                between = (heights[j] - heights[i]) / sum(lengths[i:j])
                slope = between if abs(between) <= 0.3 else own
            rise = 0.0 if isnan(slope) else slope * lengths[k]
            known = 0.0 if isnan(slope) else lengths[k]
            found[u, v] = [max(rise, 0.0), max(-rise, 0.0), known]
            if tags.get("oneway") != "yes":
                found[v, u] = [max(-rise, 0.0), max(rise, 0.0), known]
    return found


@st.composite
def maps(draw):
    """Draw a line of nodes cut into ways, with spurs so that some of its nodes are junctions."""
    count = draw(st.integers(2, 9))
    height = st.one_of(st.none(), st.integers(0, 300))
    nodes = {k: (9 + 0.01 * k, 45.0, draw(height)) for k in range(1, count + 1)}
    cuts = draw(st.lists(st.integers(2, count), unique=True, max_size=3))
    bounds = sorted({1, *cuts, count})
    slope = st.one_of(st.none(), st.integers(-60, 60))
    ways = {}
    for way, (begin, end) in enumerate(itertools.pairwise(bounds), 1):
        own = draw(slope)
        tags = {} if own is None else {"incline": f"{own}%"}
        ways[way] = list(range(begin, end + 1)), tags
    for spur in draw(st.lists(st.integers(1, count), unique=True, max_size=3)):
        nodes[100 + spur] = (9 + 0.01 * spur, 45.005, draw(height))
        ways[100 + spur] = [spur, 100 + spur], {}
    return nodes, ways


@settings(
    max_examples=50, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(maps())
def test_edges_are_the_sums_of_their_segments(tmp_path, drawn):
    nodes, ways = drawn
    for text in ways.values():
        slope = float(text[1].get("incline", "0%").rstrip("%"))
        if abs(slope) > 30:  # steeper than any road: as if it were not there
            text[1].pop("incline")
    expected = brute_force(nodes, ways)
    net = load(tmp_path, nodes, ways)
    at = {place[:2]: node for node, place in nodes.items()}
    for e in range(net.m):
        path = [at[round(lon, 7), round(lat, 7)] for lon, lat in net.shape(e).tolist()]
        parts = [expected[pair] for pair in itertools.pairwise(path)]
        for values, k in ((net.climb_m, 0), (net.descent_m, 1), (net.graded_m, 2)):
            assert float(values[e]) == pytest.approx(
                sum(part[k] for part in parts), rel=1e-4, abs=1e-3
            )


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(maps(), st.data())
def test_where_all_heights_are_known_a_path_rises_by_their_difference(tmp_path, drawn, data):
    nodes, ways = drawn
    known = {
        node: (lon, lat, ele if ele is not None else data.draw(st.integers(0, 150)) % 150)
        for node, (lon, lat, ele) in nodes.items()
    }
    known = {node: (lon, lat, ele % 150) for node, (lon, lat, ele) in known.items()}
    net = load(tmp_path, known, ways)
    ids = net.node_id.tolist()
    for start, end in itertools.product(range(net.n), repeat=2):
        rise = rise_between(net, start, end)
        assert rise == pytest.approx(known[ids[end]][2] - known[ids[start]][2], abs=1e-2)


def rise_between(net, start, end):
    """Return climb - descent along some path, by a search in plain Python."""
    reached, waiting = {start: 0.0}, [start]
    while waiting:
        node = waiting.pop()
        for e in range(net.first_out[node], net.first_out[node + 1]):
            head = int(net.head[e])
            if head not in reached:
                reached[head] = reached[node] + float(net.climb_m[e]) - float(net.descent_m[e])
                waiting.append(head)
    return reached[end]
