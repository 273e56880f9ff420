"""Lines beside roads: near them, without loops or spikes, alike on still and live maps."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from platoon_osm.report.maps.beside import laid, laid_beside, shifted

Floats = NDArray[np.float64]

ASSETS = Path(__file__).parents[2] / "platoon_osm" / "report" / "assets"

SEEDS = st.integers(0, 2**32 - 1)
ASIDE = st.floats(2, 30).flatmap(lambda far: st.sampled_from([far, -far]))


def bendy(seed: int) -> Floats:
    """A road that winds as motorways do: it turns up to 40 degrees within a dozen pixels."""
    draw = np.random.default_rng(seed)
    heading = np.zeros(60)
    for k, turn in enumerate(draw.normal(0, draw.uniform(0.05, 0.35), 59)):
        heading[k + 1] = 0.9 * heading[k] + min(max(turn, -0.7), 0.7)
    step = draw.uniform(4, 20)
    return np.cumsum(step * np.column_stack([np.cos(heading), np.sin(heading)]), axis=0) + 100


def hairpins(seed: int, apart: float) -> Floats:
    """A road up a slope: legs to and fro, some way apart."""
    draw = np.random.default_rng(seed)
    ends = [(0.0, 150.0)[(k // 2 + k) % 2] + draw.uniform(-20, 20) for k in range(8)]
    return np.array([(x, apart * (k // 2)) for k, x in enumerate(ends)])


def ramp(radius: float, side: int) -> Floats:
    """Three quarters of a circle, from one straight road to another that crosses it."""
    turn = np.linspace(0, 1.5 * np.pi, 24)
    circle = radius * np.column_stack([side * (1 - np.cos(turn)), -np.sin(turn)])
    return np.vstack([[(0.0, 150.0)], circle, [(-side * 150.0, radius)]]) + 300


def zigzag(seed: int) -> Floats:
    draw = np.random.default_rng(seed)
    count = int(draw.integers(5, 50))
    steps = np.arange(count) * draw.uniform(4, 15)
    return np.column_stack([steps, draw.uniform(-1, 1, count) * draw.uniform(1, 30)])


def road(kind: str, seed: int) -> Floats:
    draw = np.random.default_rng(seed)
    if kind == "hairpins":
        return hairpins(seed, draw.uniform(2, 40))
    if kind == "ramp":
        return ramp(draw.uniform(2, 40), int(draw.choice([-1, 1])))
    return bendy(seed) if kind == "bendy" else zigzag(seed)


KINDS = ("bendy", "hairpins", "ramp", "zigzag")


def farthest(line: Floats, beside: Floats) -> float:
    points = shapely.points(shapely.get_coordinates(shapely.segmentize(shape(beside), 1.0)))
    return float(shapely.distance(points, shape(line)).max())


def shape(line: Any) -> Any:
    return shapely.linestrings(np.asarray(line))


def loops(line: Any, most: float) -> int:
    """How often a line crosses itself within some length."""
    flat = np.asarray(line)
    arcs = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(flat, axis=0).T))])
    pieces = shapely.linestrings(np.stack([flat[:-1], flat[1:]], axis=1))
    i, j = shapely.STRtree(np.asarray(pieces)).query(pieces, predicate="crosses")
    return int(((j > i + 1) & (arcs[j] - arcs[np.minimum(i + 1, len(arcs) - 1)] <= most)).sum())


def sharpest(line: Any) -> float:
    """Greatest turn between pieces longer than half a pixel, in degrees."""
    step = np.diff(np.asarray(line), axis=0)
    step = step[np.hypot(*step.T) > 0.5]
    turn = np.diff(np.arctan2(step[:, 1], step[:, 0]))
    return float(np.degrees(np.abs((turn + np.pi) % (2 * np.pi) - np.pi).max(initial=0.0)))


@settings(deadline=None, max_examples=25)
@given(st.sampled_from(KINDS), SEEDS, ASIDE)
def test_a_line_stays_near_its_road_and_does_not_loop(kind: str, seed: int, aside: float) -> None:
    way = road(kind, seed)
    line = np.array(laid([(way.tolist(), aside)]))
    # Rounding moves a road by a third of its reach of two asides, at most.
    assert farthest(way, line) <= (1 + 2 / 3) * abs(aside) + 2
    assert loops(line, 4 * abs(aside)) == 0


@settings(deadline=None, max_examples=25)
@given(SEEDS, ASIDE)
def test_a_line_beside_a_winding_road_has_no_spikes(seed: int, aside: float) -> None:
    way = bendy(seed)
    assert sharpest(laid([(way.tolist(), aside)])) < 60
    # Nothing of the road is left out: the line comes by everywhere.
    assert farthest(np.array(laid([(way.tolist(), aside)])), way) < 2.5 * abs(aside) + 4


@pytest.mark.parametrize("radius", [60, 120, 400])
@pytest.mark.parametrize("aside", [-13, -4, 4, 13])
def test_gentle_bends_have_a_parallel_curve(radius: float, aside: float) -> None:
    turn = np.linspace(0, np.pi, 90)
    way = radius * np.column_stack([np.cos(turn), np.sin(turn)])
    line = laid([(way.tolist(), aside)])
    # y grows downwards here, so what shapely calls left is right of the road.
    exact = shapely.offset_curve(shape(way), aside, quad_segs=32, join_style="round")
    # The ends are free to differ in direction.
    middle = np.array(line)[3:-3]
    allowed = (2 * aside) ** 2 / 12 / radius + 0.6
    assert shapely.distance(shapely.points(middle), exact).max() < 1.5 * allowed


def test_a_line_moves_to_its_right() -> None:
    # y grows downwards: right of a line to the east is south, so a larger y.
    line = shifted([(0, 0), (10, 0), (10, 0), (20, 0)], 3)
    np.testing.assert_allclose(line, [(0, 3), (20, 3)], atol=1e-9)
    assert shifted([(0, 0), (10, 0), (20, 0)], 0) == [(0, 0), (20, 0)]
    assert shifted([(5, 5), (5, 5)], 2) == [(5, 5)]


def test_lines_of_a_band_stay_apart() -> None:
    way = bendy(7)
    offsets = [-6.0, 0.0, 6.0]
    left, middle, right = (shape(line) for line in laid_beside([(way.tolist(), 5.0)], offsets))
    for one, other in ((left, middle), (middle, right)):
        points = shapely.points(shapely.get_coordinates(one))
        assert shapely.distance(points, other).min() > 3
        assert shapely.distance(points, other).max() < 10
        assert not shapely.crosses(one, other)


def test_a_line_moves_over_gently() -> None:
    straight = [(0.0, 0.0), (200.0, 0.0)]
    line = laid([(straight, 10.0), ([(200.0, 0.0), (400.0, 0.0)], -10.0)])
    assert line[0][1] == pytest.approx(10)
    assert line[-1][1] == pytest.approx(-10)
    slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairwise(line)]
    assert -math.tan(math.radians(30)) < min(slopes) <= max(slopes) < 0.05


def test_a_short_road_between_hardly_shows() -> None:
    one, bit, other = (
        [(x, 0.0), (y, 0.0)] for x, y in ((0.0, 100.0), (100.0, 104.0), (104.0, 200.0))
    )
    line = laid([(one, 10.0), (bit, -10.0), (other, 10.0)])
    assert min(y for _, y in line) > 8
    assert sharpest(line) < 15


Roads = list[tuple[list[list[float]], float]]

CASES: list[tuple[str, Roads, list[float]]] = [
    (kind, [(road(kind, seed).tolist(), aside)], offsets)
    for seed in range(6)
    for kind in KINDS
    for aside, offsets in ((0.0, [-6.0, 0.0, 6.0]), (9.0, [0.0]), (-17.0, [-3.5, 3.5]))
] + [
    ("bendy", [(bendy(seed)[:30].tolist(), 4.0), (bendy(seed)[29:].tolist(), -11.0)], [0.0, 6.0])
    for seed in range(6)
]  # fmt: skip


def page_with(script: str) -> str:
    return f"<!DOCTYPE html><meta charset=utf-8><script>{script}</script>"


@pytest.mark.browser
def test_live_and_still_maps_lay_the_same_lines(chromium: Any) -> None:
    page = chromium.new_page()
    page.set_content(page_with((ASSETS / "beside.js").read_text("utf-8")))
    far: dict[str, list[float]] = {}
    for kind, roads, offsets in CASES:
        given = [
            {"points": [{"x": x, "y": y} for x, y in points], "aside": aside}
            for points, aside in roads
        ]
        live = page.evaluate(
            "([roads, offsets]) => planBeside.laidBeside(roads, offsets)"
            ".map(line => line.map(({x, y}) => [x, y]))",
            [given, offsets],
        )
        still = laid_beside([([(x, y) for x, y in line], aside) for line, aside in roads], offsets)
        far[kind] = far.get(kind, []) + [
            max(farthest(np.array(a), np.array(b)), farthest(np.array(b), np.array(a)))
            for a, b in zip(live, still, strict=True)
        ]
    page.close()
    assert set(far) == set(KINDS)
    worst = {kind: max(found) for kind, found in far.items()}
    assert max(worst.values()) < 0.6, worst
