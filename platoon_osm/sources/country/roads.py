"""The country of each road: that asked for, else by the outlines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from .law import law_of
from .outline import country_of
from .rules import FASTEST_KMH, TruckRules

__all__ = ["countries_of", "law_told", "limiter_told"]


def countries_of(rules: TruckRules, lon: ArrayLike, lat: ArrayLike) -> list[str]:
    """Return the country of each road, by a point of it.

    Parameters
    ----------
    rules : TruckRules
        If they name a country, it is that of all.
    lon, lat : array_like of float, (k,)
        Degrees; NaN where no point is known.

    Returns
    -------
    list of str, (k,)
        "IT", "US-CA"; empty where there is none.
    """
    if rules.country:
        return [rules.country] * np.size(np.asarray(lon))
    return [str(code) for code in country_of(lon, lat)]


def law_told(rules: TruckRules, found: Sequence[str], remedy: str) -> str:
    """Say whose limits for trucks hold on a network.

    Parameters
    ----------
    rules : TruckRules
        With the country asked for, if one was.
    found : sequence of str
        Countries of its roads; those that are not known are empty.
    remedy : str
        How to name a country.

    Returns
    -------
    str
        The end of a sentence.
    """
    where = "where the map has no maxspeed:hgv"
    if rules.country:
        return f"{_law_of_trucks([rules.country])} {where}"
    known = sorted({code for code in found if law_of(code).code})
    others = sorted({code for code in found if code and not law_of(code).code})
    if not known and not others:
        return f"no national limit, as no country was found; give one ({remedy})"
    told = [f"{_law_of_trucks(known)} {where}"] if known else []
    if others:
        told.append(f"no limit for trucks in {', '.join(others)}, for none is in the table")
    return " and ".join(told) + ", by where they lie"


def _law_of_trucks(codes: Sequence[str]) -> str:
    own = [code for code in codes if law_of(code).trucks]
    rest = [code for code in codes if code not in own]
    told = [f"the truck limit of {', '.join(own)}"] if own else []
    if rest:
        told.append(f"no limit of trucks' own in {', '.join(rest)}")
    return " and ".join(told)


def limiter_told(rules: TruckRules, found: Sequence[str]) -> str:
    """Say what limiter caps the speeds of a network.

    Parameters
    ----------
    rules : TruckRules
        With the limiter asked for, if one was.
    found : sequence of str
        Countries of its roads; those that are not known are empty.

    Returns
    -------
    str
        The beginning of a sentence.
    """
    by_speed: dict[float, list[str]] = {}
    for code in sorted(set(found)):
        by_speed.setdefault(rules.within(code).limiter, []).append(code)
    if len(by_speed) <= 1:
        only = next(iter(by_speed), rules.limiter)
        return _limiter(only)
    return "; ".join(
        f"{_limiter(speed)} in {', '.join(code or 'places unknown' for code in codes)}"
        for speed, codes in sorted(by_speed.items())
    )


def _limiter(kmh: float) -> str:
    return "no limiter" if kmh >= FASTEST_KMH else f"a limiter of {kmh:g} km/h"
