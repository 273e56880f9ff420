"""The table of a road network's columns: each name, type, unit and default is written here once.

Making a network, checking and opening a saved one, taking edges out of one, joining chains, cutting
edges, and the exchange with graphs and GeoDataFrames all go through this table. A further column is
a row here, and an attribute of `RoadNetwork` of the same name.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "COLUMNS",
    "POINT_KINDS",
    "ROAD_CLASSES",
    "STOP_KINDS",
    "Column",
    "Per",
    "columns_per",
    "lengthened",
    "shared_columns",
]

ROAD_CLASSES = (
    "motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link",
    "secondary", "secondary_link", "tertiary", "tertiary_link", "other", "ferry",
)  # fmt: skip
STOP_KINDS = ("services", "rest_area", "parking", "fuel", "charging")
"""Where trucks stop beside the road: the kind that says most of a place."""

POINT_KINDS = (*STOP_KINDS, "tunnel", "city", "town", "village")

Per = Literal["node", "edge", "shape point", "named point", "offset"]
"""What a column has one value for; offsets say where the rows of another column begin."""

Codes = Literal["", "nodes", "texts"] | tuple[str, ...]
InChain = Literal["longest", "same", "sum"]


@dataclass(frozen=True, slots=True)
class Column:
    """One column of a road network.

    Attributes
    ----------
    name : str
        The attribute of `RoadNetwork`, of its `points` where a dot stands in it.
    per : {"node", "edge", "shape point", "named point", "offset"}
        What it has one value for.
    dtype : str
        Type of a value, little-endian where it is saved.
    unit : str
        Unit of a value, or what a code stands for; empty for a mere number or text.
    default : bool, int, float or None
        Value where none is given; None where one must be given or is worked out.
    codes : str or tuple of str
        What the values are positions in: "nodes", "texts", or a tuple of names; empty for none.
    in_chain : {"longest", "same", "sum"}
        The value of a chain of edges that become one: that of the longest part, the one they all
        have, for nodes stay where it changes, or the sum, which the pieces of a cut edge share.
    """

    name: str
    per: Per
    dtype: str
    unit: str = ""
    default: bool | int | float | None = None
    codes: Codes = ""
    in_chain: InChain = "longest"

    def filled(self, count: int) -> NDArray[Any]:
        """Return the default, repeated.

        Parameters
        ----------
        count : int
            How many values.

        Returns
        -------
        ndarray, (count,)
            Of the column's type; zeros where it has no default.
        """
        return np.full(count, 0 if self.default is None else self.default, self.dtype)


COLUMNS = (
    Column("first_out", "offset", "i4", "position in the edges"),
    Column("tail", "edge", "i4", "node", codes="nodes"),
    Column("head", "edge", "i4", "node", codes="nodes"),
    Column("length_m", "edge", "f8", "m", in_chain="sum"),
    Column("speed_mps", "edge", "f8", "m/s", 80 / 3.6),
    Column("posted_mps", "edge", "f8", "m/s", 80 / 3.6),
    Column("lon", "node", "f8", "deg"),
    Column("lat", "node", "f8", "deg"),
    Column("node_id", "node", "i8", "OpenStreetMap id"),
    Column("node_name", "node", "i4", "text", 0, "texts"),
    Column("node_ref", "node", "i4", "text", 0, "texts"),
    Column("road_class", "edge", "u1", "class", 0, ROAD_CLASSES),
    Column("ref", "edge", "i4", "text", 0, "texts"),
    Column("name", "edge", "i4", "text", 0, "texts"),
    Column("toll", "edge", "b1", "", False, in_chain="same"),
    Column("inferred", "edge", "b1", "", False, in_chain="same"),
    Column("restriction", "edge", "i4", "text", 0, "texts", in_chain="same"),
    Column("country", "edge", "i4", "text", 0, "texts", in_chain="same"),
    Column("climb_m", "edge", "f4", "m", 0, in_chain="sum"),
    Column("descent_m", "edge", "f4", "m", 0, in_chain="sum"),
    Column("graded_m", "edge", "f4", "m", 0, in_chain="sum"),
    Column("toll_free_m", "edge", "f4", "m", 0, in_chain="sum"),
    Column("way_id", "edge", "i8", "OpenStreetMap id", 0),
    Column("shape_first", "offset", "i8", "position in the shape points"),
    Column("shape_lon", "shape point", "f8", "deg"),
    Column("shape_lat", "shape point", "f8", "deg"),
    Column("points.lon", "named point", "f8", "deg"),
    Column("points.lat", "named point", "f8", "deg"),
    Column("points.kind", "named point", "u1", "kind", codes=POINT_KINDS),
    Column("points.name", "named point", "i4", "text", codes="texts"),
    Column("points.population", "named point", "i8", "inhabitants"),
    Column("points.capacity", "named point", "i4", "spaces for trucks", -1),
    Column("points.tags", "named point", "i4", "text", 0, "texts"),
)  # fmt: skip
"""All columns, in the order in which a saved network has them."""


def columns_per(*kinds: Per) -> tuple[Column, ...]:
    """Return the columns that have one value for each thing of some kinds.

    Parameters
    ----------
    *kinds : str
        "node", "edge", "shape point", "named point", "offset".

    Returns
    -------
    tuple of Column
        In the order of the table.
    """
    return tuple(column for column in COLUMNS if column.per in kinds)


def shared_columns() -> tuple[Column, ...]:
    """Return the columns of edges, but for their lengths, that the pieces of a cut edge share.

    Returns
    -------
    tuple of Column
        In the order of the table.
    """
    return tuple(
        column
        for column in columns_per("edge")
        if column.in_chain == "sum" and column.name != "length_m"
    )


def lengthened(net: Any, per: Per, count: int, **added: Any) -> dict[str, NDArray[Any]]:
    """Return the columns of one kind with more values behind those there are.

    Parameters
    ----------
    net : RoadNetwork
        Whose columns they are.
    per : str
        The kind, "node" or "edge".
    count : int
        How many values are added.
    **added : array_like, (count,) or one value for all
        The new values by column; those not named get the column's default.

    Returns
    -------
    dict of str to ndarray
        All columns of that kind by name.
    """
    longer = {}
    for column in columns_per(per):
        old = getattr(net, column.name)
        new = column.filled(count)
        if column.name in added:
            new[:] = added[column.name]
        longer[column.name] = np.concatenate([old, new])
    return longer
