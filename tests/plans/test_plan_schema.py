"""The published form of a plan: what is written fits it, and it knows every field."""

import copy
import json
from dataclasses import fields

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import ROOT
from random_networks import problems

from platoon_osm.costs.cost_figure import CostFigure
from platoon_osm.costs.share import Share
from platoon_osm.driving.state import DriverState
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans import records
from platoon_osm.plans.bill import Bill, VehicleBill
from platoon_osm.plans.chances import Chances, MeetingChance
from platoon_osm.plans.fleet import FleetRecord, Moment, Unserved
from platoon_osm.plans.gain import GainShare, GainSharing
from platoon_osm.plans.pauses import DriverDay, Pause, PausePlace
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.proof import Proof
from platoon_osm.plans.rotation import LeadChange, Rotation
from platoon_osm.plans.timetable import Timetable, VehicleTimes
from platoon_osm.vehicles.profile import Vehicle

SCHEMA = json.loads((ROOT / "docs" / "plan.schema.json").read_text(encoding="utf-8"))
FIT = jsonschema.Draft202012Validator(SCHEMA)

RECORDS = {
    "stop": records.Stop, "point": records.PlatoonPoint, "solo_route": records.SoloRoute,
    "trip": records.PlannedTrip, "share": Share, "stretch": records.Stretch,
    "platoon": records.Platoon, "event": records.Event, "network": records.NetworkIdentity,
    "proof": Proof, "timetable": Timetable, "vehicle_times": VehicleTimes,
    "master_tried": records.MasterTried, "profile": Vehicle, "pause": Pause,
    "pause_place": PausePlace, "driver_day": DriverDay, "driver_state": DriverState,
    "bill": Bill, "cost_figure": CostFigure, "vehicle_bill": VehicleBill,
    "gain_sharing": GainSharing, "gain_share": GainShare,
    "chances": Chances, "meeting_chance": MeetingChance, "rotation": Rotation,
    "lead_change": LeadChange, "fleet": FleetRecord, "moment": Moment, "unserved": Unserved,
}  # fmt: skip


def test_the_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_it_knows_every_field():
    assert set(SCHEMA["properties"]) == {item.name for item in fields(Plan)}
    assert set(SCHEMA["$defs"]) == {*RECORDS, "span", "line"}
    for name, kind in RECORDS.items():
        assert set(SCHEMA["$defs"][name]["properties"]) == {item.name for item in fields(kind)}


@settings(max_examples=40, deadline=None)
@given(problems(), st.sampled_from(["A", "B", "C", "D", "best"]), st.booleans())
def test_what_is_written_fits_it(problem, case, system):
    net, weights, trips = problem
    trips = trips[:2] if case == "D" else trips
    plan = plan_joint(net, weights, trips, case, objective="system" if system else "member")
    FIT.validate(plan.to_dict())


@pytest.mark.parametrize("version", [1, 2, 3])
def test_plans_of_older_versions_fit_it_once_read(version):
    text = (ROOT / "tests" / "plans" / "older" / f"version-{version}.json").read_text("utf-8")
    for data in json.loads(text).values():
        assert not FIT.is_valid(data)
        FIT.validate(Plan.from_dict(data).to_dict())


def damaged(data, path, value):
    other = copy.deepcopy(data)
    *way, last = path
    part = other
    for step in way:
        part = part[step]
    if value is KeyError:
        del part[last]
    else:
        part[last] = value
    return other


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (["plan_version"], 2), (["colour"], "red"), (["trips"], KeyError), (["case"], "E"),
        (["stretches", 0, "edges"], []),
        (["stretches", 0, "span"], [0, 2]), (["stretches", 0, "access"], [[9, 45], [9.1, 45]]),
        (["trips", 0, "alone", "access"], [None]), (["trips", 0, "origin", "share"], 1.5),
        (["stretches", 0, "vehicles"], [-1]),
        (["stretches", 0, "shares", 0, "cost"], "1"), (["stretches", 0, "drive_s"], None),
        (["proof", "kind"], "perhaps"), (["proof", "gap"], 0.1), (["events", 0, "kind"], "meet"),
        (["platoons", 0, "master"], "A"), (["network", "nodes"], 1.5), (["timetable"], []),
    ],
)  # fmt: skip
def test_it_refuses_what_is_no_plan(path, value):
    text = (ROOT / "tests" / "plans" / "older" / "version-2.json").read_text("utf-8")
    plan = Plan.from_dict(json.loads(text)["three"]).to_dict()
    assert FIT.is_valid(plan)
    assert not FIT.is_valid(damaged(plan, path, value))
