"""Driving rules as the command is asked for them: plan, demo, compare."""

from pathlib import Path

import pytest
from command_line import refused, run, scenario

from platoon_osm.driving.rules import RULES, Rules
from platoon_osm.planning.scenario import record

TRIP = (
    '[[trips]]\nvehicle = "A"\norigin = "Genova"\ndestination = "Belluno"\n'
    "earliest_departure = 2026-03-02T06:00:00\n"
)
SHORT = 'network = "{network}"\nrules = "us395"\n' + TRIP


@pytest.fixture
def asked(monkeypatch):
    """Return the rules and reliefs of all plans that are made."""
    seen = []
    plan_joint = record.plan_joint

    def noted(net, weights, trips, **options):
        seen.append((options.get("rules", "none"), options.get("task_relief", 0.0)))
        return plan_joint(net, weights, trips, **options | {"rules": "none"})

    monkeypatch.setattr(record, "plan_joint", noted)
    return seen


@pytest.mark.parametrize(
    ("options", "found"),
    [
        ([], ("us395", 0.0)),
        (["--rules", "eu561"], ("eu561", 0.0)),
        (["--rules", "none"], ("none", 0.0)),
        (["--rules", "spread-rest", "--task-relief", "0.5"], ("spread-rest", 0.5)),
        (["--task-relief", "1"], ("us395", 1.0)),
    ],
)
def test_options_of_plan_come_before_the_scenario(asked, capsys, options, found):
    assert run("plan", scenario(SHORT), *options) == 0
    assert asked == [found]


def test_rules_that_a_package_adds_are_listed_and_taken(asked, capsys):
    RULES.add(Rules("our-own", "four hours a day"))
    try:
        for verb in ("plan", "compare", "demo"):
            assert run(verb, "--help") == 0
        out = capsys.readouterr().out
        assert run("plan", scenario(SHORT), "--rules", "our-own") == 0
    finally:
        RULES.remove("our-own")
    assert "our-own      four hours a day" in out
    assert asked == [("our-own", 0.0)]


@pytest.mark.parametrize("verb", ["plan", "compare", "demo"])
def test_help_names_the_rules(capsys, verb):
    assert run(verb, "--help") == 0
    out = capsys.readouterr().out
    assert "--rules" in out
    assert all(name in out for name in RULES)


def test_the_demo_under_rules(asked, capsys):
    assert run("demo", "-o", "shown", "--rules", "us395") == 0
    assert asked == [("us395", 0.0)] * 4


def test_plans_under_several_rules_are_compared(asked, capsys):
    put = ["compare", scenario(SHORT), "-o", "c.html"]
    assert run(*put, "--cases", "A,C", "--rules", "none,eu561", "--task-relief", "0,1") == 0
    laws = [(name, relief) for name in ("none", "eu561") for relief in (0.0, 1.0)]
    assert asked == laws * 2
    out = capsys.readouterr().out
    page = Path("c.html").read_text(encoding="utf-8")
    for text in (out, page):
        for case in "AC":
            for name, relief in laws:
                assert f"corridor, case {case}, rules {name}, task relief {relief:g}" in text


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["plan", "s.toml", "--rules", "eu651"], "--rules: driving rules 'eu651' is unknown; did"),
        (["plan", "s.toml", "--rules", "law"], "use one of none, eu561, us395, spread-rest"),
        (["plan", "s.toml", "--task-relief", "2"], "s.toml: task_relief is 2.0; give a number"),
        (["plan", "s.toml", "--task-relief", "all"], "'all' is not a valid float"),
        (["plan", "s.toml", "--rule", "none"], "--rules"),
        (["demo", "--rules", "eu"], "--rules: driving rules 'eu' is unknown; did you mean 'eu561'"),
        (
            ["compare", "s.toml", "-o", "c.html", "--rules", "none,eu"],
            "--rules: driving rules 'eu'",
        ),
        (["compare", "s.toml", "-o", "c.html", "--rules", ","], "--rules: empty; give driving rul"),
        (
            ["compare", "s.toml", "-o", "c.html", "--task-relief", "0;1"],
            "--task-relief: '0;1'; give",
        ),
        (["compare", "s.toml", "-o", "c.html", "--rules", "none", "--task-relief", "3"], "is 3.0"),
    ],
)
def test_what_is_refused(capsys, arguments, said):
    scenario(SHORT, "s.toml")
    refused(capsys, arguments, said)
