"""Names of stops without the coordinates by which a place beside the road is found again."""

from __future__ import annotations

from ...network.location import format_position

__all__ = ["brief_name"]


def brief_name(name: str, lon: float, lat: float) -> str:
    """Return what a stop is called where its place is seen on the map or told beside it.

    Parameters
    ----------
    name : str
        In full, such as "near Oakland (37.800 N 122.270 W)".
    lon, lat : float
        Where it is [deg].

    Returns
    -------
    str
        Without its own coordinates at the end; unchanged if it has none.
    """
    return name.removesuffix(f" ({format_position(lon, lat)})") or name
