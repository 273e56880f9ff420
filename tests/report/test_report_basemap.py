"""Lines: encoded and decoded, simplified, each road once."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.report.drawing.basemap import basemap_lines, metre_scale, network_lines, route_line
from platoon_osm.report.drawing.lines import Line, Lines
from platoon_osm.report.drawing.polyline import decode_lines, decode_polyline, encode_polyline
from platoon_osm.report.drawing.trails import trails
from platoon_osm.report.maps.placement import SOLID, Box, Cover
from platoon_osm.report.markup.leaflet import load_leaflet
from platoon_osm.shown_text import shown

COORDINATE = st.tuples(st.floats(-180, 180), st.floats(-85, 85))


EVERYWHERE = (-180.0, -90.0, 180.0, 90.0)


@given(st.lists(COORDINATE, min_size=2, max_size=40))
def test_polyline_round_trip(points: list[tuple[float, float]]) -> None:
    back = np.array(decode_polyline(encode_polyline(points, 10_000), 10_000))
    rounded = np.rint(np.array(points) * 10_000)
    kept = [rounded[0], *(b for a, b in pairwise(rounded) if (a != b).any())]
    if len(kept) < 2:
        kept = [rounded[0], rounded[1]]
    np.testing.assert_array_equal(np.rint(back * 10_000), kept)


@given(st.lists(COORDINATE, min_size=2, max_size=40))
def test_what_is_drawn_is_what_a_reader_decodes(points: list[tuple[float, float]]) -> None:
    line = Line.rounded(points, 100_000)
    assert line.degrees() == decode_polyline(line.encoded(), 100_000)
    assert not line.points.flags.writeable


@given(st.lists(st.lists(COORDINATE, min_size=2, max_size=9), max_size=9))
def test_many_lines_too(lines: list[list[tuple[float, float]]]) -> None:
    found = Lines.rounded(lines, 10_000)
    back = decode_lines(found.encoded(), 10_000)
    assert len(back) == len(found) == len(lines)
    for line, points in zip(found, back, strict=True):
        np.testing.assert_allclose(line.degrees(), points, atol=1e-9)


def test_polyline_of_the_published_example() -> None:
    points = [(-120.2, 38.5), (-120.95, 40.7), (-126.453, 43.252)]
    assert encode_polyline(points, 100_000) == "_p~iF~ps|U_ulLnnqC_mqNvxq`@"


def test_roads_there_and_back_are_drawn_once(net: RoadNetwork) -> None:
    from platoon_osm.network.shapes import shape_lengths_m

    lines = basemap_lines(net, np.arange(net.m), 0.0)
    first = np.concatenate([[0], np.cumsum([len(line) for line in lines])])
    flat = np.vstack(lines)
    drawn = shape_lengths_m(first, flat[:, 0], flat[:, 1]).sum()
    assert drawn == pytest.approx(net.length_m.sum() / 2, rel=1e-6)


def test_parallel_roads_of_other_shape_stay_apart() -> None:
    net = RoadNetwork.from_edges(
        [0, 0], [1, 1], lon=[9.0, 9.1], lat=[45.0, 45.0], shape_first=[0, 3, 6],
        shape_lon=[9.0, 9.05, 9.1, 9.0, 9.05, 9.1],
        shape_lat=[45.0, 45.02, 45.0, 45.0, 44.98, 45.0],
    )  # fmt: skip
    drawn = np.vstack(basemap_lines(net, np.arange(2), 20.0))
    assert {45.02, 44.98} <= set(np.round(drawn[:, 1], 6))


def test_simplified_lines_keep_to_the_road(net: RoadNetwork) -> None:
    import shapely

    scale = np.array([78_000, 111_000])
    exact = shapely.union_all(
        [shapely.linestrings(line * scale) for line in basemap_lines(net, np.arange(net.m), 0.0)]
    )
    for line in basemap_lines(net, np.arange(net.m), 20.0):
        ends = shapely.points(line * scale)
        assert shapely.distance(ends, exact).max() < 1e-6


def test_far_roads_are_drawn_coarsely(net: RoadNetwork) -> None:
    """Near a plan to 45 m, elsewhere to 800 m more; ends stay where they are."""
    scale = metre_scale(net)
    whole = network_lines(net, EVERYWHERE, inferred=False)
    far = network_lines(net, (0.0, 0.0, 1.0, 1.0), inferred=False)
    middle = (9.0, 44.0, 10.0, 46.0)
    mixed = network_lines(net, middle, inferred=False)
    assert len(far.encoded()) < len(mixed.encoded()) < len(whole.encoded())
    for lines in (far, mixed):
        for coarse, fine in zip(sorted_lines(lines), sorted_lines(whole), strict=True):
            assert coarse[0] == fine[0]
            assert coarse[-1] == fine[-1]
            near = shapely.LineString(np.array(coarse) * scale)
            assert shapely.distance(shapely.points(np.array(fine) * scale), near).max() < 815
            west, south, east, north = shapely.LineString(fine).bounds
            if lines is mixed and west <= 10 and east >= 9 and south <= 46 and north >= 44:
                assert coarse == fine


def sorted_lines(lines: Lines) -> list[list[tuple[float, float]]]:
    return sorted((line.degrees() for line in lines), key=lambda line: (line[0], line[-1], line[1]))


def test_no_lines_of_nothing(net: RoadNetwork) -> None:
    assert route_line(net, ()).encoded() == ""
    assert network_lines(net, EVERYWHERE, inferred=False).encoded()
    assert basemap_lines(net, np.zeros(0, np.int64), 20.0) == []


def test_a_box_goes_where_it_covers_least() -> None:
    cover = Cover(100, 100)
    cover.add_line([(0, 20), (100, 20)])
    on, off = Box(10, 15, 20, 10), Box(10, 40, 20, 10)
    assert cover.place([(on, 0.0), (off, 0.0)], SOLID) == off
    assert cover.place([(off, 0.0)], SOLID) is None
    assert cover.place([(Box(90, 90, 20, 20), 0.0)], SOLID) is None


def test_shown_text_keeps_names_and_drops_what_moves_them() -> None:
    assert shown("Città di Castello") == "Città di Castello"
    assert shown("a\x00b\u202ec") == "a\ufffdb\ufffdc"
    assert shown(" a\n\tb ") == "a b"
    assert shown("\ud800") == "\ufffd"
    assert len(shown("e" + "\u0301" * 50)) == 5


@given(st.text())
def test_shown_text_is_stable_and_can_be_encoded(text: str) -> None:
    once = shown(text)
    assert shown(once) == once
    assert not set(once) & set("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\x00\n")
    once.encode()


def test_leaflet_is_whole() -> None:
    leaflet = load_leaflet()
    assert "Leaflet 1.9.3" in leaflet.script
    assert "sourceMappingURL" not in leaflet.script
    assert "images/" not in leaflet.style
    assert "</" not in leaflet.style


@given(st.lists(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=2, max_size=4,
                         unique=True), max_size=9))  # fmt: skip
def test_trails_draw_what_the_lines_draw(lines: list[list[tuple[int, int]]]) -> None:
    def pieces(drawn: list[Any]) -> Counter[frozenset[tuple[int, ...]]]:
        return Counter(
            frozenset(map(tuple, pair))
            for line in drawn
            for pair in pairwise(np.asarray(line).tolist())
        )

    found = trails([np.array(line) for line in lines])
    assert pieces(found) == pieces(lines)
    assert len(found) <= len(lines)


def test_lines_go_on_straight_over_a_junction() -> None:
    cross = [[(0, 0), (2, 0)], [(2, 0), (4, 0)], [(2, -2), (2, 0)], [(2, 2), (2, 0)]]
    found = {tuple(map(tuple, one.tolist())) for one in trails([np.array(one) for one in cross])}
    assert found == {((0, 0), (2, 0), (4, 0)), ((2, -2), (2, 0), (2, 2))}
