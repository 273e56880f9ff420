"""What people look at: the HTML pages of plans, figures, and files for other programs.

Names are loaded when first used, so that the list of exporters can be read at no cost.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .charts.figures import write_figures
    from .document.document import DOCUMENT_VERSION, report_document
    from .document.flows import flow_document
    from .document.side_by_side import comparison_document
    from .exporters import EXPORTERS, Exporter
    from .exports.bill import write_bill
    from .exports.gis import to_geodataframe, write_geopackage
    from .exports.tracks import write_csv, write_gpx
    from .pages.comparison import write_comparison
    from .pages.fleet import write_fleet_html
    from .pages.flows import write_flows
    from .pages.in_languages import write_pages
    from .pages.page import explore, plan_map, write_html
    from .sheets.write import write_sheets

_WHERE = {
    "write_figures": "charts.figures",
    "DOCUMENT_VERSION": "document.document",
    "report_document": "document.document",
    "EXPORTERS": "exporters",
    "Exporter": "exporters",
    "to_geodataframe": "exports.gis",
    "write_geopackage": "exports.gis",
    "write_bill": "exports.bill",
    "write_csv": "exports.tracks",
    "write_gpx": "exports.tracks",
    "comparison_document": "document.side_by_side",
    "write_comparison": "pages.comparison",
    "flow_document": "document.flows",
    "write_fleet_html": "pages.fleet",
    "write_flows": "pages.flows",
    "explore": "pages.page",
    "plan_map": "pages.page",
    "write_html": "pages.page",
    "write_pages": "pages.in_languages",
    "write_sheets": "sheets.write",
}

__all__ = [
    "DOCUMENT_VERSION",
    "EXPORTERS",
    "Exporter",
    "comparison_document",
    "explore",
    "flow_document",
    "plan_map",
    "report_document",
    "to_geodataframe",
    "write_bill",
    "write_comparison",
    "write_csv",
    "write_figures",
    "write_fleet_html",
    "write_flows",
    "write_geopackage",
    "write_gpx",
    "write_html",
    "write_pages",
    "write_sheets",
]


def __getattr__(name: str) -> Any:
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_WHERE[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
