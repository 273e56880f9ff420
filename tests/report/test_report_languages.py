"""Pages in other languages: nothing of the English page is left but names, figures and credits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from page_texts import READ_ALOUD, left_over, texts_of
from plan_kinds import plan_kind
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.report.language.languages import languages

Visit = Callable[..., Any]

SAME_IN = {"de": {"Plan", "optimal"}, "it": {"In platoon"}}
"""Whole texts of a language that are spelt as the English ones are."""

KINDS = (
    "three vehicles", "without times", "one vehicle", "all are late", "fifty vehicles",
    "over several days",
)  # fmt: skip


def names_in(value: Any, key: str = "") -> Iterator[str]:
    """Yield what a document holds of names, titles and credits: other people's words."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from names_in(inner, name)
    elif isinstance(value, list):
        for inner in value:
            if isinstance(inner, list) and key in ("towns", "junctions", "stops"):
                yield inner[2]
            else:
                yield from names_in(inner, key)
    elif isinstance(value, str) and key in ("name", "title", "credits", "letter", "label", "zone"):
        yield value


LIVE = """() => {
  const found = [];
  const texts = (root) => {
    const walk = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) {
      const { parentElement: parent, data } = walk.currentNode;
      if (!parent?.closest("script, style")) found.push(data);
    }
    for (const one of root.querySelectorAll("*")) {
      for (const name of READ_ALOUD) if (one.getAttribute(name)) found.push(one.getAttribute(name));
    }
  };
  texts(document.body);
  map_plan.eachLayer((layer) => {
    const tip = layer.getTooltip?.()?.getContent();
    if (tip instanceof Element) texts(tip);
    else if (tip) found.push(tip);
  });
  return found.map((text) => text.replace(/[\\s\u2068\u2069]+/g, " ").trim());
}""".replace("READ_ALOUD", str(list(READ_ALOUD)))


def pages_of(kind: str, folder: Path, language: str) -> dict[str, str]:
    """Write every page of a plan in a language."""
    plan, net = plan_kind(kind)
    folder = folder / language
    folder.mkdir()
    po.write_flows(plan, net, folder / "flows.html", language=language)
    other = po.write_comparison
    other([plan, plan], net, folder / "compare.html", titles=["Uno", "Due"], language=language)
    po.write_html(plan, net, folder / "plan.html", language=language)
    return {path.name: path.read_text("utf-8") for path in sorted(folder.glob("*.html"))}


def names_of(kind: str) -> set[str]:
    plan, net = plan_kind(kind)
    document = po.report.report_document(plan, net)
    names = {" ".join(name.split()) for name in names_in(document)}
    return {"Uno", "Due", *(name for name in names if len(name) > 2)}


@soaked
@pytest.mark.parametrize("kind", chosen([kind for kind in KINDS if "fifty" not in kind], KINDS))
def test_still_pages_leave_no_english_word(kind: str, tmp_path: Path) -> None:
    english = pages_of(kind, tmp_path, "en")
    names = names_of(kind)
    for language in languages():
        if language == "en":
            continue
        for page, html in pages_of(kind, tmp_path, language).items():
            assert f'<html lang="{language}"' in html
            left = left_over(texts_of(english[page]), texts_of(html), names)
            assert left <= SAME_IN.get(language, set()), (page, language)


@pytest.mark.parametrize("kind", ["three vehicles", "all are late", "without times"])
def test_the_live_page_leaves_no_english_word(kind: str, tmp_path: Path, visit: Visit) -> None:
    plan, net = plan_kind(kind)
    said = {}
    for language in ("en", "de"):
        path = tmp_path / f"{language}.html"
        po.write_html(plan, net, path, language=language)
        opened = visit(path)
        said[language] = set(opened.page.evaluate(LIVE))
        opened.check(path)
    assert left_over(said["en"], said["de"], names_of(kind)) == set()
