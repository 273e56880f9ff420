"""The page of a study: the answer first, and as good to read as the page of a plan."""

import re
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from page_texts import ENGLISH, left_over, told_by_study
from soak import chosen, soaked

from platoon_osm import __version__
from platoon_osm.report.language.speech import speaking
from platoon_osm.study.answer import answer_of
from platoon_osm.study.command import studies_of
from platoon_osm.study.comparison import PRINTED, compare, placing
from platoon_osm.study.example import example_of
from platoon_osm.study.figures import (
    cost_figure,
    involvement_figure,
    network_figure,
    save_figure,
)
from platoon_osm.study.measures import Estimate
from platoon_osm.study.monte_carlo import run_study
from platoon_osm.study.options import StudyOptions
from platoon_osm.study.page import Picture, StudyPage, write_page
from platoon_osm.study.parameters import parameters_in_words
from platoon_osm.study.shown_tables import shown_tables
from platoon_osm.study.verdict import conclusions

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="700" height="400"><path d="M0 0L9 9"/></svg>'

WIDTHS = (390, 900, 1440)


@pytest.fixture(scope="module")
def studied(tmp_path_factory):
    """Results of a small study, by all methods and with all terms."""
    options = StudyOptions(
        runs=2, grid=2, vehicles=3, diameter_km="1,300", spawning="points", nodes=60, edges=260
    )
    folder = tmp_path_factory.mktemp("runs")
    return [run_study(study, 0, None, folder, lambda _: None) for study in studies_of(options)]


@pytest.fixture(scope="module")
def page(studied, tmp_path_factory):
    return written(studied, tmp_path_factory.mktemp("page"))


def written(studied, folder):
    """Write the page in the language that is spoken."""
    (folder / "figure.svg").write_text(SVG)
    rows = compare(studied)
    picture = Picture("A figure", "What is to be seen.", "A line falls.", folder / "figure.svg")
    plain = {"seed": 0, "studies": [result.study.to_dict() for result in studied]}
    write_page(
        folder / "report.html",
        StudyPage(
            answer_of(rows, studied), conclusions(rows, studied), [picture, picture],
            shown_tables(studied, rows), parameters_in_words(studied), plain, "platoon-osm <study>",
        ),
    )  # fmt: skip
    return folder / "report.html"


@pytest.mark.parametrize("language", ["de", "it"])
def test_no_english_word_is_left(studied, page, tmp_path, language):
    with speaking(language):
        other = written(studied, tmp_path).read_text(encoding="utf-8")
    assert f'<html lang="{language}"' in other
    english = page.read_text(encoding="utf-8")
    given = {"A figure", "What is to be seen.", "A line falls.", "Dijkstra", "tau", "l per 100 km"}
    said = told_by_study(other)
    assert left_over(told_by_study(english), said, given) == set()
    assert [text for text in said if ENGLISH.search(text)] == []
    # Numbers have the signs of the language, and no point is left between figures of one.
    assert re.search(r"\d,\d%" if language == "it" else r"\d,\d&nbsp;%", other)
    assert not re.search(r"\d\.\d(?!\d\d)", " ".join(said).replace(__version__, ""))


def drawn(studied):
    """Return what the figures of a study say."""
    figures = [
        network_figure([(placing(result), example_of(result)) for result in studied]),
        cost_figure(studied[0]),
        involvement_figure(studied, "astar"),
    ]
    return {text.get_text() for figure in figures for text in figure.findobj(Text)}


def test_figures_leave_no_english_word(studied):
    english = drawn(studied)
    with speaking("it"):
        assert left_over(english, drawn(studied), set()) == set()


def test_axes_have_the_decimal_sign_of_the_language(tmp_path):
    for language, tick in (("en", "<!-- 0.5 -->"), ("de", "<!-- 0,5 -->")):
        figure = Figure((2, 2))
        figure.subplots().set_xticks([0, 0.5])
        with speaking(language):
            save_figure(figure, tmp_path / language)
        assert tick in (tmp_path / f"{language}.svg").read_text(encoding="utf-8")


