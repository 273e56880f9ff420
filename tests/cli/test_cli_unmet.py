"""What cannot be as it was asked ends with status 1, said in one line on standard error."""

from pathlib import Path

import pytest
from command_line import refused, run

from platoon_osm.driving.limits import Limits
from platoon_osm.driving.rules import RULES, Rules

LATE = """network = "italy-motorways"
case = "C"
[[trips]]
vehicle = "A"
origin = "Milano"
destination = "Napoli"
earliest_departure = 2026-03-02T06:00:00
latest_arrival = 2026-03-02T{arrival}:00:00
[[trips]]
vehicle = "B"
origin = "Torino"
destination = "Roma"
"""


@pytest.fixture(autouse=True)
def _inside(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_who_must_be_late_even_alone_is_told_and_everything_is_written(capsys):
    Path("late.toml").write_text(LATE.format(arrival=12))
    status = run("plan", "late.toml", "--json", "late.json")
    out, err = capsys.readouterr()
    assert status == 1
    assert err.splitlines()[-1].startswith(
        "platoon-osm: not feasible in time: late even alone: A by"
    )
    assert "A  " in out
    assert Path("late.json").is_file()
    status = run("compare", "late.toml", "--cases", "A,C", "-o", "both.html")
    assert status == 1
    assert capsys.readouterr().err.count("late even alone: A") == 1
    assert Path("both.html").is_file()


def test_who_is_in_time_ends_with_0(capsys):
    Path("fine.toml").write_text(LATE.format(arrival=18))
    assert run("plan", "fine.toml") == 0
    assert "not feasible" not in capsys.readouterr().err


def test_the_rules_of_company_come_from_options_and_from_the_scenario(capsys):
    text = LATE.format(arrival=18)
    Path("plain.toml").write_text(text)
    Path("rules.toml").write_text(
        text.replace('case = "C"', 'case = "C"\nmaster = "longest"\ncompany = "master"\n'
                     "max_platoon = 2\npatience_min = 30")
    )  # fmt: skip
    assert run("plan", "rules.toml") == 0
    told = capsys.readouterr().out
    options = ("--master", "longest", "--company", "master", "--max-platoon", "2",
               "--patience-min", "30")  # fmt: skip
    assert run("plan", "plain.toml", *options) == 0
    assert capsys.readouterr().out == told


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("max_platoon = 1", "max_platoon is 1; give a whole number"),
        ("max_platoon = 'two'", "max_platoon is 'two'"),
        ("patience_min = -5", "patience_min is -5"),
        ("company = 'nobody'", "company 'nobody' is unknown"),
    ],
)
def test_rules_that_are_none(line, said, capsys):
    Path("bad.toml").write_text(LATE.format(arrival=18).replace('case = "C"', line))
    assert run("plan", "bad.toml") == 2
    assert said in capsys.readouterr().err
    assert run("scenario", "--check", "bad.toml") == 2
    assert said in capsys.readouterr().err


FAR = """network = "italy-motorways"
[[trips]]
vehicle = "A"
origin = [9.0, 43.4]
destination = "Roma"
"""


def test_how_far_a_place_may_be_can_be_said_where_the_remedy_says(capsys):
    Path("far.toml").write_text(FAR)
    assert run("plan", "far.toml") == 2
    told = capsys.readouterr().err
    assert "more than 50 km" in told
    assert "--access-limit-km, or access_limit_km in a scenario" in told
    assert run("plan", "far.toml", "--access-limit-km", "100") == 0
    assert "access 1" in capsys.readouterr().out
    Path("farther.toml").write_text(f"access_limit_km = 100\n{FAR}")
    assert run("plan", "farther.toml") == 0
    for value in ("-1", "'far'", "true"):
        Path("bad.toml").write_text(f"access_limit_km = {value}\n{FAR}")
        capsys.readouterr()
        assert run("plan", "bad.toml") == 2
        assert run("scenario", "--check", "bad.toml") == 2
        assert capsys.readouterr().err.count("\n") == 2


LAW = """network = "italy-motorways"
[[trips]]
vehicle = "A"
origin = "Milano"
destination = "Bologna"
earliest_departure = 2026-03-02T06:00:00
latest_departure = 2026-03-02T07:00:00
driver = {{{driver}}}
"""
SPENT = "driven_today_h = 9, driven_since_break_h = 0, long_days_used = 2, duty_h = 10"


def test_who_must_rest_beyond_the_latest_departure_is_told_and_everything_is_written(capsys):
    Path("spent.toml").write_text(LAW.format(driver=SPENT))
    assert run("plan", "spent.toml", "--rules", "eu561", "--json", "spent.json") == 1
    out, err = capsys.readouterr()
    said = "not feasible within the law: leave after their latest departure, for they must rest"
    assert err.splitlines()[-1].startswith(f"platoon-osm: {said} before: A by 8 h")
    assert out.splitlines()[2].startswith(said)
    assert out.count("not feasible") == 1
    assert Path("spent.json").is_file()
    assert run("plan", "spent.toml") == 0


def test_rules_that_no_trip_keeps_end_with_1(capsys):
    # No two places of the map where a truck may stand are as near as a minute.
    RULES.add(Rules("a-minute", "an hour of break after a minute", Limits(60.0, 3600.0)))
    try:
        Path("fresh.toml").write_text(LAW.format(driver=""))
        assert run("plan", "fresh.toml", "--rules", "a-minute", "--json", "a.json") == 1
    finally:
        RULES.remove("a-minute")
    out, err = capsys.readouterr()
    assert out == ""
    assert err.splitlines()[-1].startswith("platoon-osm: A: no trip keeps the driving rules 'a-mi")
    assert not Path("a.json").exists()


def test_rules_without_a_clock_are_refused(capsys):
    text = LAW.format(driver="").replace("earliest_departure", "# ").replace("latest_dep", "# ")
    Path("timeless.toml").write_text(text)
    refused(capsys, ["plan", "timeless.toml", "--rules", "eu561"], "timeless.toml: driving rules")
