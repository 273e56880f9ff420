"""Scenarios and trip tables that `plan` refuses."""

from pathlib import Path

import pytest
from command_line import (
    CORRIDOR,
    NODE,
    OUTPUTS,
    osm,
    refused,
    run,
    scenario,
    trips_between,
    two_roads,
)

import platoon_osm as po
from platoon_osm.errors import ScenarioError


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('case = "C"', 'caes = "C"', "no key 'caes'; did you mean 'case'?"),
        ("[[trips]]", "[[trip]]", "did you mean 'trips'?"),
        ('origin = "Genova"', 'orign = "Genova"', "did you mean 'origin'?"),
        ('case = "C"', "[costs]\nfuel_savings = 0.1", "did you mean 'fuel_saving'?"),
        ('network = "italy-motorways"', '[network]\nsorce = "x"', "network is missing"),
        ('network = "italy-motorways"', "", "network is missing"),
        ('case = "C"', 'case = "E"', "case 'E' is unknown; use A, B, C, D, best"),
        ('case = "C"', "case = 3", "must be a text in quotes"),
        ('case = "C"', 'optimum = "both"', "optimum 'both' is unknown; use member, system"),
        ('case = "C"', 'method = "magic"', "method 'magic' is unknown; use dijkstra, astar"),
        ('case = "C"', 'master = "Z"', "master 'Z' has no trip; vehicles are A and B"),
        ('case = "C"', "[costs]\ntau = -0.5", "tau = -0.5 must be a number in [0, 1]"),
        ('case = "C"', "[costs]\nspeed_kmh = -80", "speed_kmh = -80 must be a number"),
        ('case = "C"', "[costs]\nfuel_saving = nan", "fuel_saving = nan must be a number"),
        ('"Belluno"', '"Genova"', "same place"),
        ('"Belluno"', '"Bellumo"', "did you mean Belluno"),
        ('"Belluno"', '"ovest"', "ambiguous"),
        ('"Belluno"', "[13.7, 145.6]", "latitude within [-90, 90]"),
        ('"Belluno"', "[nan, 45.6]", "longitude comes first"),
        ('"Belluno"', "[13.7]", "must be a name or a [lon, lat] pair"),
        ('vehicle = "B"', 'vehicle = "A"', "vehicle 'A' has 2 trips"),
        ('vehicle = "B"', 'vehicle = ""', "vehicle"),
        ('vehicle = "B"\n', "", "has no vehicle"),
        ("title =", "title", "not a TOML file"),
    ],
)
def test_bad_scenarios(capsys, old, new, said):
    text = CORRIDOR.format(network="italy-motorways")
    assert old in text
    # A table must not swallow the keys after it, so it goes to the end.
    changed = (
        text.replace(old, "") + new if new.startswith("[costs]") else text.replace(old, new, 1)
    )
    Path("bad.toml").write_text(changed)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", said)


@pytest.mark.parametrize("value", ["-5", '"fast"', "nan", "true"])
def test_a_limiter_that_is_no_speed(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nlimiter_kmh = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "limiter_kmh")


@pytest.mark.parametrize("value", ['"motorway"', "[1, 2]", "5"])
def test_classes_that_are_no_list(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nclasses = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "classes")


def test_an_unreachable_destination(capsys):
    Path("bad.toml").write_text(trips_between((11.1, 45.0), (11.4, 45.1), two_roads()))
    refused(
        capsys, ["plan", "bad.toml", *OUTPUTS], "'A'", "no route from", "two.osm", "--infer-links",
        status=1,
    )  # fmt: skip


def test_origin_and_destination_in_one_spot(capsys):
    spot = (7.6, 45.1)
    Path("bad.toml").write_text(trips_between(spot, spot, "italy-motorways"))
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", "'A'", "same place")


CSV = 'network = "{network}"\ncase = "C"\ntrips = "trips.csv"\n'


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("vehicle,orign,destination\nA,Torino,Genova\n", "did you mean 'origin'?"),
        ("vehicle,origin,destination\n", "no rows"),
        ("vehicle,origin,destination\nA,Torino\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,Nowhere at all\n", "no junction or town"),
        ("vehicle;origin;destination\nA;Torino;Nowhere at all\n", "no junction or town"),
        ("", "no rows"),
        ('vehicle,origin,destination\nA,"Torino,Genova\n', "trips.csv"),
    ],
)
def test_bad_trip_tables(capsys, table, said):
    Path("trips.csv").write_text(table)
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], said)


