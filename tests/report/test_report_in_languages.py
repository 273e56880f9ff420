"""One page in several languages: each leads to the others, and what is looked at goes along."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind

from platoon_osm.cli import main
from platoon_osm.errors import ScenarioError
from platoon_osm.report import write_html, write_pages

browser = pytest.mark.browser

NAV = re.compile(r'<nav class="languages".*?</nav>\n', re.DOTALL)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("pages") / "new"
    plan, net = plan_kind("three vehicles")
    made = write_pages(plan, net, folder, languages=("en", "de", "it"))
    assert made == [folder / f"plan.{code}.html" for code in ("en", "de", "it")]
    assert sorted(made) == sorted(folder.iterdir())
    return folder


def test_each_is_the_page_of_its_language(folder: Path, tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    write_html(plan, net, tmp_path / "de.html", language="de")
    page = (folder / "plan.de.html").read_text("utf-8")
    assert NAV.sub("", page).replace("\n\n", "\n") == (
        (tmp_path / "de.html").read_text("utf-8").replace("\n\n", "\n")
    )
    assert '<a href="plan.en.html" hreflang="en" lang="en">English</a>' in page
    assert '<span lang="de" aria-current="page">Deutsch</span>' in page
    assert "Italiano" in page
    assert NAV.search((tmp_path / "de.html").read_text("utf-8")) is None


def test_regions_and_the_clock(tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    made = write_pages(plan, net, tmp_path, languages=["en-US", "de_AT"], clock=12)
    assert [path.name for path in made] == ["plan.en-US.html", "plan.de-AT.html"]
    assert "English (United States)" in made[1].read_text("utf-8")
    assert "Deutsch (Österreich)" in made[0].read_text("utf-8")
    (one,) = write_pages(plan, net, tmp_path, languages=["it"])
    assert NAV.search(one.read_text("utf-8")) is None


@pytest.mark.parametrize(
    "wrong", ["en", b"en", [], ["en", "EN"], ["en", "xx"], [3], 3, [["en"]], ["../en"], {"en": 1}]
)
def test_what_are_no_languages_is_refused(wrong: Any, tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    with pytest.raises(ScenarioError, match="language") as refused:
        write_pages(plan, net, tmp_path / "new", languages=wrong)
    assert "\n" not in str(refused.value)
    assert not (tmp_path / "new").exists()


def test_the_command_writes_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    trips = "".join(
        f'[[trips]]\nvehicle = "{name}"\norigin = "{origin}"\ndestination = "{end}"\n'
        for name, origin, end in (("A", "Torino", "Trieste"), ("B", "Genova", "Belluno"))
    )
    Path("s.toml").write_text(f'title = "S"\nnetwork = "italy-motorways"\n{trips}')
    assert main(["plan", "s.toml", "--pages", "pages"]) == 0
    names = sorted(path.name for path in Path("pages").iterdir())
    assert names == ["plan.de.html", "plan.en.html", "plan.it.html"]


@pytest.fixture
def page(chromium: Any) -> Iterator[Any]:
    context = chromium.new_context(offline=True, viewport={"width": 1440, "height": 900})
    context.set_default_timeout(20_000)
    yield context.new_page()
    context.close()


def settled(page: Any, language: str) -> None:
    page.wait_for_selector(f"html.live[lang={language}]")


@browser
def test_an_address_leads_to_its_language(folder: Path, page: Any) -> None:
    english = (folder / "plan.en.html").as_uri()
    page.goto(f"{english}#language=de&map=10/45.5/10.5&vehicle=B")
    settled(page, "de")
    assert page.evaluate("map_plan.getZoom()") == 10
    page.wait_for_function("() => location.hash.includes('vehicle=B')")
    assert "language=de" in page.evaluate("location.hash")
    assert page.evaluate("location.pathname").endswith("plan.de.html")
    # There is no page in French, nor in what is no language: the reader stays.
    for other in ("fr", "..%2Fx", "de.html"):
        page.goto("about:blank")
        page.goto(f"{english}#language={other}")
        settled(page, "en")
        assert page.evaluate("location.pathname").endswith("plan.en.html")


@browser
def test_a_link_takes_the_view_along(folder: Path, page: Any) -> None:
    page.goto((folder / "plan.it.html").as_uri() + "#map=9/45.25/9.5&moment=3600")
    settled(page, "it")
    page.get_by_role("navigation", name="Lingua").get_by_role("link", name="English").click()
    settled(page, "en")
    where = "() => [map_plan.getZoom(), map_plan.getCenter().lat]"
    assert page.evaluate(where) == [9, pytest.approx(45.25, abs=0.01)]
    assert page.locator(".journey output").inner_text() == "07:04"
    assert "language=en" in page.evaluate("location.hash")


@browser
def test_links_need_no_script(folder: Path, chromium: Any) -> None:
    context = chromium.new_context(offline=True, java_script_enabled=False)
    still = context.new_page()
    still.goto((folder / "plan.en.html").as_uri())
    still.get_by_role("link", name="Deutsch").click()
    still.wait_for_selector("html[lang=de]")
    context.close()


@browser
def test_a_page_by_itself_stays_where_it_is(page: Any, tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    write_html(plan, net, tmp_path / "plan.html")
    page.goto((tmp_path / "plan.html").as_uri() + "#language=de&map=9/45.25/9.5")
    settled(page, "en")
    assert page.evaluate("map_plan.getZoom()") == 9
