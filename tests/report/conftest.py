"""Plans on a small Po valley, and a real browser that sees no network."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from typing import Any

import pytest
from po_valley import THREE, fifty, make_plan, po_valley, two_platoons

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan

CHROMIUM = "/usr/bin/chromium"


@pytest.fixture(scope="session")
def net() -> RoadNetwork:
    return po_valley()


@pytest.fixture(scope="session")
def plan(net: RoadNetwork) -> JointPlan:
    return make_plan(net, THREE)


@pytest.fixture(scope="session")
def many(net: RoadNetwork) -> JointPlan:
    """Fifty vehicles, some of them alone."""
    return make_plan(net, fifty())


@pytest.fixture(scope="session")
def two(net: RoadNetwork) -> JointPlan:
    """Two platoons on one road, and a vehicle alone."""
    return two_platoons(net)


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    """One headless browser for all tests; skipped where there is none."""
    if not Path(CHROMIUM).exists():
        pytest.skip(f"no browser at {CHROMIUM}")
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=CHROMIUM,
            timeout=60_000,
            args=[
                "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
            ],
        )  # fmt: skip
        yield browser
        browser.close()


class Opened:
    """A page opened from a file, with all that it should not do."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.requests: list[str] = []
        self.complaints: list[str] = []
        page.on("request", lambda request: self.requests.append(request.url))
        page.on(
            "console",
            lambda line: (
                self.complaints.append(line.text) if line.type in ("error", "warning") else None
            ),
        )
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.on("dialog", lambda dialog: self._dialog(dialog))

    def _dialog(self, dialog: Any) -> None:
        self.complaints.append(f"dialog: {dialog.message}")
        dialog.dismiss()

    def check(self, path: Path) -> None:
        assert self.complaints == []
        assert [url for url in self.requests if not url.startswith("data:")] == [path.as_uri()]


def _opened(
    chromium: Any,
    contexts: list[Any],
    path: Path,
    width: int = 1440,
    height: int = 900,
    wait_for: str | None = "#map_plan[data-ready]",
    **options: Any,
) -> Opened:
    context = chromium.new_context(
        viewport={"width": width, "height": height}, offline=True, **options
    )
    contexts.append(context)
    context.set_default_timeout(20_000)
    found = Opened(context.new_page())
    found.page.goto(path.as_uri())
    if wait_for and options.get("java_script_enabled", True):
        found.page.wait_for_selector(wait_for)
    return found


@pytest.fixture
def visit(chromium: Any) -> Iterator[Callable[..., Opened]]:
    """Open a file in a fresh context with the network cut."""
    contexts: list[Any] = []
    yield partial(_opened, chromium, contexts)
    for context in contexts:
        context.close()


@pytest.fixture(scope="module")
def look(chromium: Any) -> Iterator[Callable[[Path, int, int], Opened]]:
    """Look at a file that is opened once at each size, for tests that leave it as it is."""
    contexts: list[Any] = []
    yield cache(partial(_opened, chromium, contexts))
    for context in contexts:
        context.close()
