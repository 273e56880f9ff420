"""[delays] and what goes with it, in TOML, in tables and as options."""

import pytest
from click.testing import CliRunner

import platoon_osm as po
from platoon_osm.cli.verbs.plan import verb
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario.delays_table import delays_of
from platoon_osm.planning.scenario.reading import read_scenario

TRIPS = """
[[trips]]
vehicle = "A"
origin = "Milano"
destination = "Bologna"
earliest_departure = 2026-03-02T06:00:00
flexibility_min = 20

[[trips]]
vehicle = "B"
origin = "Brescia"
destination = "Firenze"
earliest_departure = 2026-03-02T06:00:00
flexibility_min = 60
delay_spread_min = 15
"""


def scenario(tmp_path, top="", delays="[delays]\nspread_min = 8\n"):
    file = tmp_path / "late.toml"
    file.write_text(f'network = "italy-motorways"\n{top}\n{delays}\n{TRIPS}')
    return file


def test_all_of_it_comes_from_a_file(tmp_path):
    delays = (
        '[delays]\nspread_min = 8\ncorrelation = 0.5\nkind = "lognormal"\nshape = 0.8\n'
        'own = {A = 5}\npairs = [["A", "B", 0.25]]\n'
    )
    read = read_scenario(scenario(tmp_path, "robust = true", delays))
    read.check()
    problem = read.problem(po.load_network("italy-motorways"))
    assert problem.robust
    assert problem.delays == po.Delays(
        8, {"A": 5, "B": 15}, 0.5, {("A", "B"): 0.25}, "lognormal", 0.8
    )


def test_a_plan_tells_the_chances(tmp_path):
    net = po.load_network("italy-motorways")
    plan = read_scenario(scenario(tmp_path, "robust = true")).plan(net)
    assert plan.chances is not None
    assert "If vehicles are late (normal delays, 10,000 days drawn)" in plan.summary()
    assert "with a chance of" in plan.summary()
    assert any("plans compared on" in remark for remark in plan.remarks)


@pytest.mark.parametrize(
    ("top", "delays", "told"),
    [
        ("", "[delays]\nspread = 8", "[delays] has no key 'spread'; did you mean 'spread_min'?"),
        ("", "[delays]\ncorrelation = 0.5", "[delays] has no spread_min"),
        ("", "[delays]\nspread_min = -1", "delays: spread_min is -1"),
        ("", '[delays]\nspread_min = 8\npairs = ["A", "B", 0.5]', "[delays] pairs has 'A'"),
        ("", '[delays]\nspread_min = 8\npairs = [["A", "B", 0.5], ["A", "B", 0.4]]', "twice"),
        ("", '[delays]\nspread_min = 8\npairs = [[1, "B", 0.5]]', "two names of vehicles"),
        ("delays = 8", "", "delays must be a table"),
        ("robust = 1", "[delays]\nspread_min = 8", "robust is 1; give True or False"),
        ("robust = true", "", "robust weighs delays"),
        ("", "", "trip 'B' names delay_spread_min, but nothing is said of the others"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_the_file(tmp_path, top, delays, told):
    file = scenario(tmp_path, top, delays)
    with pytest.raises(ScenarioError) as caught:
        read_scenario(file).check()
    assert str(caught.value).startswith(f"{file}: ")
    assert told in str(caught.value)


def test_a_table_has_a_column_for_it(tmp_path):
    table = tmp_path / "trips.csv"
    table.write_text(
        "vehicle;origin;destination;Delay spread min\nA;Milano;Bologna;12,5\nB;Brescia;Firenze;\n"
    )
    assert [trip.delay_spread_min for trip in po.read_trips(table)] == [12.5, None]
    table.write_text("vehicle,origin,destination,delay_spread_min\nA,Milano,Bologna,soon\n")
    with pytest.raises(ScenarioError, match="line 2: delay_spread_min = 'soon' must be a number"):
        po.read_trips(table)


def test_options_come_before_the_file(tmp_path):
    file = scenario(tmp_path, delays='[delays]\nspread_min = 8\nkind = "lognormal"')
    done = CliRunner().invoke(verb, [str(file), "--delay-spread-min", "3", "--robust"])
    assert done.exit_code == 0, done.output
    assert "If vehicles are late (lognormal delays" in done.output
    assert "plans compared on" in done.output


def test_a_table_that_is_none_is_refused():
    with pytest.raises(ScenarioError, match="must be a table"):
        delays_of([8])