def test_the_answer_comes_first_with_its_numbers(studied, page):
    answer = answer_of(compare(studied), studied)
    text = page.read_text(encoding="utf-8")
    main = text[text.index("<main>") :]
    assert main.index("The answer") < main.index(answer.verdict) < main.index("<table")
    assert len(answer.numbers) == 4
    assert re.match(r"(Agrees|Agrees in part|Does not agree): ", answer.verdict)
    good = sum(number.agrees for number in answer.numbers)
    assert (answer.standing == "none") == (not good) or answer.standing == "all"
    for number in answer.numbers:
        assert number.ours.removesuffix(" %") in answer.found
    assert len(answer.found) < 400


def test_a_study_of_one_method_has_an_answer_too(tmp_path):
    options = StudyOptions(
        runs=2, grid=2, vehicles=3, diameter_km="1", spawning="points", method="dijkstra",
        nodes=60, edges=260, terms="distance+time+fuel",
    )  # fmt: skip
    results = [run_study(study, 0, None, tmp_path, lambda _: None) for study in studies_of(options)]
    answer = answer_of(compare(results), results)
    assert [number.paper for number in answer.numbers] == ["8 %", "14 %", "33 %"]
    assert "printed numbers lie in the interval" in answer.verdict
    titles = [table.title for table in shown_tables(results, compare(results))]
    assert not any("A*" in title for title in titles)


@pytest.mark.parametrize(
    ("language", "drawn_on", "agreeing"),
    [
        ("en", "1 random network of", ("1 of 3 printed numbers lies",
         "2 of 3 printed numbers lie")),
        ("de", "1 Zufallsnetz mit", ("1 von 3 gedruckten Zahlen liegt",
         "2 von 3 gedruckten Zahlen liegen")),
        ("it", "1 rete casuale di", ("1 numero stampato su 3 sta",
         "2 numeri stampati su 3 stanno")),
    ],
)  # fmt: skip
def test_one_has_its_own_form(studied, language, drawn_on, agreeing):
    once = replace(studied[0], study=replace(studied[0].study, runs=1))
    rows = [row for row in compare(studied) if row.method == "dijkstra"]
    for good, wanted in zip((("point",), ("point", "mean")), agreeing, strict=True):
        known = [
            replace(
                row, ours=Estimate(*[PRINTED[row.number].value[0] + (row.number not in good)] * 3)
            )
            for row in rows
        ]
        with speaking(language):
            answer = answer_of(known, [once])
        assert drawn_on in answer.asked
        assert answer.verdict.startswith(f"{wanted} ")


def test_parameters_are_in_words_with_units(studied):
    told = dict(parameters_in_words(studied))
    assert told["Least length of a route"] == "500 km"
    assert told["They start in a circle of"] == "1, 300 km across"
    assert told["Weight of fuel in a platoon, xi"] == "0 to 100 %, 2 values"
    assert "A*, nodes opened again" in told["Routes are found by"]
    assert all("_" not in text for pair in told.items() for text in pair)


def test_both_readings_of_astar_stand_side_by_side(studied):
    for table in shown_tables(studied, compare(studied))[:3]:
        groups = list(dict.fromkeys(group for group, _ in table.heads if group))
        assert groups == ["Dijkstra", "A*, nodes opened again", "A*, each node once"]


def test_decimals_of_a_column_are_alike(studied):
    for table in shown_tables(studied, compare(studied)):
        for column in range(table.labels, len(table.heads)):
            values = [row[column].split(" ")[0] for row in table.rows]
            assert len({len(value.partition(".")[2]) for value in values}) == 1, table.title


LOOKS = [*((width, False) for width in WIDTHS), (1440, True)]


