"""What a notebook shows of a plan by itself: its table."""

from __future__ import annotations

from html import escape
from typing import NamedTuple

from ...network.road_network import RoadNetwork
from ...plans.credits import UNKNOWN_SOURCE
from ...plans.paid import paid
from ...plans.plan import Plan
from ...shown_text import fitted
from ..charts.fleet_charts import fine_percent, gap_percent
from ..document.checks import check_is_plan
from ..document.model_vehicle import CostTexts, called
from ..document.status import status
from ..document.timeline import vehicle_day
from ..document.vehicles import role_text
from ..document.wording import cost_texts, plan_unit
from ..drawing.vehicle_styles import vehicle_styles
from ..language.speech import number, say
from ..markup.fragments import Piece, Tree, written
from ..markup.quantities import kilometres

__all__ = ["network_table", "plan_table"]

MOST_NOTES = 5

MOST_OF_FLEET = 20
"""Rows of a fleet's vehicles; thousands would outweigh the notebook."""


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
        (say("notebook.nodes"), number(net.n)),
        (say("notebook.edges"), number(net.m)),
        (say("notebook.road"), kilometres(float(net.length_m.sum()))),
        (say("about.data-of"), fitted(source.extracted)),
        (say("notebook.credits"), credit or UNKNOWN_SOURCE),
        *(
            (say("notebook.note"), fitted(remark))
            for remark in net.load_report.remarks[:MOST_NOTES]
        ),
    )
    cells = "".join(
        f"<tr><th>{escape(label)}</th><td>{escape(text)}</td></tr>" for label, text in rows if text
    )
    return f"<table><caption>{escape(fitted(source.name))}</caption>{cells}</table>"


def plan_table(plan: Plan) -> str:
    """Return a plan's vehicles and what each saves; of a whole fleet the first of them.

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
    unit, vehicles = plan_unit(plan), plan.vehicles
    listed = vehicles if plan.fleet is None else vehicles[:MOST_OF_FLEET]
    styles = vehicle_styles([one.vehicle for one in vehicles])
    names = [
        called(style.letter, "" if name == style.letter else name)
        for style, name in zip(styles, (fitted(one.vehicle) for one in vehicles), strict=True)
    ]
    days = [vehicle_day(plan, index) for index in range(len(vehicles))]
    together = any(stretch.together for stretch in plan.stretches)
    late = ["" if day is None else day.text.late for day in days]
    shown = _Columns(together, any(late))
    rows = [
        Piece(
            "notebook-row",
            {
                "vehicle": name,
                "origin": fitted(one.origin.name),
                "destination": fitted(one.destination.name),
                "role": role_text(one.role),
                "cells": shown.cells(
                    kilometres(one.length_m),
                    kilometres(one.platoon_m),
                    cost_texts(*paid(plan, (index,)), unit),
                    by,
                ),
            },
        )
        for index, (name, one, by) in enumerate(
            zip(names[: len(listed)], listed, late[: len(listed)], strict=True)
        )
    ]
    if more := len(vehicles) - len(listed):
        rows.append(Piece("notebook-more", {"text": say("notebook.more", n=more)}))
    return written(
        Piece(
            "notebook-table",
            {
                "status": tuple(
                    Piece("notebook-status", {"text": one.text})
                    for one in status(names, days, together)
                ),
                "caption": _caption(plan, unit.label),
                "heads": shown.heads(),
                "rows": tuple(rows),
                "totals": shown.cells(
                    kilometres(sum(one.length_m for one in vehicles)),
                    kilometres(plan.platoon_m),
                    cost_texts(*paid(plan), unit),
                    "",
                ),
            },
        )
    )


def _caption(plan: Plan, unit: str) -> str:
    network = fitted(plan.network.name)
    if (fleet := plan.fleet) is None:
        return say("notebook.caption", case=fitted(plan.case), network=network, unit=unit)
    alone = fleet.alone_cost
    return say(
        "notebook.fleet",
        n=number(len(plan.trips)),
        network=network,
        saving=fine_percent(fleet.saved_share),
        most=fine_percent(fleet.most / alone if alone else 0.0),
        gap=gap_percent(fleet.gap),
        unit=unit,
    )


class _Columns(NamedTuple):
    """Which columns a table has: no platoon where there is none, lateness where somebody is."""

    together: bool
    late: bool

    def heads(self) -> Tree:
        keys = ["table.vehicle", "notebook.way", "notebook.role", "notebook.length"]
        if self.together:
            keys += ["notebook.platoon", "table.alone", "table.joint", "table.saving"]
        else:
            keys += ["table.cost"]
        if self.late:
            keys += ["notebook.late"]
        return tuple(Piece("notebook-head", {"text": say(key)}) for key in keys)

    def cells(self, length: str, platoon: str, costs: CostTexts, late: str) -> Tree:
        texts = [length]
        if self.together:
            texts += [platoon, costs.alone, costs.joint, costs.share]
        else:
            texts += [costs.joint]
        if self.late:
            texts += [late]
        return tuple(Piece("notebook-cell", {"text": text}) for text in texts)
