"""What people look at: the HTML pages of plans, figures, and files for other programs."""

from .comparison import comparison_document, write_comparison
from .document import DOCUMENT_VERSION, report_document
from .figures import write_figures
from .flows import flow_document, write_flows
from .gis import to_geodataframe, write_geopackage
from .page import explore, plan_map, write_html
from .tracks import write_csv, write_gpx

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
