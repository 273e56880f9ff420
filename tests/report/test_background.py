"""The network behind a map: against a loop over its lines, and drawn once for many maps."""

import numpy as np
import pytest

from platoon_osm.report.drawing.lines import Line
from platoon_osm.report.maps.background import Background
from platoon_osm.report.maps.beside import simplified
from platoon_osm.report.maps.map_view import MapView
from platoon_osm.report.maps.pixels import network_path, path_data


def one_by_one(lines, width, height, most, beyond):
    """Return the background as `network_path` does, a line after another."""
    kept = {}
    for line in lines:
        points = [(float(round(x)), float(round(y))) for x, y in simplified(line)]
        xs, ys = zip(*points, strict=True)
        if max(max(xs) - min(xs), max(ys) - min(ys)) < 1.5:
            continue
        if not (-beyond < max(xs) and min(xs) < width + beyond):
            continue
        if not (-beyond < max(ys) and min(ys) < height + beyond):
            continue
        ends = tuple(sorted((round(x / 3), round(y / 3)) for x, y in (points[0], points[-1])))
        kept.setdefault(ends, points)
    text = ""
    for points in sorted(
        kept.values(), key=lambda line: -sum(max(one) - min(one) for one in zip(*line, strict=True))
    ):
        text += path_data(points)
        if len(text) > most:
            break
    return text


def lines_of(seed, count=120):
    """Lines of two points and more, far away, short, and there and back."""
    rng = np.random.default_rng(seed)
    found = []
    for _ in range(count):
        size = int(rng.integers(2, 9))
        scale = float(rng.choice([0.1, 1.0, 20.0, 200.0]))
        steps = rng.normal(0, scale, (size, 2))
        found.append([tuple(at) for at in (rng.uniform(-200, 500, 2) + steps.cumsum(0)).tolist()])
        if rng.random() < 0.3:
            found.append([(x + 1.0, y) for x, y in found[-1][::-1]])
    return found


@pytest.mark.parametrize("seed", range(12))
def test_the_background_is_that_of_each_line_by_itself(seed):
    lines = lines_of(seed)
    for most, beyond in ((80_000, 0.0), (900, 0.0), (80_000, 60.0)):
        wanted = one_by_one(lines, 300.0, 240.0, most, beyond)
        assert network_path(lines, 300.0, 240.0, most, beyond) == wanted
        assert len(wanted) > 500


def test_nothing_near_is_no_path():
    assert network_path([], 100.0, 100.0) == ""
    assert network_path([[(5.0, 5.0)], [(900.0, 900.0), (950.0, 900.0)]], 100.0, 100.0) == ""


def test_maps_of_one_network_are_those_that_each_would_draw():
    rng = np.random.default_rng(3)
    lines = [
        Line.rounded(rng.uniform((5, 44), (15, 48)) + rng.normal(0, 0.4, (5, 2)).cumsum(0), 10_000)
        for _ in range(60)
    ]
    background = Background([*lines, Line.rounded([(9.0, 45.0)], 10_000)])
    for _ in range(5):
        at = rng.uniform((6, 45), (14, 47), (2, 2))
        view = MapView.around([tuple(one) for one in at.tolist()], 400.0, (300.0, 300.0))
        wanted = network_path([view.pixels(line) for line in lines], view.width, view.height, 5000)
        assert background.path(view, 5000) == wanted
        assert wanted
