"""The country of each road: that asked for, else by the outlines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..truck import COUNTRY_LIMITS_KMH, TruckRules
from .outline import country_of

__all__ = ["countries_of", "law_told"]


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
        return f"the truck limit of {rules.country} {where}"
    known = sorted({code for code in found if code in COUNTRY_LIMITS_KMH})
    others = sorted({code for code in found if code and code not in COUNTRY_LIMITS_KMH})
    if not known and not others:
        return f"no national limit, as no country was found; give one ({remedy})"
    told = [f"the truck limit of {', '.join(known)} {where}"] if known else []
    if others:
        told.append(f"no limit for trucks in {', '.join(others)}, for none is in the table")
    return " and ".join(told) + ", by the outlines of countries"
