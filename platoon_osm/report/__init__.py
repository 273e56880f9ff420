"""What people look at: the HTML page of a plan and its GIS files."""

from .document import DOCUMENT_VERSION, report_document
from .gis import to_geodataframe, write_geopackage
from .page import plan_map, write_html

__all__ = [
    "DOCUMENT_VERSION",
    "plan_map",
    "report_document",
    "to_geodataframe",
    "write_geopackage",
    "write_html",
]
