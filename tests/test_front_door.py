"""Whatever a user gives by mistake, every public call refuses in one line, or does its work."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import fields
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import platoon_osm as po
from platoon_osm.driving.rules import NO_RULES

LONGEST = 400
"""Characters that a refusal may have; what was given is shown in brief."""

DAY = datetime(2026, 3, 2, 6)

Call = tuple[Callable[..., Any], dict[str, Any]]


@pytest.fixture(scope="module")
def given(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Return a network, weights, trips and a plan, and a folder to write into."""
    net = po.load_network("italy-motorways")
    weights = po.paper_weights(net)
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    plan = po.plan_joint(net, weights, trips, "C")
    hours = [po.Trip(one.vehicle, one.origin, one.destination, DAY) for one in trips]
    timed = po.Problem(net, tuple(hours), weights, case="C")
    return {
        "net": net, "weights": weights, "trips": trips, "plan": plan,
        "timed": timed, "curve": po.departure_curve(timed),
        "folder": tmp_path_factory.mktemp("front_door"),
        "other": po.RoadNetwork.from_edges([0], [1], lon=[9, 9.1], lat=[45, 45]),
    }  # fmt: skip


@pytest.fixture
def nonsense(given: dict[str, Any]) -> list[Any]:
    """Return values that users give by mistake, among them good ones in the wrong place."""
    return [
        None, 3, -1, 1.5, float("nan"), float("inf"), 10**30, True, "x", "", "a\nb" * 30, b"x",
        [], {}, {"a": 1}, (1, 2), [[1]], ["x"], [float("nan")], {1}, np.array([1, 2]),
        np.array([[1.0]]), pd.NaT, object(), po.Trip, lambda: 0, given["net"], given["other"],
        given["weights"], given["trips"][0], given["trips"], given["plan"],
    ]  # fmt: skip


def _calls(given: dict[str, Any]) -> dict[str, Call]:
    net, weights, trips, plan = (given[name] for name in ("net", "weights", "trips", "plan"))
    folder, route = given["folder"], list(plan.vehicles[0].edges)
    shown = {"plan": plan, "net": net}
    return {
        "Trip": (po.Trip, {
            "vehicle": "A", "origin": "Torino", "destination": "Trieste",
            "earliest_departure": None, "latest_departure": None, "latest_arrival": None,
            "flexibility_min": None, "driver": {"driven_today_h": 2},
        }),
        "Access": (po.Access, _defaults(po.Access())),
        "Place": (po.Place, {"at": "Torino", "osmid": None, "label": "home"}),
        "Problem": (po.Problem, {
            "net": net, "trips": trips, "objective": weights, "rules": NO_RULES, "case": "C",
            "master": "A", "method": "dijkstra", "optimum": "member", "engine": "auto",
            "access": po.Access(), "task_relief": 1,
        }),
        "solve": (po.solve, {"problem": po.Problem(net, tuple(trips), weights)}),
        "plan_joint": (po.plan_joint, {
            "net": net, "weights": weights, "trips": trips, "case": "C", "master": "A",
            "method": "dijkstra", "objective": "member", "engine": "auto",
            "access": po.Access(), "rules": "none", "task_relief": 0.5,
        }),
        "plan_members": (po.plan_members, {
            "net": net, "weights": weights, "route": route, "origins": [int(net.tail[route[0]])],
            "destinations": [int(net.head[route[-1]])], "case": "C",
        }),
        "many_to_many": (po.many_to_many, {
            "net": net, "weight": weights.solo, "sources": [0], "targets": [1], "engine": "auto",
        }),
        "inspect_plan": (po.inspect_plan, {"plan": plan, "rules": "eu561", "article_12": False}),
        "departure_curve": (po.departure_curve, {
            "problem": given["timed"], "master": "A", "rules": "none",
        }),
        "delay_frontier": (po.delay_frontier, {
            "problem": given["timed"], "delays_min": [0.0, 60.0], "rules": "none",
        }),
        "write_curve": (po.write_curve, {"curve": given["curve"]}),
        "break_even": (po.break_even, {
            "costs": po.PaperCosts(), "vehicle": "eu-40t", "size": 2, "speed_kmh": 80.0,
            "optimum": "member",
        }),
        "write_break_even": (po.write_break_even, {"found": po.break_even(po.PaperCosts())}),
        "what_if": (po.what_if, {
            "problem": po.Problem(given["other"], (po.Trip("A", 0, 1),), po.money_costs()),
            "figure": "fuel_per_l", "values": [1.0, 2.0], "tolerance": 1.0,
            "plan": None,
        }),
        "place_table": (po.place_table, {
            "net": net, "origins": ["Torino"], "destinations": ["Trieste"], "measure": "km",
        }),
        "plan.to_frame": (plan.to_frame, {"what": "stretches"}),
        "plan.to_geodataframe": (plan.to_geodataframe, {"net": net}),
        "load_network": (po.load_network, {
            "source": "italy-motorways", "classes": ("motorway",), "country": None,
            "limiter_kmh": 90.0, "infer_links": False,
        }),
        "net.locate": (net.locate, {
            "place": "Torino", "role": "origin", "osmid": None, "label": None,
            "access": po.Access(),
        }),
        "net.locate(osmid)": (net.locate, {
            "place": None, "role": "any", "osmid": int(net.node_id[0]), "label": "x",
        }),
        "net.take": (net.take, {"edges": [0, 1]}),
        "paper_weights": (po.paper_weights, {"net": net, "costs": None}),
        "PaperCosts": (po.PaperCosts, _defaults(po.PaperCosts())),
        "FuelCosts": (po.FuelCosts, _defaults(po.FuelCosts())),
        "MoneyCosts": (po.MoneyCosts, _defaults(po.MoneyCosts())),
        "money_costs": (po.money_costs, {"preset": "us", "fuel_per_l": 1.0, "drag": 0.6}),
        "FuelSaving": (po.FuelSaving, {"name": "x", "leader": 0.1, "middle": 0.1, "last": 0.1}),
        "FatigueModel": (po.FatigueModel, {"form": "monotone", "task_relief": 1.0}),
        "FatigueModel.along": (
            po.FatigueModel("by_period").along, {"clock_s": [0.0], "hour_of_day": [9.0]},
        ),
        "EdgeWeights": (po.EdgeWeights, {
            "solo": weights.solo, "platoon": weights.platoon, "master": weights.master,
            "unit": "m", "params": {},
        }),
        "RandomNetwork": (po.RandomNetwork, _defaults(po.RandomNetwork())),
        "RoadTrips": (po.RoadTrips, {
            "net": net, "vehicles": 3, "spawn_diameter_m": 1e5, "min_route_m": 1e5, "flows": None,
            "max_redraws": 10,
        }),
        "Study": (po.Study, _defaults(po.Study(runs=1))),
        "run_study": (po.run_study, {"study": po.Study(runs=1), "seed": 0}),
        "read_trips": (po.read_trips, {"path": folder / "trips.csv", "sheet": None}),
        "Plan.from_dict": (po.Plan.from_dict, {"data": plan.to_dict()}),
        "Plan.read_json": (po.Plan.read_json, {"path": folder / "none.json"}),
        "explore": (po.explore, {**shown, "height": 640}),
        "to_geodataframe": (po.to_geodataframe, shown),
        "write_html": (po.write_html, {**shown}),
        "write_flows": (po.write_flows, {**shown}),
        "write_comparison": (po.write_comparison, {"plans": [plan, plan], "net": net}),
        "write_csv": (po.write_csv, {**shown}),
        "write_gpx": (po.write_gpx, {**shown}),
        "write_geopackage": (po.write_geopackage, {**shown}),
        "write_sheets": (po.write_sheets, {**shown}),
        "write_pages": (po.write_pages, {**shown}),
    }  # fmt: skip


