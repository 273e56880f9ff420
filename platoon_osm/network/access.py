"""How a place beside the road gets onto it: what is on the road, and how long the way there is.

A map of motorways does not hold the streets between a depot and the next junction. That way is
estimated, as a straight line with a detour, driven at one speed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..errors import NetworkError, brief
from ..kinds import is_number

__all__ = ["STANDARD_ACCESS", "Access"]


@dataclass(frozen=True, slots=True)
class Access:
    """How a place beside the road gets onto it.

    Attributes
    ----------
    on_road_m : float
        A place nearer to a carriageway than this is on it [m].
    detour : float
        Length of the way to the road against the straight distance.
    speed_kmh : float
        Speed on that way [km/h].
    limit_km : float
        A place farther from every road than this is refused [km].

    Raises
    ------
    NetworkError
        A number that is none, or out of its range.

    Notes
    -----
    Coordinates that people read off a map are some ten metres out, and a carriageway is some thirty
    metres wide with its shoulder: hence 100 m. Ways on real roads are longer than the straight line
    between their ends by a fifth (United States) to a third (Germany) [1]_: hence 1.3. Trucks drive
    some 50 km/h, the limit in built-up areas of most of Europe, between a motorway and a depot.

    References
    ----------
    .. [1] Ballou, Rahardja, Sakai, "Selected country circuity factors for road travel distance
       estimation", Transportation Research Part A 36 (2002).
    """

    on_road_m: float = 100.0
    detour: float = 1.3
    speed_kmh: float = 50.0
    limit_km: float = 50.0

    def __post_init__(self) -> None:
        for label, least, most, unit in (
            ("on_road_m", 0.0, 1_000.0, "m"),
            ("detour", 1.0, 10.0, "times the straight line"),
            ("speed_kmh", 1.0, 150.0, "km/h"),
            ("limit_km", 0.0, 20_000.0, "km"),
        ):
            value = getattr(self, label)
            if not (is_number(value) and math.isfinite(value) and least <= value <= most):
                raise NetworkError(
                    f"access: {label} is {brief(value)}; give {least:g} to {most:g} {unit}"
                )

    @property
    def speed_mps(self) -> float:
        """Speed on the way to the road [m/s]."""
        return self.speed_kmh / 3.6


STANDARD_ACCESS = Access()
"""What holds where nothing else is said."""
