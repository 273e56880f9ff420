"""The figure and the page of other values: same bytes, safe, in every language."""

import re
from dataclasses import replace
from datetime import datetime

import pytest

import platoon_osm as po
from platoon_osm.plans.what_if import Threshold, WhatIfs
from platoon_osm.report.language.languages import languages

SIX = datetime(2026, 3, 3, 6)
EVIL = '<img src=x onerror="alert(1)">&$x'


@pytest.fixture(scope="module")
def found():
    net = po.RoadNetwork.from_edges(
        [0, 1, 2, 4, 2], [1, 2, 3, 1, 5], [100e3, 150e3, 50e3, 40e3, 30e3], speed_mps=22.0,
        lon=[9.0, 10.0, 11.0, 12.0, 9.5, 11.5], lat=[45.0, 45.0, 45.0, 45.0, 45.4, 45.4],
    )  # fmt: skip
    trips = [po.Trip(EVIL, 0, 3, SIX), po.Trip("=1+1", 4, 5, SIX)]
    problem = po.Problem(net, trips, po.money_costs("eu", positions="nacfe"), case="C")
    price = po.what_if(problem, "fuel_per_l", [2.0, 0.2, 1.0])
    return WhatIfs((price, po.what_if(problem, "positions", ["eddi", "nacfe"], plan=price.plan)))


@pytest.mark.parametrize("language", languages())
def test_the_page_is_one_safe_file_in_every_language(found, tmp_path, language):
    path = tmp_path / "a.html"
    po.write_what_if(found, path, title=EVIL, language=language)
    page = path.read_text(encoding="utf-8")
    assert f'<html lang="{language}"' in page
    assert "<script" not in page
    assert "default-src 'none'" in page
    assert "<img" not in page
    assert 'onerror="' not in page
    assert not re.search(r"(?:src|href)=\"(?!#)", page)
    assert page.count("<svg") == 2
    assert page.count('<tr><th scope="row"') == 5
    assert "$" not in page.replace("$x", "")
    again = tmp_path / "b.html"
    po.write_what_if(found, again, title=EVIL, language=language)
    assert again.read_bytes() == path.read_bytes()


@pytest.mark.parametrize("kind", ["svg", "png", "pdf"])
def test_the_figure_is_the_same_twice(found, tmp_path, kind):
    one, two = tmp_path / f"a.{kind}", tmp_path / f"b.{kind}"
    po.write_what_if(found, one, language="de")
    po.write_what_if(found, two, language="de")
    assert one.read_bytes() == two.read_bytes()
    assert len(one.read_bytes()) > 4000


def test_names_are_no_formulas_in_the_table(found, tmp_path):
    found.write_csv(tmp_path / "a.csv")
    text = (tmp_path / "a.csv").read_text()
    assert not re.search(r"(?:^|,|; ?|\")=1", text, re.MULTILINE)


@pytest.mark.parametrize(("from_above", "is_proved"), [(True, True), (False, True), (True, False)])
def test_the_page_says_where_company_pays(found, tmp_path, from_above, is_proved):
    told = Threshold(0.5, 0.51, from_above, is_proved)
    study = replace(found.studies[0], threshold=told)
    po.write_what_if(study, tmp_path / "a.html")
    page = (tmp_path / "a.html").read_text()
    said = {
        (True, True): "Company pays from 0.51 EUR/l on.",
        (False, True): "Company pays up to 0.5 EUR/l.",
        (True, False): "Company begins to pay between 0.5 EUR/l and 0.51 EUR/l.",
    }
    assert said[from_above, is_proved] in page


def test_what_cannot_be_drawn_is_refused(found, tmp_path):
    for wrong, path, said in (
        (found, "a.xlsx", "use .html"),
        (WhatIfs(()), "a.html", "nothing to show"),
        (None, "a.html", "nothing to show"),
    ):
        with pytest.raises(po.ScenarioError, match=said):
            po.write_what_if(wrong, tmp_path / path)
    assert not list(tmp_path.iterdir())
