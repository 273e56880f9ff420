"""The table of prices by preset: `figures.toml`."""

from __future__ import annotations

import datetime
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from ..consumption import Consumption
from ..cost_figure import CostFigure

__all__ = ["GIVEN", "figures_of", "looked_up", "physics_of"]

GIVEN = "given by the user"
"""The source of a figure that is not the table's."""


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads((files(__package__) / "figures.toml").read_text("utf-8"))


@cache
def figures_of(preset: str) -> Mapping[str, CostFigure]:
    """Return the prices of a preset.

    Parameters
    ----------
    preset : str
        "eu" or "us".

    Returns
    -------
    mapping of str to CostFigure
        By their names.
    """
    return MappingProxyType({row["name"]: CostFigure(**row) for row in _data()[preset]})


def physics_of(given: Consumption) -> tuple[CostFigure, ...]:
    """Return how driving becomes fuel, figure by figure.

    Parameters
    ----------
    given : Consumption
        Whose figures.

    Returns
    -------
    tuple of CostFigure
        Those that are not the default have their user as source.
    """
    usual = Consumption()
    found = []
    for row in _data()["physics"]:
        value = getattr(given, row["name"])
        source = row["source"] if value == getattr(usual, row["name"]) else GIVEN
        found.append(CostFigure(row["name"], value, row["unit"], source))
    return tuple(found)


def looked_up() -> datetime.date:
    """Return the day on which the table was last compared with its sources.

    Returns
    -------
    datetime.date
        A day.
    """
    day: datetime.date = _data()["looked_up"]
    return day
