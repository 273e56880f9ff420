"""The truck and the law that cap a speed."""

from __future__ import annotations

from dataclasses import dataclass, field
from numbers import Real

from ...errors import ScenarioError
from .law import Law, law_of, laws

__all__ = ["CUSTOMARY_KMH", "FASTEST_KMH", "SLOWEST_KMH", "TruckRules"]

FASTEST_KMH, SLOWEST_KMH = 150.0, 3.0
"""Speeds outside are slips of the pen: a "70|100" read as 70100 must not make a road fast."""

CUSTOMARY_KMH = 90.0
"""A limiter where no country says otherwise: that of the EU, by Directive 92/6/EEC."""


@dataclass(frozen=True, slots=True)
class TruckRules:
    """The vehicle and the law that cap a speed.

    Attributes
    ----------
    country : str or None
        ISO code whose limits for trucks apply, such as "IT", "DE" or "US-CA", in any case; None
        if not known, and then only the limiter caps.
    limiter_kmh : float
        What the vehicle's speed limiter allows; None becomes that of the country, 90 where none
        is known and 150 where trucks need none.
    customary : bool
        Whether nobody gave the limiter, so that each country has its own.
    """

    country: str | None = None
    limiter_kmh: float | None = None
    customary: bool = field(init=False, default=True)

    def __post_init__(self) -> None:
        country, limiter = self.country, self.limiter_kmh
        code = country.strip().upper() if isinstance(country, str) else ""
        known = code in laws()
        if country is not None and not known:
            countries = ", ".join(sorted(own for own in laws() if "-" not in own))
            raise ScenarioError(
                f"country {_shown(country)} has no truck limit here; use {countries}, or a state "
                "such as US-CA or CA-ON"
            )
        if known:
            object.__setattr__(self, "country", code)
        object.__setattr__(self, "customary", limiter is None)
        if limiter is None:
            own = self.law.limiter_kmh
            limiter = CUSTOMARY_KMH if own is None else min(own, FASTEST_KMH)
        # Numpy's numbers are numbers too; True is none.
        is_number = isinstance(limiter, Real) and not isinstance(limiter, bool)
        if not (is_number and SLOWEST_KMH <= limiter <= FASTEST_KMH):
            raise ScenarioError(
                f"limiter_kmh {_shown(limiter)}: a speed limiter lies between "
                f"{SLOWEST_KMH:g} and {FASTEST_KMH:g} km/h"
            )
        object.__setattr__(self, "limiter_kmh", float(limiter))

    @property
    def law(self) -> Law:
        """The limits of the country; none if it is not known."""
        return law_of(self.country)

    @property
    def limiter(self) -> float:
        """The limiter [km/h]."""
        return CUSTOMARY_KMH if self.limiter_kmh is None else self.limiter_kmh

    def within(self, country: str) -> TruckRules:
        """Return the rules on a road of a country.

        Parameters
        ----------
        country : str
            Where it is, "IT" or "US-CA"; empty if that is not known.

        Returns
        -------
        TruckRules
            The same if they name a country themselves, or if nothing is known of that one.
        """
        law = law_of(country)
        if self.country or not law.code:
            return self
        return TruckRules(law.code, None if self.customary else self.limiter_kmh)

    @property
    def cap_kmh(self) -> float:
        """The lower of the country's limit on motorways and the limiter."""
        return min(self.law.truck_kmh("motorway"), self.limiter)


def _shown(value: object) -> str:
    return " ".join(repr(value).split())[:80]
