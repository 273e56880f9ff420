"""Rules that spread rest over the driving are named by the plan, and whoever reads it says so."""

from datetime import datetime

import pytest
from bundled import italy
from command_line import run

import platoon_osm as po
from platoon_osm.driving.rules import RULES, Rules, places_pauses
from platoon_osm.planning.rules_told import with_rules

NAMED = "driving rules spread-rest"


def problem(rules, **more):
    net = italy()
    trips = [
        po.Trip("A", "Milano", "Napoli", datetime(2026, 3, 2, 6)),
        po.Trip("B", "Torino", "Napoli", datetime(2026, 3, 2, 5)),
    ]
    return po.Problem(net, trips, po.paper_weights(net), rules=rules, **more)


@pytest.fixture(scope="module")
def plan():
    return po.plan_joint(problem("spread-rest", task_relief=0.5))


def test_a_plan_names_rest_that_is_spread(plan):
    assert plan.timetable.rules == "spread-rest"
    # No clock slows: who follows drives a twelfth longer too.
    assert plan.timetable.task_relief == 0
    assert NAMED in plan.proof.conditions
    text = plan.summary()
    assert "Driving rules: the paper's: 45 min of rest for 9 h" in text
    # It stands at no place and no moment, so there is no break to be told, nor to be missed.
    assert "no break" not in text
    assert "rests" not in text.splitlines()[3]


def test_files_and_the_checker_read_it_back(plan, tmp_path, capsys):
    path = tmp_path / "plan.json"
    plan.write_json(path)
    assert po.Plan.read_json(path) == plan
    assert run("check", str(path)) == 0
    assert "the paper's spread rest" in capsys.readouterr().out
    assert run("check", str(path), "--rules", "eu561") == 1


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", "Planned under the paper’s rules, 45 min of rest for 9 h of driving"),
        ("de", "Geplant nach: Regeln des Artikels, 45 min Ruhe auf 9 h Lenken"),
        ("it", "Pianificato secondo: regole dell’articolo, 45 min di riposo ogni 9 h di guida"),
    ],
)
def test_the_page_says_so(plan, tmp_path, language, told):
    page = tmp_path / "plan.html"
    po.write_html(plan, italy(), page, language=language)
    assert told in page.read_text(encoding="utf-8")


def test_other_plans_name_what_they_did():
    assert po.plan_joint(problem("none")).timetable.rules == ""
    untimed = [po.Trip("A", "Milano", "Napoli"), po.Trip("B", "Torino", "Napoli")]
    without = po.plan_joint(italy(), po.paper_weights(italy()), untimed, rules="spread-rest")
    assert without.timetable is None
    assert NAMED in without.proof.conditions


def test_curves_name_it_too():
    for made in (po.departure_curve, po.delay_frontier):
        assert NAMED in made(problem("spread-rest")).conditions
        assert NAMED not in made(problem("none")).conditions


def test_which_rules_place_pauses():
    placed = {name: places_pauses(name) for name in RULES}
    assert placed == {"none": False, "eu561": True, "us395": True, "spread-rest": False}
    assert places_pauses("somebody's own")
    assert not places_pauses("")


def test_rules_of_ones_own_that_spread_rest():
    ours = Rules("half", "30 min for 8 h", spread=1 / 16)
    plan = with_rules(po.plan_joint(problem("none")), ours)
    assert plan.timetable.rules == "half"
    assert "Driving rules: half." in plan.summary()
    # The checker knows none of that name, as of any rules of one's own.
    with pytest.raises(po.ScenarioError, match="'half' have no checker"):
        po.inspect_plan(plan)
