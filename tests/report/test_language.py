"""One catalogue with the same keys in each language; numbers, times and dates in its form."""

from __future__ import annotations

import re
import string
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from zoneinfo import ZoneInfo

import numpy as np
import pytest
from babel import Locale
from babel.numbers import format_decimal
from hypothesis import given
from hypothesis import strategies as st
from places import ROOT
from plan_kinds import italy

from platoon_osm import Limits, PaperCosts, Problem, Trip, plan_joint
from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.model import modelled
from platoon_osm.plans.clock import Clock
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.text_table import listed
from platoon_osm.plans.zones import clock_of
from platoon_osm.report.language.languages import language_of, languages
from platoon_osm.report.language.plan_sentences import in_language
from platoon_osm.report.language.speech import (
    clock_time,
    day_and_date,
    late_by,
    number,
    say,
    speaking,
    spoken,
    zone_text,
)
from platoon_osm.report.markup.quantities import cost_unit, kilometres, percent

REPORT = ROOT / "platoon_osm" / "report"

EVENING = Clock.at(datetime(2026, 11, 27, 20, 5, tzinfo=UTC))


def fields(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


@pytest.mark.parametrize("code", languages())
def test_all_languages_say_the_same_things(code: str) -> None:
    english, other = language_of("en").texts, language_of(code).texts
    assert set(other) == set(english)
    for key, text in english.items():
        said = other[key]
        forms = {"": said} if isinstance(said, str) else said
        assert isinstance(text, str) == isinstance(said, str), key
        wanted = fields(text) if isinstance(text, str) else set().union(*map(fields, text.values()))
        for form in forms.values():
            assert form.strip() == form != "", key
            # "One vehicle" may do without its number.
            assert fields(form) | {"n"} == wanted | {"n"}, key
            assert "$" not in form, key
        if not isinstance(said, str):
            assert "other" in said, key
            assert set(said) >= set(Locale.parse(code).plural_form.tags) - {"many", "few", "two"}, (
                key
            )


def test_every_key_that_is_used_is_there_and_every_one_that_is_there_is_used() -> None:
    texts = language_of("en").texts
    said: set[str] = set()
    for path in [*REPORT.rglob("*.py"), *(ROOT / "platoon_osm" / "study").rglob("*.py")]:
        source = path.read_text("utf-8")
        said.update(re.findall(r"""["']([a-z-]+\.[a-z][a-z0-9-]*)["']""", source))
        for key in re.findall(r'\bsay\(\s*"([^"]+)"', source):
            assert key in texts, (path, key)
    for path in (REPORT / "assets").glob("*.html"):
        for key in re.findall(r"@\{([^}]*)\}", path.read_text("utf-8")):
            assert key in texts, (path, key)
            said.add(key)
    script = "".join(path.read_text("utf-8") for path in (REPORT / "assets").glob("*.js"))
    for key in re.findall(r'\bsay\(\s*"([^"]+)"', script):
        assert f"script.{key}" in texts, key
    for key in texts:
        if key.startswith("script."):
            used = f'"{key.removeprefix("script.")}"' in script or key in said
            assert used, f"{key} is said nowhere"
        elif not key.startswith("plan."):
            assert key in said, f"{key} is said nowhere"


@pytest.mark.parametrize("code", ["en", "en-US", "de", "de-AT", "it"])
@given(value=st.floats(-1e9, 1e9), decimals=st.integers(0, 3))
def test_numbers_are_those_of_the_locale(code: str, value: float, decimals: int) -> None:
    pattern = "#,##0" + ("." + "0" * decimals if decimals else "")
    rounded = float(f"{value:.{decimals}f}")
    with speaking(code) as language:
        wanted = format_decimal(rounded, pattern, locale=language.locale)
        assert number(value, decimals).lstrip("-") == wanted.lstrip("-\u2212")


def test_it_is_spoken_for_a_while() -> None:
    assert spoken().code == "en"
    with speaking("de"):
        assert say("clock.local") == "Ortszeit"
        with speaking():
            assert spoken().code == "de"
        with speaking(clock=12):
            assert (spoken().code, spoken().clock) == ("de", 12)
        with speaking("it"):
            assert say("clock.local") == "ora locale"
        assert spoken().code == "de"
    assert spoken().code == "en"


def test_figures_in_each_language() -> None:
    assert (kilometres(1_234_000), kilometres(1_230), percent(0.013)) == (
        "1,234 km", "1.2 km", "1.3\u202f%",
    )  # fmt: skip
    with speaking("de"):
        assert (kilometres(1_234_000), percent(0.013)) == ("1.234 km", "1,3\u202f%")
        assert cost_unit("m").full(12_345_678) == "12.345,7\u00a0km-\u00c4q."
    with speaking("it"):
        assert percent(-0.013) == "-1,3%"
        assert late_by(10) == "meno di un minuto"


@pytest.mark.parametrize(
    ("code", "clock", "text"),
    [
        ("en", None, "20:05"), ("en-US", None, "8:05\u00a0pm"), ("en-US", 24, "20:05"),
        ("en", 12, "8:05\u00a0pm"), ("de", None, "20:05"), ("it", 12, "8:05\u00a0pm"),
    ],
)  # fmt: skip
def test_clocks(code: str, clock: int | None, text: str) -> None:
    with speaking(code, clock):
        assert clock_time(EVENING, 0) == text


@given(minutes=st.integers(-5_000, 5_000))
def test_both_clocks_tell_the_same_time(minutes: int) -> None:
    with speaking("en"):
        assert clock_time(EVENING, 60 * minutes).replace("\u00a0", " ") == EVENING.text(
            60 * minutes
        )
    with speaking("en", 12):
        text = clock_time(EVENING, 60 * minutes).replace("\u00a0", " ")
    shown = datetime.strptime(text.split(" +")[0].split(" -")[0], "%I:%M %p")
    assert f"{shown:%H:%M}" == EVENING.text(60 * minutes)[:5]


def test_days_and_zones() -> None:
    night = clock_of(datetime(2026, 10, 24, 22, tzinfo=ZoneInfo("Europe/Rome")), 0, [12 * 3600.0])
    assert zone_text(night) == night.zone
    with speaking("de"):
        assert day_and_date(night.start) == "Sa., 24. Okt. 2026"
        assert zone_text(night) == "Europe/Rome (UTC+02:00 bis 03:00 +1 T, danach UTC+01:00)"
    with speaking("en"):
        assert day_and_date(night.start) == "Sat, 24 Oct 2026"


@pytest.mark.parametrize("code", ["", "xx", "deutsch", "de-XX-YY-ZZ", "../en", "en\0", 7, None])
def test_a_language_that_is_not_there_is_told_in_one_line(code: object) -> None:
    with pytest.raises(ScenarioError, match="language") as told:
        language_of(code)  # type: ignore[arg-type]  # what nobody may give
    assert "\n" not in str(told.value)


def test_a_clock_has_12_or_24_hours() -> None:
    with pytest.raises(ScenarioError, match="24 or 12"):
        language_of("en", 13)


PLAN_TEXTS = {key: text for key, text in language_of("en").texts.items() if key.startswith("plan.")}
WORDS = st.text("abcXYZ 012'-", min_size=1, max_size=12).filter(lambda text: text == text.strip())


@pytest.mark.parametrize("key", PLAN_TEXTS)
@given(data=st.data())
def test_a_sentence_of_a_plan_is_told_in_other_words(key: str, data: st.DataObject) -> None:
    text = PLAN_TEXTS[key]
    assert isinstance(text, str)
    filled = {name: data.draw(WORDS) for name in fields(text)}
    english = text.format_map(filled)
    assert in_language(english) == english
    with speaking("de"):
        assert in_language(english) == say(key, **filled)


def plans_on_italy() -> Iterator[Plan]:
    """Plans by the planner with all that it has to remark: windows, cases, small platoons."""
    net = italy()
    weights = PaperCosts()
    draw = np.random.default_rng(7)
    cities = ("Torino", "Milano", "Bologna", "Verona", "Venezia", "Roma", "Napoli", "Genova")
    six = datetime(2026, 11, 27, 6)
    for case in ("A", "B", "C", "D", "best", "best"):
        for windows in (None, 2, 30):
            trips = []
            for name in "KL" if case == "D" else "KLMN":
                origin, destination = draw.choice(len(cities), 2, replace=False)
                leave = six + timedelta(minutes=int(draw.integers(0, 90)))
                times = {} if windows is None else {
                    "earliest_departure": leave, "latest_arrival": leave + timedelta(hours=windows),
                }  # fmt: skip
                trips.append(Trip(name, cities[origin], cities[destination], **times))
            for chosen in ({}, {"max_platoon": 2, "objective": "system"}):
                yield plan_joint(net, weights, trips, case, **chosen)


def test_all_that_the_planner_says_of_a_plan_is_told_in_other_words() -> None:
    told = 0
    with speaking("it"):
        for plan in plans_on_italy():
            said = [*plan.proof.conditions, *plan.remarks, *(one.reason for one in plan.vehicles)]
            for sentence in filter(None, said):
                assert in_language(sentence) != sentence, sentence
                told += 1
    assert told > 50


def test_shares_in_sentences_have_the_signs_of_the_language() -> None:
    sentence = (
        "case D would save 3.2% in all, but T 7 would pay 1.5% more than alone; "
        'ask for objective "system" and share the gain'
    )
    with speaking("de"):
        assert "3,2\u202f%" in in_language(sentence)
        assert "T 7 würde 1,5\u202f% mehr" in in_language(sentence)


@pytest.mark.parametrize(
    ("late", "german", "italian"),
    [
        (["A by 54 min"], "A um 54 min", "A di 54 min"),
        (["A by 2 h 44 min", "B by 54 min"], "A um 2 h 44 min und B um 54 min", "e B di 54 min"),
        (["Smith, Sons and Co by 1 min"], "Smith, Sons and Co um 1 min", "Smith, Sons and Co di"),
        (["A and B by less than a minute", "C by 3 min"], "A and B um weniger als eine", "e C di"),
        ([f"{k} by {k} min" for k in range(1, 30)], "2 um 2 min, 3 um", " e altri "),
        (["by the sea"], "by the sea", "by the sea"),
    ],
)
def test_who_is_late_is_listed_in_other_words(late: list[str], german: str, italian: str) -> None:
    sentence = (
        f"not feasible in time: late are at best {listed(late)}; give earlier departures, later "
        "arrivals, or other company"
    )
    for language, told in (("de", german), ("it", italian)):
        with speaking(language):
            assert told in in_language(sentence)
            assert "give earlier" not in in_language(sentence)
            assert " more" not in in_language(sentence)


def test_why_trips_of_a_fleet_are_not_planned_is_told_in_other_words() -> None:
    six, soon = datetime(2026, 11, 27, 6), datetime(2026, 11, 27, 7)
    ends = {
        "good": ("Milano", "Roma"), "late": ("Milano", "Roma"), "timeless": ("Milano", "Roma"),
        "here": ("Roma", "Roma"), "lost": ("Qqqqqq", "Roma"), "near": ("Milano", "Napolli"),
        "far": ((0.0, 0.0), "Roma"), "swapped": ((45.46, 9.19), "Roma"),
    }  # fmt: skip
    trips = [
        Trip(
            name, *places,
            earliest_departure=None if name == "timeless" else six,
            latest_arrival=soon if name == "late" else None,
        )
        for name, places in ends.items()
    ]  # fmt: skip
    told = modelled(Problem(italy(), trips, PaperCosts()), Limits(rounds=1)).unserved
    assert {one.vehicle for one in told} == set(ends) - {"good"}
    english = re.compile(r"give|origin|destination:|no junction|nearest|late even|names no")
    for language in ("de", "it"):
        with speaking(language):
            for one in told:
                # What to do about a place far away is told in the words of the command.
                said = in_language(one.reason).rpartition(";")[0] or in_language(one.reason)
                assert not english.search(said), one
    with speaking("de"):
        assert "weniger als eine Minute" in in_language(
            "late even alone by less than a minute; give an earlier departure or a later arrival"
        )
