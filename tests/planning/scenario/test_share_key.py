"""The rule by which the gain is shared, in TOML and as an option."""

import pytest
from click.testing import CliRunner

import platoon_osm as po
from platoon_osm.cli.verbs.plan import verb
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario.reading import read_scenario

TRIPS = """
[[trips]]
vehicle = "A"
origin = "Milano"
destination = "Napoli"

[[trips]]
vehicle = "B"
origin = "Brescia"
destination = "Roma"
"""


def scenario(tmp_path, share):
    file = tmp_path / "shared.toml"
    file.write_text(
        f'network = "italy-motorways"\nobjective = "eu"\nshare = "{share}"\n{TRIPS}',
    )
    return file


def test_it_comes_from_a_file(tmp_path):
    net = po.load_network("italy-motorways")
    plan = read_scenario(scenario(tmp_path, "shapley")).plan(net)
    assert plan.gain.rule == "shapley"
    with pytest.raises(ScenarioError, match="share 'fair' is unknown; use equal, shapley, least"):
        read_scenario(scenario(tmp_path, "fair")).plan(net)


def test_the_option_comes_before_the_file(tmp_path):
    out = tmp_path / "plan.json"
    done = CliRunner().invoke(
        verb, [str(scenario(tmp_path, "shapley")), "--share", "least-core", "--json", str(out)]
    )
    assert done.exit_code == 0, done.output
    assert po.Plan.read_json(out).gain.rule == "least-core"
