"""On still maps nothing that is read covers anything else, whatever the plan."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
import pytest
from bundled import italy as italy_map
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report.charts.figure_layout import Layout, layout_of
from platoon_osm.report.charts.figure_map import corridor
from platoon_osm.report.charts.paper import WIDTH_IN, drawing
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.model import Document
from platoon_osm.report.maps.map_view import MapView
from platoon_osm.report.maps.placement import Box
from platoon_osm.report.maps.static_map import NARROW
from platoon_osm.report.maps.static_marks import placed_marks

TOWNS = (
    "Milano", "Torino", "Genova", "Venezia", "Bologna", "Firenze", "Roma", "Napoli", "Bari",
    "Verona", "Brescia", "Bergamo", "Trieste", "Padova", "Parma", "Ancona",
)  # fmt: skip
PLANS = chosen(10, 24)


pytestmark = soaked


@pytest.fixture(scope="module")
def italy() -> RoadNetwork:
    return italy_map()


@pytest.fixture(scope="module")
def documents(italy: RoadNetwork, net: RoadNetwork, many: JointPlan) -> list[Document]:
    """Plans of two to twelve vehicles, who often share a town, and a crowd."""
    found = []
    weights = po.paper_weights(italy)
    for seed in range(PLANS):
        draw = np.random.default_rng(seed)
        few = draw.choice(TOWNS, int(draw.integers(2, 9)), replace=False)
        trips = []
        for k in range(int(draw.integers(2, 13))):
            start, end = draw.choice(few, 2, replace=False)
            trips.append(po.Trip(f"V{k}", str(start), str(end)))
        found.append(document_of(po.plan_joint(italy, weights, trips, "C"), italy))
    return [*found, document_of(many, net)]


def apart(one: Box, other: Box) -> bool:
    near = 1e-9
    return (
        one.right <= other.left + near or other.right <= one.left + near
        or one.bottom <= other.top + near or other.bottom <= one.top + near
    )  # fmt: skip


def boxes(layout: Layout) -> Iterator[tuple[str, Box]]:
    yield from ((f"{mark.kind} {mark.title}", mark.box) for mark in layout.marks)
    yield from ((one.head, one.box) for one in layout.callouts)
    yield from layout.names
    yield layout.credit


def test_nothing_covers_anything_on_the_figure(documents: list[Document]) -> None:
    callouts = events = tied = marks = 0
    for document in documents:
        layout = layout_of(document)
        found = list(boxes(layout))
        for (name, box), (other_name, other) in itertools.combinations(found, 2):
            assert apart(box, other), (name, other_name)
        for name, box in found:
            assert box.left >= 0, name
            assert box.top >= 0, name
            assert box.right <= layout.view.width, name
            assert box.bottom <= layout.view.height, name
        callouts += len(layout.callouts)
        events += len(document.events)
        tied += sum(mark.is_tied for mark in layout.marks)
        assert len([mark for mark in layout.marks if mark.is_event]) == len(document.events)
        marks += len(layout.marks)
    # Most events have their callout, and marks are moved where towns are crowded only.
    assert callouts > 0.6 * events
    assert 0 < tied < 0.7 * marks


@pytest.mark.parametrize("scale", [1.0, NARROW])
def test_no_mark_covers_another_on_pages(documents: list[Document], scale: float) -> None:
    for document in documents:
        view = MapView([document])
        marks = placed_marks(document, view, scale)
        for one, other in itertools.combinations(marks, 2):
            assert apart(one.box, other.box), (one.title, other.title)
        for mark in marks:
            assert 0 <= mark.box.left <= mark.box.right <= view.width
            assert 0 <= mark.box.top <= mark.box.bottom <= view.height
        # Every vehicle has both its ends, by itself or counted.
        for kind, word in (("start", " start"), ("end", " arrive")):
            told = [m.title.split(word)[0].split(", ") for m in marks if m.kind == kind]
            assert set().union(*told) == {vehicle.letter for vehicle in document.vehicles}


def test_a_mark_stands_where_it_belongs_if_it_can(italy: RoadNetwork) -> None:
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    plan = po.plan_joint(italy, po.paper_weights(italy), trips, "C")
    layout = layout_of(document_of(plan, italy))
    for mark in layout.marks:
        assert (mark.x, mark.y) == mark.spot
        assert not mark.is_tied


def test_texts_fit_their_boxes(documents: list[Document]) -> None:
    for document in documents[: chosen(3, 6)]:
        with drawing():
            figure = corridor(document)
        axes = figure.axes[0]
        layout = layout_of(document)
        pixel = WIDTH_IN * figure.dpi / layout.view.width
        written = {text.get_text(): text.get_window_extent() for text in axes.texts}
        for one in layout.callouts:
            for line in (one.head, one.line):
                assert written[line].width <= (one.box.width - 12) * pixel, line
        for name, box in layout.names:
            assert written[name].width <= box.width * pixel * 1.02, name
        text, box = layout.credit
        assert written[text].width <= box.width * pixel
