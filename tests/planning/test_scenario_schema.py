"""The published form of scenarios: what is bundled fits it, and it refuses what the reader does."""

import copy
import json
import tomllib
from datetime import datetime
from pathlib import Path

import jsonschema
import pytest
from places import ROOT

import platoon_osm as po
from platoon_osm.costs.presets import PRESETS
from platoon_osm.driving.rules import RULES
from platoon_osm.driving.state import STATE_KEYS
from platoon_osm.planning.scenario.keys import TRIP_KEYS
from platoon_osm.planning.scenario.network_table import NETWORK_KEYS
from platoon_osm.planning.scenario.reading import TABLE_KEYS, TOP_KEYS, read_scenario
from platoon_osm.planning.scenario.trip_rows import PLACE_KEYS
from platoon_osm.plans.trip import LONGEST_MIN
from platoon_osm.sources.country.law import laws

SCHEMA = json.loads((ROOT / "docs" / "scenario.schema.json").read_text(encoding="utf-8"))
FIT = jsonschema.Draft202012Validator(SCHEMA)
FILES = sorted([
    *(Path(po.__file__).parent / "scenarios").glob("*.toml"), *(ROOT / "examples").glob("*.toml"),
])  # fmt: skip


def as_json(value):
    """Return what TOML holds as JSON would."""
    if isinstance(value, dict):
        return {key: as_json(item) for key, item in value.items()}
    if isinstance(value, list):
        return [as_json(item) for item in value]
    return value.isoformat() if isinstance(value, datetime) else value


def test_the_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_it_knows_every_key():
    defs = SCHEMA["$defs"]
    assert set(SCHEMA["properties"]) == set(TOP_KEYS)
    assert set(defs["network"]["properties"]) == set(NETWORK_KEYS)
    assert set(defs["trip"]["properties"]) == set(TRIP_KEYS)
    assert set(defs["place"]["oneOf"][1]["properties"]) == set(PLACE_KEYS)
    assert set(SCHEMA["properties"]["trips"]["oneOf"][1]["properties"]) == set(TABLE_KEYS)
    for names, then in (
        (("paper",), 0),
        (("eu", "us"), 1),
        (("fuel",), 2),
    ):
        told = set(defs["costs"]["allOf"][then]["then"]["properties"]) - {"preset"}
        for name in names:
            assert told == set(PRESETS[name].parameters)
    codes = defs["network"]["properties"]["country"]["enum"]
    assert set(codes) == {*laws(), *(code.lower() for code in laws())}
    assert defs["trip"]["properties"]["flexibility_min"]["maximum"] == LONGEST_MIN
    assert list(defs["driver"]["properties"]) == list(STATE_KEYS)
    assert SCHEMA["properties"]["rules"]["examples"] == list(RULES)


@pytest.mark.parametrize("file", FILES, ids=[file.name for file in FILES])
def test_what_is_bundled_fits_it(file):
    FIT.validate(as_json(tomllib.loads(file.read_text(encoding="utf-8"))))
    read_scenario(file).check()


TRIPS = [
    {"vehicle": "A", "origin": "Torino", "destination": [13.77, 45.65]},
    {
        "vehicle": "B", "origin": {"at": [8.9, 44.4], "label": "Depot"},
        "destination": {"osmid": 7}, "earliest_departure": "2026-03-02T06:00:00",
        "flexibility_min": 30,
    },
]  # fmt: skip
GOOD = {"network": "n", "case": "C", "trips": TRIPS}


DRIVER = {
    "driven_since_break_min": 90, "first_part_taken": True, "driven_today_h": 2, "duty_h": 3.5,
    "driven_this_week_s": 7200, "driven_last_week_h": 0, "long_days_used": 1,
    "reduced_rests_used": 3, "since_weekly_rest_h": 20, "drivers": 2,
}  # fmt: skip
AT_MOST = {"driven_since_break_min": 1440, "driven_today_s": 86400, "duty_h": 30, "drivers": 2}


