"""Joint route planning for truck platoons on OpenStreetMap motorway networks.

Names are loaded when first used, so that importing the package costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._version import __version__
from .display import offer

if TYPE_CHECKING:
    from .costs.fatigue import FatigueModel
    from .costs.fuel import FUEL_SAVINGS, FuelSaving
    from .costs.weights import EdgeWeights, PaperCosts, paper_weights
    from .errors import (
        MapDataError,
        NetworkError,
        NoRouteError,
        PlatoonError,
        ScenarioError,
    )
    from .network.engines import many_to_many
    from .network.locate import Location
    from .network.road_network import RoadNetwork
    from .planning.cases import plan_members
    from .planning.joint import plan_joint
    from .planning.plans import JointPlan, VehiclePlan
    from .planning.trips import Trip
    from .report.comparison import write_comparison
    from .report.figures import write_figures
    from .report.flows import write_flows
    from .report.gis import to_geodataframe, write_geopackage
    from .report.page import explore, write_html
    from .report.tracks import write_csv, write_gpx
    from .sources.load import load_network
    from .sources.synthetic import RandomNetwork
    from .study.monte_carlo import StudyResult, run_study
    from .study.road_trips import RoadTrips
    from .study.settings import PAPER_STUDY, Study

_WHERE = {
    "FatigueModel": "costs.fatigue",
    "FUEL_SAVINGS": "costs.fuel",
    "FuelSaving": "costs.fuel",
    "EdgeWeights": "costs.weights",
    "PaperCosts": "costs.weights",
    "paper_weights": "costs.weights",
    "MapDataError": "errors",
    "NetworkError": "errors",
    "NoRouteError": "errors",
    "PlatoonError": "errors",
    "ScenarioError": "errors",
    "Location": "network.locate",
    "RoadNetwork": "network.road_network",
    "many_to_many": "network.engines",
    "plan_members": "planning.cases",
    "plan_joint": "planning.joint",
    "JointPlan": "planning.plans",
    "VehiclePlan": "planning.plans",
    "Trip": "planning.trips",
    "to_geodataframe": "report.gis",
    "write_geopackage": "report.gis",
    "write_html": "report.page",
    "explore": "report.page",
    "write_comparison": "report.comparison",
    "write_csv": "report.tracks",
    "write_figures": "report.figures",
    "write_flows": "report.flows",
    "write_gpx": "report.tracks",
    "load_network": "sources.load",
    "RandomNetwork": "sources.synthetic",
    "RoadTrips": "study.road_trips",
    "PAPER_STUDY": "study.settings",
    "Study": "study.settings",
    "StudyResult": "study.monte_carlo",
    "run_study": "study.monte_carlo",
}

__all__ = [
    "FUEL_SAVINGS",
    "PAPER_STUDY",
    "EdgeWeights",
    "FatigueModel",
    "FuelSaving",
    "JointPlan",
    "Location",
    "MapDataError",
    "NetworkError",
    "NoRouteError",
    "PaperCosts",
    "PlatoonError",
    "RandomNetwork",
    "RoadNetwork",
    "RoadTrips",
    "ScenarioError",
    "Study",
    "StudyResult",
    "Trip",
    "VehiclePlan",
    "__version__",
    "explore",
    "load_network",
    "many_to_many",
    "paper_weights",
    "plan_joint",
    "plan_members",
    "run_study",
    "to_geodataframe",
    "write_comparison",
    "write_csv",
    "write_figures",
    "write_flows",
    "write_geopackage",
    "write_gpx",
    "write_html",
]


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_WHERE[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__


# Plans show themselves through these; nothing is loaded before one does.
offer("explore", lambda: __getattr__("explore"))
offer("table", lambda: import_module(".report.notebook", __name__).plan_table)
