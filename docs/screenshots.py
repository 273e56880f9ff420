"""Make the pictures of README and docs: the demo at three widths, a comparison, flows, the law.

    python docs/screenshots.py out docs/images

`out` holds demo.html, as `platoon-osm demo -o out` writes it; the other pages are made here.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from datetime import datetime, timedelta
from importlib.resources import as_file, files
from itertools import accumulate, pairwise
from pathlib import Path
from typing import Any

import platoon_osm
from platoon_osm.planning.scenario import Scenario, read_scenario
from platoon_osm.plans.proof import Proof

CHROMIUM = Path("/usr/bin/chromium")
MINUTE = 220
"""When the pictures stop the vehicles, from the first departure: all three in the platoon."""

MASTERS = (
    ("Torino", "Trieste"), ("Milano", "Napoli"), ("Bologna", "Bari"), ("Genova", "Udine"),
    ("Verona", "Roma"), ("Bolzano", "Ancona"),
)  # fmt: skip
CITIES = (
    "Torino", "Milano", "Genova", "Bologna", "Firenze", "Venezia", "Verona", "Padova", "Trieste",
    "Brescia", "Parma", "Bolzano", "Roma", "Napoli", "Bari", "Ancona", "Udine", "Piacenza",
    "Rimini", "Pescara", "Bergamo",
)  # fmt: skip


def write_pages(out: Path) -> None:
    """Write compare.html, flow.html, legal.html and legal-sheet.html."""
    with as_file(files("platoon_osm.scenarios") / "po-valley-c.toml") as path:
        scenario = read_scenario(path)
    net = platoon_osm.load_network("italy-motorways")
    titles, plans = [], []
    for title, xi, case in (
        ("Case A: members merge and stay", 0.18, "A"),
        ("Case C: merge and separate, xi = 0.18", 0.18, "C"),
        ("Case C with xi = 0", 0.0, "C"),
        ("Case C with xi = 1", 1.0, "C"),
    ):
        titles.append(title)
        plans.append(_variant(scenario, xi, case).plan(net))
    platoon_osm.write_comparison(
        plans, net, out / "compare.html", titles=titles, title=scenario.title
    )
    write_legal_pages(out, net)
    fleet = _fleet(net)
    platoon_osm.write_flows(
        fleet, net, out / "flow.html", title=f"{len(fleet.vehicles)} trucks in Italy"
    )


def write_legal_pages(out: Path, net: platoon_osm.RoadNetwork) -> None:
    """Write the page of a legal day, and the sheet of the driver who rests on the way."""
    six = datetime.fromisoformat("2026-03-04T06:00+01:00")
    trips = [
        platoon_osm.Trip(
            town, town, "Napoli", six - early, latest_arrival=six + timedelta(hours=13)
        )
        for town, early in (
            ("Milano", timedelta()), ("Torino", timedelta(hours=13)),
            ("Venezia", timedelta()), ("Brescia", timedelta()),
        )
    ]  # fmt: skip
    plan = platoon_osm.plan_joint(net, platoon_osm.PaperCosts(), trips, rules="eu561")
    platoon_osm.write_html(plan, net, out / "legal.html")
    platoon_osm.write_sheets(plan, net, out / "legal-sheet.html")


def _variant(scenario: Scenario, xi: float, case: str) -> Scenario:
    return replace(
        scenario, costs={**scenario.costs, "xi": xi}, options={**scenario.options, "case": case}
    )


def _fleet(net: platoon_osm.RoadNetwork) -> platoon_osm.Plan:
    """Return platoons of their own, one after another, as one plan."""
    weights = platoon_osm.paper_weights(net)
    ways = [(a, b) for a, b in pairwise(CITIES * 3) if a != b]
    ways += list(zip(CITIES, CITIES[7:], strict=False))
    plans: list[platoon_osm.Plan] = []
    number = 0
    for place, master in enumerate(MASTERS):
        trips = []
        for origin, end in (master, *ways[place :: len(MASTERS)][:9]):
            number += 1
            trips.append(
                platoon_osm.Trip(
                    f"Truck {number}", net.locate(origin, "origin"), net.locate(end, "destination")
                )
            )
        plans.append(platoon_osm.plan_joint(net, weights, trips, case="C"))
    return _one_of(plans)


def _one_of(plans: list[platoon_osm.Plan]) -> platoon_osm.Plan:
    """Return plans of different vehicles as one: positions go on where the last plan ended."""
    first = [0, *accumulate(len(plan.trips) for plan in plans)]
    first_stretch = [0, *accumulate(len(plan.stretches) for plan in plans)]
    numbered = list(zip(plans, first, first_stretch, strict=False))

    def moved(vehicles: tuple[int, ...], by: int) -> tuple[int, ...]:
        return tuple(vehicle + by for vehicle in vehicles)

    return replace(
        plans[0],
        trips=tuple(trip for plan in plans for trip in plan.trips),
        stretches=tuple(
            replace(stretch, vehicles=moved(stretch.vehicles, by))
            for plan, by, _ in numbered
            for stretch in plan.stretches
        ),
        ways=tuple(moved(way, by) for plan, _, by in numbered for way in plan.ways),
        platoons=tuple(
            replace(
                platoon,
                vehicles=moved(platoon.vehicles, by),
                master=None if platoon.master is None else platoon.master + by,
            )
            for plan, by, _ in numbered
            for platoon in plan.platoons
        ),
        events=tuple(
            replace(
                event,
                movers=moved(event.movers, by),
                others=moved(event.others, by),
                stretch=event.stretch + by_stretch,
            )
            for plan, by, by_stretch in numbered
            for event in plan.events
        ),
        proof=Proof.of(
            sum(plan.joint_cost for plan in plans),
            sum(plan.proof.bound or 0.0 for plan in plans),
            (*plans[0].proof.conditions, "who drives in which platoon is given"),
        ),
        remarks=(),
    )


def take_pictures(out: Path, images: Path) -> None:
    """Open the pages in headless Chromium with the network cut, and take their pictures."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=CHROMIUM if CHROMIUM.exists() else None, args=["--no-sandbox"]
        )

        def opened(name: str, width: int, height: int) -> Any:
            context = browser.new_context(viewport={"width": width, "height": height}, offline=True)
            page = context.new_page()
            page.goto((out / name).resolve().as_uri())
            page.wait_for_timeout(500)
            return page

        for name, width, height in (
            ("demo.png", 1440, 900), ("demo-900.png", 900, 1100), ("demo-390.png", 390, 844),
        ):  # fmt: skip
            page = opened("demo.html", width, height)
            slider = page.get_by_role("slider", name="Time of day")
            slider.fill(str(MINUTE))
            slider.blur()
            page.wait_for_timeout(200)
            page.screenshot(path=images / name)
        opened("compare.html", 1440, 900).screenshot(path=images / "compare.png", full_page=True)
        opened("legal.html", 1440, 900).screenshot(path=images / "legal.png")
        page = opened("legal-sheet.html", 900, 1180)
        # The second sheet is Torino's, who sleeps on the way.
        page.locator("#sheet-2").screenshot(path=images / "legal-sheet.png")
        page = opened("flow.html", 1440, 900)
        page.get_by_role("button", name="Saved").click()
        page.mouse.move(0, 0)
        page.screenshot(path=images / "flow.png")
        browser.close()


if __name__ == "__main__":
    folder, pictures = (Path(argument) for argument in sys.argv[1:3])
    write_pages(folder)
    take_pictures(folder, pictures)