def _places(name: str) -> list[str]:
    """Return where a call writes: GPX tracks into a folder that exists, all others to a file."""
    if not name.startswith("write_"):
        return []
    kind = ".svg" if name in ("write_curve", "write_break_even") else ""
    return ["." if name == "write_gpx" else f"out-{name}{kind}"]


def _defaults(made: Any) -> dict[str, Any]:
    return {item.name: getattr(made, item.name) for item in fields(made)}


NAMES = (
    "Trip", "Problem", "solve", "plan_joint", "plan_members", "many_to_many", "place_table",
    "inspect_plan", "plan.to_frame", "plan.to_geodataframe", "load_network",
    "Access", "Place", "net.locate", "net.locate(osmid)", "net.take", "paper_weights",
    "PaperCosts", "FuelCosts", "MoneyCosts", "money_costs",
    "FuelSaving", "FatigueModel",
    "FatigueModel.along", "EdgeWeights", "RandomNetwork", "RoadTrips", "Study", "run_study",
    "read_trips", "Plan.from_dict", "Plan.read_json", "explore", "to_geodataframe", "write_html",
    "write_flows", "write_comparison", "write_csv", "write_gpx", "write_geopackage", "write_sheets",
    "write_pages", "departure_curve", "delay_frontier", "write_curve", "break_even",
    "write_break_even", "what_if",
)  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_nonsense_is_refused_in_one_line(
    name: str,
    given: dict[str, Any],
    nonsense: list[Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    call, right = _calls(given)[name]
    places = _places(name)
    for argument in right:
        for wrong in nonsense:
            if (name, argument, wrong is None) == ("run_study", "study", True):
                continue  # a good value: the paper's study, of 100 runs
            asked = {**right, argument: wrong}
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                try:
                    call(*asked.values(), *places) if places else call(**asked)
                except po.PlatoonError as refusal:
                    text = str(refusal)
                    assert text, (argument, wrong)
                    assert "\n" not in text, (argument, wrong)
                    assert len(text) <= LONGEST, (argument, text)
                except Exception as error:
                    shown = f"{type(error).__name__}: {error}"
                    pytest.fail(f"{name}, {argument} = {wrong!r:.60}: {shown:.200}")


def test_every_call_works_as_it_should_be_given(
    given: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Else a call that always fails would look like one that always refuses.
    monkeypatch.chdir(tmp_path)
    calls = _calls(given)
    assert set(calls) == set(NAMES)
    given["plan"].write_json(given["folder"] / "none.json")
    (given["folder"] / "trips.csv").write_text("vehicle,origin,destination\nA,Torino,Monza\n")
    for name, (call, right) in calls.items():
        places = _places(name)
        call(*right.values(), *places) if places else call(**right)


@pytest.mark.parametrize("wrong", [None, 3, "", f"{__file__}/plan.json", "."])
def test_a_plan_is_written_to_a_file_or_not_at_all(given: dict[str, Any], wrong: Any) -> None:
    with pytest.raises(po.ScenarioError):
        given["plan"].write_json(wrong)
