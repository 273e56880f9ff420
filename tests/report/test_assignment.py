"""The tables of a fleet's dispatcher: who drives with whom, from where to where, and when."""

import csv
from dataclasses import replace
from datetime import datetime
from types import SimpleNamespace

import pytest

import platoon_osm as po
from platoon_osm.errors import PlatoonError
from platoon_osm.plans.fleet import FleetRecord, Unserved
from platoon_osm.plans.fleet_lines import fleet_lines
from platoon_osm.plans.proof_sentence import proof_sentence
from platoon_osm.report.exports.assignment import (
    company_parts,
    write_assignment,
    write_frame,
    write_unserved,
)


@pytest.fixture(scope="module")
def day():
    """A trunk from Alba to Dego; b joins at the second node and leaves at the fourth; c is away."""
    names = ["Alba", "Bra", "Cuneo", "Dego", "Exit", "East", "Far", "Gone"]
    pairs = [(0, 1), (1, 2), (2, 3), (4, 1), (2, 5), (6, 7)]
    lon = [8.0, 8.5, 9.0, 9.5, 8.4, 9.1, 11.0, 11.5]
    lat = [45.0, 45.0, 45.0, 45.0, 45.2, 45.2, 45.5, 45.5]
    net = po.RoadNetwork.from_edges(
        [a for a, _ in pairs], [b for _, b in pairs], [40_000.0] * 6, lon=lon, lat=lat,
        node_name=names,
    )  # fmt: skip
    at = datetime(2026, 3, 2, 6)
    trips = [
        po.Trip("=a", "Alba", "Dego", earliest_departure=at, flexibility_min=60),
        po.Trip("b", "Exit", "East", earliest_departure=at.replace(minute=10), flexibility_min=60),
        po.Trip("c", "Far", "Gone", earliest_departure=at, flexibility_min=60),
    ]
    plan = po.plan_joint(net, po.FuelCosts(), trips)
    record = FleetRecord(
        1.0, 1.0, 9.0, 0.1, 1.0, "free", "many", None, 0, "proved", 1,
        unserved=(Unserved("late", "late even alone by 5 min"),),
    )  # fmt: skip
    return replace(plan, fleet=record), net


def table(write, tmp_path):
    write(tmp_path / "t.csv")
    with (tmp_path / "t.csv").open(encoding="utf-8", newline="") as handle:
        return list(csv.DictReader(handle))


def test_a_row_for_each_part_in_company(day, tmp_path):
    plan, net = day
    a, b, c = table(lambda path: write_assignment(plan, net, path), tmp_path)
    assert (a["vehicle"], b["vehicle"], c["vehicle"]) == ("'=a", "b", "c")
    assert a["with"] == "b"
    assert b["with"] == "'=a"
    assert sorted((a["position"], b["position"])) == ["1", "2"]
    for row in (a, b):
        assert (row["merges_at"], row["separates_at"], row["km"]) == ("Bra", "Cuneo", "40")
        # Both are at the merge when the later one is; 40 km take half an hour at 80 km/h.
        assert row["merges_time"] == b["merges_time"]
        drive = datetime.fromisoformat(row["separates_time"]) - datetime.fromisoformat(
            row["merges_time"]
        )
        assert drive.total_seconds() == pytest.approx(40_000 / float(net.speed_mps[1]), abs=1)
    assert (c["with"], c["merges_at"], c["km"], c["saving_l"]) == ("", "", "", "")
    assert c["departs"] == "2026-03-02T06:00:00"
    saved = sum(float(row["saving_l"]) for row in (a, b))
    assert saved == pytest.approx(plan.solo_cost - plan.joint_cost, rel=1e-5)


def test_a_row_for_each_platoon(day, tmp_path):
    plan, _ = day
    (one,) = table(lambda path: write_frame(plan, "platoons", path), tmp_path)
    assert (one["size"], one["forms_at"], one["parts_at"]) == ("2", "Bra", "Cuneo")
    assert one["vehicles"].replace("'", "") == "=a, b"
    assert len(one["forms"]) == len("2026-03-02T06:00:00")
    assert float(one["saving_l"]) == pytest.approx(plan.solo_cost - plan.joint_cost, rel=1e-5)


def test_parts_cover_what_is_driven_in_company(day):
    plan, _ = day
    for vehicle, own in enumerate(plan.vehicles):
        legs = [k for k, leg in enumerate(own.legs) if leg.role == "platoon"]
        parts = [part for part in company_parts(plan) if part.vehicle == vehicle]
        assert [k for part in parts for k in range(part.first, part.last + 1)] == legs


def test_a_company_that_stops_and_goes_on_has_one_part():
    companies = [(0, 1), (0, 1), (1, 0), (0,), (1,)]
    plan = SimpleNamespace(
        ways=((0, 1, 2, 3), (0, 1, 2, 4)),
        stretches=[SimpleNamespace(vehicles=company) for company in companies],
    )
    parts = [(part.vehicle, part.first, part.last, part.position) for part in company_parts(plan)]
    assert parts == [(0, 0, 1, 1), (0, 2, 2, 2), (1, 0, 1, 2), (1, 2, 2, 1)]


def test_who_could_not_be_planned(day, tmp_path):
    plan, _ = day
    assert table(lambda path: write_unserved(plan, path), tmp_path) == [
        {"vehicle": "late", "reason": "late even alone by 5 min"}
    ]
    assert table(lambda path: write_unserved(replace(plan, fleet=None), path), tmp_path) == []


def test_the_folder(day, tmp_path):
    plan, net = day
    tables = {"assignment.csv", "platoons.csv", "vehicles.csv", "unserved.csv", "fleet.html"}
    po.write_fleet_folder(plan, net, tmp_path / "few")
    assert {path.name for path in (tmp_path / "few").iterdir()} == {*tables, "sheets"}
    assert len(list((tmp_path / "few" / "sheets").glob("*.html"))) == 3
    written = po.write_fleet_folder(plan, net, tmp_path / "none", sheets=False)
    assert {path.name for path in written} == tables
    (tmp_path / "broken" / "unserved.csv").mkdir(parents=True)
    with pytest.raises(PlatoonError, match="is a folder"):
        po.write_fleet_folder(plan, net, tmp_path / "broken", sheets=False)
    assert [path.name for path in (tmp_path / "broken").iterdir()] == ["unserved.csv"]
    with pytest.raises(PlatoonError, match="not one of a whole fleet"):
        po.write_fleet_folder(replace(plan, fleet=None), net, tmp_path / "none")


def test_what_a_fleet_comes_to(day):
    plan, _ = day
    said = fleet_lines(plan)
    driven = 3 * 40 + 3 * 40 + 40
    assert said[0] == (
        f"3 trips, 2 of them in 1 platoon of up to 2 for {80 / driven:.1%} of all {driven} km"
    )
    assert said[1] == "Saves 1.0 l of 9.0, 11.11%; no plan saves more than 1.0"
    assert said[2].startswith("Gap: 0.000% of the savings; ended after 0.1 s, for less than")
    assert said[3] == "Trips that could not be planned: 1, 1 of them as: late even alone by 5 min"
    assert plan.summary().startswith("\n".join(said))
    assert proof_sentence(plan) in plan.summary()
    assert "total" not in plan.summary()
