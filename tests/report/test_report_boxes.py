"""Boxes measured in a browser, on all kinds of plans and in all sizes of window."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from page_boxes import MAP_FAULTS, PANEL_FAULTS, SIZES, TEXT_FAULTS, Pages
from plan_kinds import KINDS, QUICK
from soak import SOAK, chosen, soaked

pytestmark = [pytest.mark.browser, soaked]


@pytest.fixture(scope="module")
def pages(chromium: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Pages]:
    context = chromium.new_context(offline=True)
    context.set_default_timeout(30_000)
    yield Pages(context.new_page(), tmp_path_factory.mktemp("boxes"))
    context.close()


@pytest.mark.parametrize("kind", chosen(QUICK, KINDS))
def test_every_mark_is_seen_in_full(pages: Pages, kind: str) -> None:
    """No start, destination or event is outside the map or covered, when opened or resized."""
    first = list(KINDS).index(kind) % len(SIZES)
    sizes = [*SIZES[first:], *SIZES[:first]]
    sizes = chosen(sizes[:4], sizes)  # each size is that of some kinds
    assert pages.faults(kind, sizes, [MAP_FAULTS]) == []


@pytest.mark.skipif(not SOAK, reason="every kind and size costs minutes: make soak")
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_covered_or_cut(pages: Pages, kind: str, size: tuple[int, int]) -> None:
    assert pages.faults(kind, [size], [MAP_FAULTS, TEXT_FAULTS, PANEL_FAULTS]) == []


def test_the_measures_can_fail(pages: Pages) -> None:
    """Each kind of fault is found where it is made."""
    page = pages.open("three vehicles", (900, 1000))
    page.evaluate("void map_plan.panBy([-300, -200], { animate: false })")
    assert any("outside" in fault for fault in page.evaluate(MAP_FAULTS))
    page.evaluate("void map_plan.setView([45.5, 10], 6, { animate: false })")
    page.evaluate("void map_plan.panBy([-170, 330], { animate: false })")
    assert any("lies under" in fault for fault in page.evaluate(MAP_FAULTS))
    page.evaluate(
        """() => {
          const [a, b] = document.querySelectorAll('.name');
          b.style.transform = a.style.transform;
          const heading = document.querySelector('h2:not(:has(*))');
          heading.style.cssText = 'white-space: nowrap; width: 40px';
          document.querySelector('#panel svg.along text').setAttribute('x', -20);
        }"""
    )
    assert any(" covers " in fault for fault in page.evaluate(TEXT_FAULTS))
    assert any("runs over" in fault for fault in page.evaluate(PANEL_FAULTS))
    assert any("leaves the drawing" in fault for fault in page.evaluate(PANEL_FAULTS))
