"""Paper for figures: its width, its type, and what is the same on all of them."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ..document.model_vehicle import Vehicle
from ..drawing.palette import INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["METADATA", "WIDTH_IN", "axes_of", "dash_of", "drawing"]

WIDTH_IN = 7.2

STYLE: Any = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": MUTED,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "text.parse_math": False,
    "svg.hashsalt": "platoon_osm",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "axes.formatter.use_mathtext": False,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


# A date would make two runs differ.
METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "platoon_osm"},
    "svg": {"Date": None, "Creator": "platoon_osm"},
    "pdf": {"CreationDate": None, "Creator": "platoon_osm", "Producer": "matplotlib"},
}


@contextmanager
def drawing() -> Iterator[None]:
    """Draw as all figures are drawn.

    Yields
    ------
    None
        While the block lasts.
    """
    import matplotlib

    with matplotlib.rc_context(STYLE), warnings.catch_warnings():
        # Letters that the font lacks are drawn as boxes; there is nothing to do about them.
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        warnings.filterwarnings("ignore", message="Matplotlib currently does not support")
        yield


def axes_of(height_in: float, layout: Any = "constrained") -> tuple[Figure, Axes]:
    """Return a figure with one pair of axes.

    Parameters
    ----------
    height_in : float
        Of the figure in inches.
    layout : str
        Of matplotlib.

    Returns
    -------
    tuple of Figure and Axes
        As wide as all figures.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, height_in), layout=layout)
    return figure, figure.add_subplot()


def dash_of(vehicle: Vehicle) -> dict[str, Any]:
    """Return how a vehicle's line is dashed.

    Parameters
    ----------
    vehicle : Vehicle
        Whose line it is.

    Returns
    -------
    dict
        Options of matplotlib; none if the line is solid.
    """
    # matplotlib counts dashes in line widths, the page in pixels of a line 3.6 wide.
    dash = [float(length) / 3.6 for length in vehicle.dash.split()]
    return {"linestyle": (0, tuple(dash)), "dash_capstyle": vehicle.cap} if dash else {}
