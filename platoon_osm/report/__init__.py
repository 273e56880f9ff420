"""What people look at: the HTML pages of plans, figures, and files for other programs."""

from .charts.figures import write_figures
from .document.document import DOCUMENT_VERSION, report_document
from .exports.gis import to_geodataframe, write_geopackage
from .exports.tracks import write_csv, write_gpx
from .pages.comparison import comparison_document, write_comparison
from .pages.flows import flow_document, write_flows
from .pages.page import explore, plan_map, write_html

__all__ = [
    "DOCUMENT_VERSION",
    "comparison_document",
    "explore",
    "flow_document",
    "plan_map",
    "report_document",
    "to_geodataframe",
    "write_comparison",
    "write_csv",
    "write_figures",
    "write_flows",
    "write_geopackage",
    "write_gpx",
    "write_html",
]