@soaked
@pytest.mark.parametrize(("width", "dark"), chosen([LOOKS[0], LOOKS[-1]], LOOKS))
def test_axe_finds_nothing_serious_nor_moderate(page, width, dark, visit):
    pytest.importorskip("axe_playwright_python")
    opened = visit(page, width, 900, wait_for="h1").page
    opened.emulate_media(color_scheme="dark" if dark else "light")
    opened.evaluate((files("axe_playwright_python") / "axe.min.js").read_text("utf-8"))
    found = opened.evaluate("axe.run(document, {resultTypes: ['violations']})")
    faults = [
        (fault["id"], fault["impact"], [node["html"][:120] for node in fault["nodes"][:3]])
        for fault in found["violations"]
        if fault["impact"] in ("moderate", "serious", "critical")
    ]
    assert faults == []


@pytest.mark.parametrize("width", WIDTHS)
def test_nothing_but_boxes_scrolls_sideways_and_boxes_are_named(page, width, visit):
    opened = visit(page, width, 900, wait_for="h1").page
    assert opened.evaluate("document.documentElement.scrollWidth") <= width
    wide = opened.evaluate(
        """() => [...document.querySelectorAll('main *')].filter((it) =>
             it.scrollWidth > it.clientWidth + 1
             && getComputedStyle(it).overflowX !== 'visible').map((it) =>
             [it.tabIndex, it.getAttribute('role'),
              it.getAttribute('aria-label') || it.getAttribute('aria-labelledby')])"""
    )
    assert all(tab == 0 and role == "region" and name for tab, role, name in wide)
    assert wide or width > 390
    right = opened.evaluate(
        """() => [...document.querySelectorAll('td:not(.text)')].every((cell) =>
             getComputedStyle(cell).textAlign === 'right'
             && getComputedStyle(cell).fontVariantNumeric === 'tabular-nums')"""
    )
    assert right


def test_heads_of_long_tables_stay_in_sight(page, visit):
    opened = visit(page, 1440, 500, wait_for="h1").page
    moved = opened.evaluate(
        """() => {
             const box = document.querySelector('[aria-labelledby="t-5"].box');
             box.scrollTop = 200;
             const top = box.getBoundingClientRect().top;
             return [box.scrollTop, [...box.querySelectorAll('thead th')].map((head) =>
               head.getBoundingClientRect().bottom - top)];
           }"""
    )
    scrolled, bottoms = moved
    assert scrolled > 100
    assert all(0 < bottom < 200 for bottom in bottoms)


def test_paper_keeps_heads_with_what_they_head(page, visit):
    # A4 between its margins, at 96 pixels in an inch.
    opened = visit(page, 703, 1025, wait_for="h1").page
    opened.emulate_media(media="print")
    told = opened.evaluate(
        """() => ({
             kept: [...document.querySelectorAll('.entry, figure, tr')].every((it) =>
               getComputedStyle(it).breakInside === 'avoid'),
             heads: [...document.querySelectorAll('h1, h2, h3, .caption')].every((it) =>
               getComputedStyle(it).breakAfter === 'avoid'),
             tall: [...document.querySelectorAll('.entry, figure')].map((it) => it.offsetHeight),
             wide: [...document.querySelectorAll('table, img, pre')].filter((it) => it.offsetWidth)
               .map((it) => it.getBoundingClientRect().right),
           })"""
    )
    assert told["kept"]
    assert told["heads"]
    assert max(told["tall"]) < 1025
    assert max(told["wide"]) <= 704


def test_it_asks_for_nothing_and_names_stay_names(page):
    text = page.read_text(encoding="utf-8")
    assert "<script" not in text
    assert "<study>" not in text
    assert 'class="skip" href="#answer"' in text
    assert not re.search(r'(?:src|href)="(?!data:|#)', text)
    for link in re.findall(r'href="#([^"]+)"', text):
        assert f'id="{link}"' in text
    alts = re.findall(r'<img [^>]*alt="([^"]*)"', text)
    assert alts == ["A line falls."] * 2
    assert Path(page).stat().st_size < 200_000