def toml(value):
    """Write a value as TOML, on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(toml(item) for item in value) + "]"
    return json.dumps(value)


def with_driver(driver, **more):
    at = {"earliest_departure": "2026-03-02T06:00:00"}
    return {**GOOD, "trips": [{**TRIPS[0], **at, "driver": driver}], **more}


def both_say(data, folder):
    """Whether schema and reader take a scenario."""
    file = folder / "s.toml"
    file.write_text("".join(f"{key} = {toml(value)}\n" for key, value in data.items()))
    try:
        read_scenario(file).check()
    except po.PlatoonError:
        return FIT.is_valid(data), False
    return FIT.is_valid(data), True


def test_both_take_what_is_right(tmp_path):
    assert both_say(GOOD, tmp_path) == (True, True)
    (tmp_path / "t.csv").write_text("vehicle,origin,destination\nA,x,y\n")
    for trips in ("t.csv", {"file": "t.csv"}):
        assert both_say({**GOOD, "trips": trips}, tmp_path) == (True, True)
    for rules in RULES:
        asked = {**GOOD, "rules": rules, "task_relief": 0.5}
        assert both_say(asked, tmp_path) == (True, True)
    for driver in ({}, DRIVER, AT_MOST):
        assert both_say(with_driver(driver, rules="eu561"), tmp_path) == (True, True)


@pytest.mark.parametrize("key", STATE_KEYS)
def test_both_refuse_a_driver_that_cannot_be(tmp_path, key):
    top = SCHEMA["$defs"]["driver"]["properties"][key].get("maximum", 1) + 1
    for value in (-1, top, "x", [], {}, not key.startswith("first")):
        if key == "first_part_taken" and value is False:
            continue
        assert both_say(with_driver({key: value}), tmp_path) == (False, False), value
    wrong = [{f"{key}s": 1}, {key.replace("_", "-") + "-": 1}]
    for driver in (*wrong, 3, "rested", [1]):
        assert both_say(with_driver(driver), tmp_path) == (False, False)


WRONG = [
    (["network"], None), (["network"], 3), (["network"], ""), (["network"], {}),
    (["network"], {"source": "n", "clases": []}), (["network"], {"source": 3}),
    (["network"], {"source": "n", "classes": "motorway"}),
    (["network"], {"source": "n", "classes": []}), (["network"], {"source": "n", "classes": [1]}),
    (["network"], {"source": "n", "country": "xx"}), (["network"], {"source": "n", "country": 1}),
    (["network"], {"source": "n", "limiter_kmh": -5}),
    (["network"], {"source": "n", "limiter_kmh": "90"}),
    (["network"], {"source": "n", "limiter_kmh": True}),
    (["network"], {"source": "n", "infer_links": "yes"}),
    (["network"], {"source": "n", "infer_links": 1}),
    (["title"], ""), (["title"], 3), (["case"], "E"), (["case"], 1), (["optimum"], "both"),
    (["method"], "magic"), (["master"], ""), (["colour"], "red"), (["costs"], 3),
    (["costs"], {"tau": 2}), (["costs"], {"tau": "1"}), (["costs"], {"mixing": "none"}),
    (["rules"], ""), (["rules"], 561), (["rules"], ["eu561"]), (["task_relief"], -0.1),
    (["task_relief"], 1.1), (["task_relief"], "0.5"), (["task_relief"], True),
    (["costs"], {"tua": 1}), (["costs"], {"preset": 3}), (["costs"], {"rest_s": -1}),
    (["costs"], {"speed_kmh": 0}), (["costs"], {"positions": ""}),
    (["trips"], []), (["trips"], 3), (["trips"], ""), (["trips"], {}), (["trips"], ["A"]),
    (["trips"], {"sheet": "x"}), (["trips"], {"file": "t.csv", "sheets": "x"}),
    (["trips", 0, "vehicle"], ""), (["trips", 0, "vehicle"], 3), (["trips", 0, "vehicle"], None),
    (["trips", 0, "origin"], ""), (["trips", 0, "origin"], 3), (["trips", 0, "origin"], [1]),
    (["trips", 0, "origin"], [1, 2, 3]), (["trips", 0, "origin"], ["1", "2"]),
    (["trips", 0, "origin"], [True, False]), (["trips", 0, "origin"], {}),
    (["trips", 0, "origin"], {"label": "x"}), (["trips", 0, "origin"], {"osmid": 1.5}),
    (["trips", 0, "origin"], {"osmid": "1"}), (["trips", 0, "origin"], {"osmid": True}),
    (["trips", 0, "origin"], {"osmid": 1, "at": "x"}), (["trips", 0, "origin"], {"at": {}}),
    (["trips", 0, "origin"], {"at": "x", "label": ""}), (["trips", 0, "origin"], {"att": "x"}),
    (["trips", 0, "origin"], {"at": {"at": "x"}}), (["trips", 0, "destination"], None),
    (["trips", 0, "orgin"], "x"), (["trips", 0, "latest_arrival"], "soon"),
    (["trips", 0, "latest_arrival"], "06:00"), (["trips", 0, "latest_arrival"], 3),
    (["trips", 0, "latest_arrival"], "03/02/2026 06:00"),
    (["trips", 0, "flexibility_min"], 3), (["trips", 1, "flexibility_min"], -1),
    (["trips", 1, "flexibility_min"], "30"), (["trips", 1, "flexibility_min"], True),
    (["trips", 1, "flexibility_min"], 1e9), (["trips", 1, "earliest_departure"], None),
    (["trips", 1, "latest_arrival"], "2026-03-02T09:00:00"),
]  # fmt: skip


@pytest.mark.parametrize(("path", "value"), WRONG, ids=[f"{p[-1]}={v!r:.40}" for p, v in WRONG])
def test_both_refuse_what_is_wrong(tmp_path, path, value):
    data = copy.deepcopy(GOOD)
    place = data
    for step in path[:-1]:
        place = place[step]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    assert both_say(data, tmp_path) == (False, False)