def test_missing_scenario_and_missing_table(capsys):
    refused(capsys, ["plan", "gone.toml", *OUTPUTS], "gone.toml: cannot be read")
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], "trips.csv: cannot be read")


def test_a_scenario_that_is_a_folder_or_no_text(capsys):
    Path("dir.toml").mkdir()
    refused(capsys, ["plan", "dir.toml"], "dir.toml: cannot be read")
    Path("bytes.toml").write_bytes(b"\xff\xfe\x00")
    refused(capsys, ["plan", "bytes.toml"], "bytes.toml: begins as UTF-16 text and breaks off")


def test_control_characters_of_a_map_do_not_reach_the_terminal(capsys):
    text = CORRIDOR.format(network="italy-motorways").replace('"Belluno"', '"\\u001b[31mred\\nX"')
    Path("bad.toml").write_text(text)
    assert "\x1b" not in refused(capsys, ["plan", "bad.toml"], "red")


GAP = {1: (11.0, 45.0), 2: (11.1, 45.0), 3: (11.1008, 45.0), 4: (11.2, 45.0)}
"""Two pieces of a carriageway 60 m apart, as in extracts cut to motorways."""


def gap(name):
    ways = "".join(
        f'<way id="{a}"><nd ref="{a}"/><nd ref="{b}"/><tag k="highway" v="motorway"/>'
        '<tag k="oneway" v="yes"/></way>'
        for a, b in ((1, 2), (3, 4))
    )
    return osm(name, *(NODE.format(key, *at) for key, at in GAP.items()), ways)


def test_each_remedy_that_a_message_names_is_there_where_it_was_given(capsys):
    """No route: the three spellings of one remedy, each tried."""
    text = trips_between(GAP[1], GAP[4], gap("gap.osm"))
    Path("s.toml").write_text(text)
    said = refused(capsys, ["plan", "s.toml"], "no route from", status=1)
    assert "infer_links=True, --infer-links, or infer_links = true below [network]" in said
    assert run("plan", "s.toml", "--infer-links") == 0
    changed = text.replace('network = "gap.osm"\n', "")
    Path("t.toml").write_text(f'{changed}[network]\nsource = "gap.osm"\ninfer_links = true\n')
    assert run("plan", "t.toml") == 0
    net = po.load_network("gap.osm", infer_links=True)
    assert po.plan_joint(net, po.paper_weights(net), [po.Trip("A", GAP[1], GAP[4])]).solo_cost > 0


def test_a_remedy_that_was_tried_is_not_named_again():
    for inferred in (False, True):
        net = po.RoadNetwork.from_edges(
            [0, 2], [1, 3], lon=[9.0, 9.1, 9.2, 9.3], lat=[45.0] * 4, inferred=[inferred, False]
        )
        with pytest.raises(po.NoRouteError, match="no route from") as error:
            po.plan_joint(net, po.paper_weights(net), [po.Trip("A", 0, 3)])
        assert ("infer_links" in str(error.value)) is not inferred


@pytest.mark.parametrize(
    ("options", "key", "value"),
    [
        (["--classes", "motorway,trunk"], "classes", ["motorway", "trunk"]),
        (["--country", "de"], "country", "de"),
        (["--limiter-kmh", "85"], "limiter_kmh", 85.0),
        (["--limiter", "85"], "limiter_kmh", 85.0),
        (["--infer-links"], "infer_links", True),
    ],
)
def test_options_of_the_network_come_before_the_scenario(monkeypatch, options, key, value):
    from platoon_osm.sources import load

    asked = {}

    def noted(**loading):
        asked.update(loading)
        raise ScenarioError("seen")

    monkeypatch.setattr(load, "load_network", noted)
    Path("s.toml").write_text(
        trips_between(GAP[1], GAP[4], "n").replace('network = "n"\n', "")
        + '[network]\nsource = "n"\nclasses = ["motorway"]\nlimiter_kmh = 80\ncountry = "IT"\n'
    )
    assert run("plan", "s.toml", *options) == 2
    own = {"source": "n", "classes": ["motorway"], "limiter_kmh": 80, "country": "IT"}
    wanted = own | {key: tuple(value) if isinstance(value, list) else value}
    assert asked == wanted
    asked.clear()
    assert run("plan", "s.toml") == 2
    assert asked == own
