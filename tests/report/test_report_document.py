"""The document of a plan: its figures, sections, events and checks."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from plans_by_legs import silent_about_alone, with_vehicles
from po_valley import JUNCTIONS, THREE, make_plan, po_valley

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.towns.surroundings import GEONAMES_CREDIT
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report.document.document import DOCUMENT_VERSION, report_document
from platoon_osm.report.document.wording import joined
from platoon_osm.report.drawing.basemap import ROUTE_STEPS
from platoon_osm.report.drawing.polyline import decode_polyline
from platoon_osm.report.drawing.vehicle_styles import vehicle_styles
from platoon_osm.report.markup.quantities import cost_unit, signed


def test_document_is_plain_json(plan: JointPlan, net: RoadNetwork) -> None:
    document = report_document(plan, net)
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["version"] == DOCUMENT_VERSION


def test_document_of_a_plan_read_back_is_the_same(plan: JointPlan, net: RoadNetwork) -> None:
    again = JointPlan.from_dict(json.loads(json.dumps(plan.to_dict())))
    assert report_document(again, net) == report_document(plan, net)


def test_sections_change_where_company_does(plan: JointPlan, net: RoadNetwork) -> None:
    sections = report_document(plan, net)["platoons"]
    assert [section["vehicles"] for section in sections] == [[0, 2], [0, 1, 2], [0, 1]]


def test_road_in_platoon_counts_once(plan: JointPlan, net: RoadNetwork) -> None:
    totals = report_document(plan, net)["totals"]
    master = plan.vehicles[0]
    assert totals["platoon_road_m"] == pytest.approx(master.platoon_m)
    assert totals["platoon_m"] == pytest.approx(plan.platoon_m)


def test_saving_is_gain_less_detour(plan: JointPlan, net: RoadNetwork) -> None:
    for vehicle in report_document(plan, net)["vehicles"]:
        assert vehicle["platoon_gain"] - vehicle["detour"] == pytest.approx(vehicle["saved"])
        assert vehicle["detour"] >= 0


def test_section_costs_add_up_to_the_joint_cost(plan: JointPlan, net: RoadNetwork) -> None:
    document = report_document(plan, net)
    for index, vehicle in enumerate(plan.vehicles):
        together = sum(
            share["cost_platoon"]
            for section in document["platoons"]
            for share in section["costs"]
            if share["vehicle"] == index
        )
        apart = sum(solo["cost"] for solo in document["solos"] if solo["vehicle"] == index)
        assert together + apart == pytest.approx(vehicle.joint_cost)


def test_events_come_in_driving_order(plan: JointPlan, net: RoadNetwork) -> None:
    events = report_document(plan, net)["events"]
    assert [(event["name"], event["text"]) for event in events] == [
        ("Rho-Pero", "C joins A"),
        ("Brescia Centro", "B joins A and C"),
        ("Verona Nord", "C leaves"),
        ("Mestre", "B leaves"),
    ]
    assert events[2]["detail"].endswith("in platoon, towards Brennero")


def test_two_who_come_and_leave_at_one_point_are_one_event(net: RoadNetwork) -> None:
    plan = make_plan(
        net,
        [
            ("A", "Torino", "Trieste", None, None),
            ("B", "Genova Ovest", "Belluno", "Brescia Centro", "Mestre"),
            ("C", "Parma", "Belluno", "Brescia Centro", "Mestre"),
        ],
    )
    events = report_document(plan, net)["events"]
    assert [event["text"] for event in events] == ["B and C join A", "B and C leave"]


def test_a_pair_without_master_meets_and_parts(plan: JointPlan, net: RoadNetwork) -> None:
    """Case D: both are members, and both have the same two points."""
    pair = make_plan(net, THREE[:2])
    master, member = pair.vehicles
    other = replace(master, role="member", merge=member.merge, separation=member.separation)
    both = with_vehicles(pair, (other, member))
    events = report_document(both, net)["events"]
    assert [event["text"] for event in events] == ["A and B meet", "A and B part"]


def test_nobody_in_platoon(net: RoadNetwork) -> None:
    plan = make_plan(
        net, [("A", "Torino", "Trieste", None, None), ("B", "Parma", "La Spezia", None, None)]
    )
    document = report_document(plan, net)
    assert document["subtitle"] == "2 vehicles"
    assert [one["text"] for one in document["status"]] == ["No platoon: all vehicles drive alone"]
    assert document["platoons"] == []
    assert document["events"] == []


def test_routes_end_where_the_vehicle_does(plan: JointPlan, net: RoadNetwork) -> None:
    solo = report_document(plan, net)["solos"][0]
    lon, lat = decode_polyline(solo["parts"][0]["line"], ROUTE_STEPS)[0]
    assert (lon, lat) == pytest.approx(JUNCTIONS["Torino"], abs=1e-4)


def test_inferred_road_is_told(plan: JointPlan, net: RoadNetwork) -> None:
    document = report_document(plan, net)
    assert document["vehicles"][1]["inferred_m"] > 0
    assert len(document["inferred_routes"]) == 1
    assert document["basemap"]["inferred"]


def test_other_costs_leave_out_what_is_not_known(plan: JointPlan, net: RoadNetwork) -> None:
    euro = replace(silent_about_alone(plan), unit="EUR", params={"preset": "money"})
    document = report_document(euro, net)
    assert document["vehicles"][0]["detour"] is None
    assert document["platoons"][0]["costs"][0]["cost_alone"] is None
    assert document["cost_unit"]["label"] == "\u20ac"


def test_other_costs_are_told_where_the_plan_holds_them(plan: JointPlan, net: RoadNetwork) -> None:
    euro = replace(plan, unit="EUR", params={"preset": "money"})
    document, before = report_document(euro, net), report_document(plan, net)
    for own, was in zip(document["vehicles"], before["vehicles"], strict=True):
        assert (own["detour"], own["platoon_gain"]) == (was["detour"], was["platoon_gain"])


def test_weights_are_believed_only_if_they_fit(plan: JointPlan, net: RoadNetwork) -> None:
    right = paper_weights(net, tau=1.0, xi=0.18, speed_kmh=80.0)
    silent = replace(silent_about_alone(plan), params={})
    told = report_document(silent, net, weights=right)
    for own, was in zip(told["vehicles"], report_document(plan, net)["vehicles"], strict=True):
        assert own["detour"] == pytest.approx(was["detour"])
        assert own["platoon_gain"] == pytest.approx(was["platoon_gain"])
    assert report_document(silent, net)["vehicles"][0]["detour"] is None
    with pytest.raises(ScenarioError, match="do not give the costs"):
        report_document(plan, net, weights=paper_weights(net, rest_s=0.0))


def test_another_network_is_refused(plan: JointPlan) -> None:
    other = po_valley()
    shorter = RoadNetwork.from_edges([0], [1], lon=[9.0, 9.1], lat=[45.0, 45.0])
    assert report_document(plan, other)
    with pytest.raises(ScenarioError, match="load the network it was made on"):
        report_document(plan, shorter)


def test_two_of_one_name_are_refused(plan: JointPlan, net: RoadNetwork) -> None:
    lonely = replace(plan.vehicles[0], legs=(plan.vehicles[0].alone,))
    with pytest.raises(ScenarioError, match="two vehicles are named 'A'"):
        report_document(with_vehicles(plan, (lonely, lonely)), net)
    with pytest.raises(ScenarioError, match="no vehicles"):
        report_document(with_vehicles(plan, ()), net)


def test_edges_outside_the_network_are_refused(plan: JointPlan, net: RoadNetwork) -> None:
    first = plan.vehicles[0]
    stray = replace(first, legs=(first.alone,), alone=replace(first.alone, edges=(net.m,)))
    with pytest.raises(ScenarioError, match=f"edge {net.m}"):
        report_document(with_vehicles(plan, (stray,)), net)


@pytest.mark.parametrize(
    ("source", "credits"),
    [
        (Source(), ["map: its source was not told"]),
        (
            Source(attribution="Made by hand", licence="CC0"),
            ["Made by hand, CC0"],
        ),
        (
            Source(attribution="\u00a9 OpenStreetMap contributors", licence="ODbL 1.0"),
            ["\u00a9 OpenStreetMap contributors, ODbL 1.0"],
        ),
    ],
)
def test_credits(source: Source, credits: list[str]) -> None:
    net = po_valley(source=source)
    document = report_document(make_plan(net, THREE), net)
    # The towns around are from GeoNames, whatever the map is from.
    assert document["provenance"]["credits"] == [*credits, GEONAMES_CREDIT]


@pytest.mark.parametrize(
    ("proof", "text"),
    [
        ({"kind": "exact", "conditions": ["a", "b"]}, "Proved optimal for: a; b."),
        ({"kind": "exact"}, "Proved optimal for these trips."),
        (
            {"kind": "bound", "bound": 2000.0, "gap": 0.0125},
            "Bound: at most 1.2\u202f% above the optimum; "
            "no plan can cost less than 2.0\u00a0km\u00a0eq..",
        ),
        (
            {"kind": "heuristic", "excess": 0.02, "optimum": 1000.0},
            "Heuristic: found by the paper's A*, 2.0\u202f% above the optimum; "
            "the optimum costs 1.0\u00a0km\u00a0eq..",
        ),
        (
            {"kind": "heuristic", "excess": -0.015, "solo_excess": 0.25},
            "Heuristic: found by the paper's A*, 1.5\u202f% below the optimum; "
            "its routes alone cost 25.0\u202f% above the least.",
        ),
        ({}, ""),
    ],
)
def test_proof(plan: JointPlan, net: RoadNetwork, proof: dict[str, object], text: str) -> None:
    found = report_document(replace(plan, proof=proof), net)["provenance"]["proof"]
    assert found == text.replace("eq..", "eq.")


def test_fifty_vehicles_differ_in_letter_and_in_look() -> None:
    styles = vehicle_styles([f"Truck {i}" for i in range(50)])
    assert len({style.letter for style in styles}) == 50
    assert len({(style.colour, style.dash) for style in styles}) == 50
    assert [styles[i].letter for i in (0, 25, 26, 49)] == ["A", "Z", "AA", "AX"]


def test_colours_keep_their_contrast_with_white() -> None:
    for style in vehicle_styles(["name"] * 8):
        channels = [int(style.colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
        luminance = sum(k * c for k, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))
        assert 1.05 / (luminance + 0.05) >= 4.5, style.colour


def test_short_names_are_letters_themselves() -> None:
    def letters(*names: str) -> list[str]:
        return [style.letter for style in vehicle_styles(names)]

    assert letters("X1", "Q", "T12") == ["X1", "Q", "T12"]
    # Who has no short name gets a letter that is nobody's name.
    assert letters("Truck 1", "B", "Truck 3", "a", "Truck 5") == ["C", "B", "D", "a", "E"]
    assert letters("X1", "X 1", "\u0414\u0410", "WWWW") == ["X1", "A", "B", "C"]
    many = letters(*(f"Truck {k}" for k in range(1000)), "ZZ")
    assert len(set(many)) == 1001
    assert many.count("ZZ") == 1


def test_figures() -> None:
    assert signed("-0.04") == "\u22120.04"
    assert signed("-0.0") == "0.0"
    assert signed("3.1") == "+3.1"
    assert cost_unit("EUR").full(-1234.5) == "\u2212\u20ac1,234.50"
    assert cost_unit("m").full(12_345) == "12.3\u00a0km\u00a0eq."
    assert joined(list("ABCDEFGH")) == "A, B, C, D and 4 more"
    assert joined([]) == ""
