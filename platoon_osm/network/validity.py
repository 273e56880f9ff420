"""Values that every algorithm relies on: on the globe, finite, and codes that lead somewhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .columns import columns_per, shared_columns

__all__ = ["check_values"]


def check_values(value_of: Callable[[str], NDArray[Any]], texts: int) -> None:
    """Check the values of a network's columns.

    Parameters
    ----------
    value_of : callable
        Returns a column by name.
    texts : int
        How many texts there are.

    Raises
    ------
    NetworkError
        In one line: what, at which node or edge, and what would be right.
    """
    lon, lat, way_id = value_of("lon"), value_of("lat"), value_of("way_id")
    off_globe = ~((np.abs(lon) <= 180) & (np.abs(lat) <= 90))
    if off_globe.any():
        v = int(np.argmax(off_globe))
        raise NetworkError(
            f"network: node {value_of('node_id')[v]} lies at lon {lon[v]}, lat {lat[v]}; "
            "coordinates must be degrees within [-180, 180] and [-90, 90]"
        )
    length_m, speed_mps = value_of("length_m"), value_of("speed_mps")
    posted_mps = value_of("posted_mps")
    for label, values, allowed in (
        ("length", length_m, length_m >= 0),
        ("speed", speed_mps, speed_mps > 0),
        ("posted speed", posted_mps, posted_mps > 0),
    ):
        wrong = ~(allowed & np.isfinite(values))
        if wrong.any():
            e = int(np.argmax(wrong))
            raise NetworkError(
                f"network: edge {e} (way {way_id[e]}) has {label} {values[e]}; "
                f"a {label} must be finite and {'not below' if label == 'length' else 'above'} 0"
            )
    for column in shared_columns():
        values = value_of(column.name)
        # Two looks at the extremes, instead of one at every value: NaN is neither.
        if len(values) and not (values.min() >= 0 and values.max() < np.inf):
            e = int(np.argmax(~((values >= 0) & (values < np.inf))))
            raise NetworkError(
                f"network: edge {e} (way {way_id[e]}) has {column.name} {values[e]}; it must be "
                "finite and not below 0"
            )
    shape_lon, shape_lat = value_of("shape_lon"), value_of("shape_lat")
    off_globe = ~((np.abs(shape_lon) <= 180) & (np.abs(shape_lat) <= 90))
    if off_globe.any():
        at = int(np.argmax(off_globe))
        e = int(np.searchsorted(value_of("shape_first"), at, "right")) - 1
        raise NetworkError(
            f"network: edge {e} (way {way_id[e]}) passes lon {shape_lon[at]}, lat "
            f"{shape_lat[at]}; coordinates must be degrees within ±180 and ±90"
        )
    for column in columns_per("node", "edge", "named point"):
        if not column.codes or column.codes == "nodes":
            continue
        count = texts if column.codes == "texts" else len(column.codes)
        codes = value_of(column.name)
        # Read without a sign, a negative code is far beyond any count.
        if len(codes) and codes.view(f"u{codes.itemsize}").max() >= count:
            at = int(np.argmax((codes < 0) | (codes >= count)))
            raise NetworkError(
                f"network: {column.name} of {column.per} {at} is {codes[at]}; codes run from 0 to "
                f"{count - 1}, the positions in {_listed(column.codes)}"
            )


def _listed(codes: str | tuple[str, ...]) -> str:
    return codes if isinstance(codes, str) else f"{codes[0]} ... {codes[-1]}"
