"""The kinds of output of a plan, each found by its name; a user adds one without touching this.

What is registered here is an option of `platoon-osm plan`:

    from platoon_osm.report.exporters import EXPORTERS, Exporter
    EXPORTERS.add(Exporter("kml", "places for a globe to write", ".kml", write_kml))

Functions are imported when they are called, so that reading this list costs nothing.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from ..registry import Registry

if TYPE_CHECKING:
    from ..network.road_network import RoadNetwork
    from ..plans.curves import DelayFrontier, DepartureCurve
    from ..plans.plan import Plan

__all__ = ["EXPORTERS", "Exporter", "Writes"]

AnyPath = str | os.PathLike[str]

HTM = (".htm",)
FIGURES = ("corridor.*", "costs.*", "bill.*", "way.*", "schedule.*")
"""What `write_figures` writes."""


class Writes(Protocol):
    """A function that writes a plan somewhere."""

    def __call__(
        self, plan: Plan, net: RoadNetwork, path: AnyPath, /, *, title: str | None = None
    ) -> object:
        """Write a plan; what it returns is not looked at.

        Parameters
        ----------
        plan : Plan
            What is written.
        net : RoadNetwork
            The network it was made on.
        path : path-like
            A file to write; or a folder that exists. The command moves what is written to the
            place that was asked for once all is written.
        title : str or None
            Heads it, where it has a heading.

        Returns
        -------
        object
            Anything.
        """
        ...


@dataclass(frozen=True, slots=True)
class Exporter:
    """One kind of output of a plan.

    Attributes
    ----------
    name : str
        What it is called in options and messages.
    about : str
        What it is, in a few words, as the help of the command says it.
    suffix : str
        Of the file, with its dot; empty for a folder.
    write : Writes
        Writes a plan; called with plan, network, path and `title`.
    is_folder : bool
        Whether it is several files in a folder of their own, which exists when `write` is called.
    also : tuple of str
        Other suffixes that such files have.
    is_text : bool
        Whether it may be written to standard output.
    holds : tuple of str
        Patterns of the names of files in the folder; by default any.
    takes : tuple of str
        What `write` is told beside a title where it is known: "curve", "frontier".
    """

    name: str
    about: str
    suffix: str
    write: Writes
    is_folder: bool = False
    also: tuple[str, ...] = ()
    is_text: bool = False
    holds: tuple[str, ...] = ("*",)
    takes: tuple[str, ...] = ()


def _html(
    plan: Plan,
    net: RoadNetwork,
    path: AnyPath,
    *,
    title: str | None = None,
    curve: DepartureCurve | None = None,
    frontier: DelayFrontier | None = None,
) -> None:
    from .pages.page import write_html

    write_html(plan, net, path, title=title, curve=curve, frontier=frontier)


def _pages(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .pages.in_languages import write_pages

    write_pages(plan, net, path, title=title)


def _gpkg(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .exports.gis import write_geopackage

    del title  # it has no heading
    write_geopackage(plan, net, path)


def _json(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .document.checks import check_is_plan, check_path

    del net, title  # a plan names its network itself
    check_is_plan(plan)
    plan.write_json(check_path(path))


def _csv(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .exports.tracks import write_csv

    del title
    write_csv(plan, net, path)


def _pauses(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .exports.tracks import write_csv

    del title
    write_csv(plan, net, path, "pauses")


def _bill(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .exports.bill import write_bill

    del net, title
    write_bill(plan, path)


def _flows(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .pages.flows import write_flows

    write_flows(plan, net, path, title=title)


def _gpx(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .exports.tracks import write_gpx

    del title
    write_gpx(plan, net, path)


def _sheets(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .sheets.write import write_sheets

    write_sheets(plan, net, path, title=title)


def _figures(plan: Plan, net: RoadNetwork, path: AnyPath, *, title: str | None = None) -> None:
    from .charts.figures import write_figures

    del title
    write_figures(plan, net, path)


EXPORTERS: Registry[Exporter] = Registry(
    "exporter",
    [
        Exporter(
            "html",
            "self-contained map to write",
            ".html",
            _html,
            also=HTM,
            is_text=True,
            takes=("curve", "frontier"),
        ),
        Exporter(
            "pages",
            "folder for the map in each language",
            "",
            _pages,
            is_folder=True,
            holds=("plan.*.html",),
        ),
        Exporter("gpkg", "GeoPackage to write", ".gpkg", _gpkg),
        Exporter("json", "plan as JSON to write", ".json", _json, is_text=True),
        Exporter("csv", "legs as CSV to write", ".csv", _csv, is_text=True),
        Exporter("pauses", "breaks and waits as CSV to write", ".csv", _pauses, is_text=True),
        Exporter("bill", "costs in money by term as CSV to write", ".csv", _bill, is_text=True),
        Exporter("flows", "page for many vehicles", ".html", _flows, also=HTM, is_text=True),
        Exporter(
            "gpx",
            "folder for a GPX track of each vehicle",
            "",
            _gpx,
            is_folder=True,
            holds=("*.gpx",),
        ),
        Exporter(
            "sheets",
            "drivers' sheets, a printed page each",
            ".html",
            _sheets,
            also=HTM,
            is_text=True,
        ),
        Exporter(
            "drivers",
            "folder for a sheet and a calendar of each driver",
            "",
            _sheets,
            is_folder=True,
            holds=("*.html", "*.ics"),
        ),
        Exporter(
            "figures",
            "folder for figures fit for a paper",
            "",
            _figures,
            is_folder=True,
            holds=FIGURES,
        ),
    ],
)
"""In the order in which the command offers and writes them."""
