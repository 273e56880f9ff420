"""Joint route planning for truck platoons on OpenStreetMap motorway networks.

Names are loaded when first used, so that importing the package costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._version import __version__
from .offers import offer

if TYPE_CHECKING:
    from .chance.delays import Delays
    from .costs.break_even import BreakEven, break_even
    from .costs.fatigue import FatigueModel
    from .costs.fuel import FUEL_SAVINGS, FuelSaving
    from .costs.money.fuel_costs import FuelCosts
    from .costs.money.objective import MoneyCosts, money_costs
    from .costs.paper import PaperCosts, paper_weights
    from .costs.weights import EdgeWeights
    from .errors import (
        MapDataError,
        NetworkError,
        NoRouteError,
        PlatoonError,
        ScenarioError,
    )
    from .fleets.day.draw import draw_trips
    from .fleets.fleet import plan_fleet
    from .fleets.limits import Limits
    from .inspection.verdict import inspect_plan
    from .network.access import Access
    from .network.location import Location, Place
    from .network.road_network import RoadNetwork
    from .network.road_stop import RoadStop
    from .network.stops import stops_along
    from .planning.cases import plan_members
    from .planning.curves import delay_frontier, departure_curve
    from .planning.joint import plan_joint, solve
    from .planning.meeting_chances import DelaysSimulated, simulate_delays
    from .planning.place_table import place_table
    from .planning.problem import Problem
    from .planning.scenario.trip_tables import read_trips
    from .planning.share_gain import share_gain
    from .planning.what_if import what_if
    from .plans.curves import DelayFrontier, DepartureCurve
    from .plans.plan import JointPlan, Plan
    from .plans.trip import Trip
    from .plans.vehicles import VehiclePlan
    from .plans.what_if import WhatIf, WhatIfs
    from .report.charts.break_even_figure import write_break_even
    from .report.charts.curve_figures import write_curve
    from .report.charts.figures import write_figures
    from .report.exports.gis import to_geodataframe, write_geopackage
    from .report.exports.tracks import write_csv, write_gpx
    from .report.fleet_folder import write_fleet_folder
    from .report.pages.comparison import write_comparison
    from .report.pages.fleet import write_fleet_html
    from .report.pages.flows import write_flows
    from .report.pages.in_languages import write_pages
    from .report.pages.page import explore, write_html
    from .report.pages.what_if import write_what_if
    from .report.sheets.write import write_sheets
    from .search.engine import many_to_many
    from .sources.load import load_network
    from .study.monte_carlo import StudyResult, run_study
    from .study.random_network import RandomNetwork
    from .study.road_trips import RoadTrips
    from .study.settings import PAPER_STUDY, Study

_WHERE = {
    "BreakEven": "costs.break_even",
    "break_even": "costs.break_even",
    "FatigueModel": "costs.fatigue",
    "FUEL_SAVINGS": "costs.fuel",
    "FuelSaving": "costs.fuel",
    "EdgeWeights": "costs.weights",
    "FuelCosts": "costs.money.fuel_costs",
    "MoneyCosts": "costs.money.objective",
    "money_costs": "costs.money.objective",
    "PaperCosts": "costs.paper",
    "paper_weights": "costs.paper",
    "MapDataError": "errors",
    "NetworkError": "errors",
    "NoRouteError": "errors",
    "PlatoonError": "errors",
    "ScenarioError": "errors",
    "draw_trips": "fleets.day.draw",
    "inspect_plan": "inspection.verdict",
    "Access": "network.access",
    "Location": "network.location",
    "Place": "network.location",
    "RoadNetwork": "network.road_network",
    "RoadStop": "network.road_stop",
    "stops_along": "network.stops",
    "many_to_many": "search.engine",
    "place_table": "planning.place_table",
    "plan_members": "planning.cases",
    "departure_curve": "planning.curves",
    "delay_frontier": "planning.curves",
    "Delays": "chance.delays",
    "DelaysSimulated": "planning.meeting_chances",
    "simulate_delays": "planning.meeting_chances",
    "DelayFrontier": "plans.curves",
    "DepartureCurve": "plans.curves",
    "plan_joint": "planning.joint",
    "solve": "planning.joint",
    "share_gain": "planning.share_gain",
    "what_if": "planning.what_if",
    "WhatIf": "plans.what_if",
    "WhatIfs": "plans.what_if",
    "JointPlan": "plans.plan",
    "Plan": "plans.plan",
    "Limits": "fleets.limits",
    "Problem": "planning.problem",
    "plan_fleet": "fleets.fleet",
    "read_trips": "planning.scenario.trip_tables",
    "Proof": "plans.proof",
    "Searches": "search.searches",
    "VehiclePlan": "plans.vehicles",
    "Trip": "plans.trip",
    "to_geodataframe": "report.exports.gis",
    "write_geopackage": "report.exports.gis",
    "write_html": "report.pages.page",
    "write_pages": "report.pages.in_languages",
    "write_what_if": "report.pages.what_if",
    "write_sheets": "report.sheets.write",
    "explore": "report.pages.page",
    "write_comparison": "report.pages.comparison",
    "write_break_even": "report.charts.break_even_figure",
    "write_curve": "report.charts.curve_figures",
    "write_csv": "report.exports.tracks",
    "write_figures": "report.charts.figures",
    "write_fleet_folder": "report.fleet_folder",
    "write_fleet_html": "report.pages.fleet",
    "write_flows": "report.pages.flows",
    "write_gpx": "report.exports.tracks",
    "load_network": "sources.load",
    "RandomNetwork": "study.random_network",
    "RoadTrips": "study.road_trips",
    "PAPER_STUDY": "study.settings",
    "Study": "study.settings",
    "StudyResult": "study.monte_carlo",
    "run_study": "study.monte_carlo",
}

__all__ = [
    "FUEL_SAVINGS",
    "PAPER_STUDY",
    "Access",
    "BreakEven",
    "DelayFrontier",
    "Delays",
    "DelaysSimulated",
    "DepartureCurve",
    "EdgeWeights",
    "FatigueModel",
    "FuelCosts",
    "FuelSaving",
    "JointPlan",
    "Limits",
    "Location",
    "MapDataError",
    "MoneyCosts",
    "NetworkError",
    "NoRouteError",
    "PaperCosts",
    "Place",
    "Plan",
    "PlatoonError",
    "Problem",
    "Proof",
    "RandomNetwork",
    "RoadNetwork",
    "RoadStop",
    "RoadTrips",
    "ScenarioError",
    "Searches",
    "Study",
    "StudyResult",
    "Trip",
    "VehiclePlan",
    "WhatIf",
    "WhatIfs",
    "__version__",
    "break_even",
    "delay_frontier",
    "departure_curve",
    "draw_trips",
    "explore",
    "inspect_plan",
    "load_network",
    "many_to_many",
    "money_costs",
    "paper_weights",
    "place_table",
    "plan_fleet",
    "plan_joint",
    "plan_members",
    "read_trips",
    "run_study",
    "share_gain",
    "simulate_delays",
    "solve",
    "stops_along",
    "to_geodataframe",
    "what_if",
    "write_break_even",
    "write_comparison",
    "write_csv",
    "write_curve",
    "write_figures",
    "write_fleet_folder",
    "write_fleet_html",
    "write_flows",
    "write_geopackage",
    "write_gpx",
    "write_html",
    "write_pages",
    "write_sheets",
    "write_what_if",
]


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_WHERE[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__


# What lower rooms let people call of upper ones; nothing is loaded before someone does.
for _name, _where in {
    "locate": "network.locate",
    "place_name": "network.naming",
    "road_stops": "network.stops",
    "save_network": "network.saved.store",
    "to_networkx": "sources.graphs.exchange",
    "from_networkx": "sources.graphs.exchange",
    "to_geodataframes": "sources.graphs.geodataframes",
    "summary": "plans.summary",
    "explore": "report.pages.page",
    "plan_table": "report.pages.notebook",
    "network_table": "report.pages.notebook",
    "to_frame": "plans.frames",
    "to_geodataframe": "report.exports.gis",
}.items():
    offer(_name, f"{__name__}.{_where}")
