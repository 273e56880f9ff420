"""What a notebook shows of a plan by itself: its table."""

from __future__ import annotations

from html import escape

from ...network.road_network import RoadNetwork
from ...plans.credits import UNKNOWN_SOURCE
from ...plans.plan import Plan
from ...shown_text import fitted
from ..document.checks import check_is_plan
from ..document.vehicles import role_text
from ..markup.fragments import Piece, written
from ..markup.quantities import cost_unit, kilometres, percent, signed

__all__ = ["network_table", "plan_table"]

MOST_NOTES = 5


def network_table(net: RoadNetwork) -> str:
    """Return what a notebook shows of a network: its size and whose map it is.

    Parameters
    ----------
    net : RoadNetwork
        Any.

    Returns
    -------
    str
        HTML without script or style.
    """
    source = net.source
    credit = ", ".join(fitted(text) for text in (source.attribution, source.licence) if text)
    rows = (
        ("Nodes", f"{net.n:,}"),
        ("Edges", f"{net.m:,}"),
        ("Road", f"{net.length_m.sum() / 1000:,.0f} km"),
        ("Data of", fitted(source.extracted)),
        ("Credits", credit or UNKNOWN_SOURCE),
        *(("Note", fitted(remark)) for remark in net.load_report.remarks[:MOST_NOTES]),
    )
    cells = "".join(
        f"<tr><th>{escape(label)}</th><td>{escape(text)}</td></tr>" for label, text in rows if text
    )
    return f"<table><caption>{escape(fitted(source.name))}</caption>{cells}</table>"


def plan_table(plan: Plan) -> str:
    """Return a plan's vehicles and what each saves.

    Parameters
    ----------
    plan : Plan
        What is told.

    Returns
    -------
    str
        An HTML table without script or style.

    Raises
    ------
    ScenarioError
        Not a plan.
    """
    check_is_plan(plan)
    unit = cost_unit(plan.unit)
    rows = [
        Piece(
            "notebook-row",
            {
                "vehicle": fitted(vehicle.vehicle),
                "origin": fitted(vehicle.origin.name),
                "destination": fitted(vehicle.destination.name),
                "role": role_text(vehicle.role),
                "length": kilometres(vehicle.length_m),
                "platoon": kilometres(vehicle.platoon_m),
                "alone": unit.bare(vehicle.solo_cost),
                "joint": unit.bare(vehicle.joint_cost),
                "share": signed(percent(vehicle.saving)),
            },
        )
        for vehicle in plan.vehicles
    ]
    return written(
        Piece(
            "notebook-table",
            {
                "case": fitted(plan.case),
                "network": fitted(plan.network.name),
                "unit": unit.label,
                "rows": tuple(rows),
                "length": kilometres(sum(vehicle.length_m for vehicle in plan.vehicles)),
                "platoon": kilometres(plan.platoon_m),
                "alone": unit.bare(plan.solo_cost),
                "joint": unit.bare(plan.joint_cost),
                "share": signed(percent(plan.saving)),
            },
        )
    )
