"""Figures as people read them: distances, litres, shares and costs with their unit."""

from __future__ import annotations

from dataclasses import dataclass

from .shown_text import shortened, shown

__all__ = ["CostUnit", "clock_span", "cost_unit", "kilometres", "litres", "percent", "signed"]

MINUS = "\u2212"


def signed(text: str) -> str:
    """Return a figure's text with a plus sign, or a true minus sign; none for zero."""
    if text.startswith("-"):
        return _unsigned_zero(MINUS + text[1:])
    return _unsigned_zero("+" + text)


def _unsigned_zero(text: str) -> str:
    return text if any(digit in text for digit in "123456789") else text[1:]


def kilometres(length_m: float) -> str:
    """Return a length given in metres as "544 km", with a decimal below 10 km."""
    km = length_m / 1000
    return f"{km:.1f} km" if abs(km) < 9.95 else f"{km:,.0f} km"


def litres(fuel_l: float) -> str:
    """Return a volume of fuel as "21.4 l"."""
    return f"{fuel_l:,.1f} l" if abs(fuel_l) < 999.5 else f"{fuel_l:,.0f} l"


def clock_span(seconds: float) -> str:
    """Return a time span as a figure: "24 min", from an hour on "1:05 h"."""
    hours, minutes = divmod(round(seconds / 60), 60)
    return f"{hours:,}:{minutes:02d} h" if hours else f"{minutes} min"


def percent(share: float) -> str:
    """Return a share (0.013) as "1.3 %"."""
    return f"{share * 100:.1f}\u202f%"


@dataclass(frozen=True, slots=True)
class CostUnit:
    """How costs of one unit are printed.

    Attributes
    ----------
    label : heads a column.
    note : explains the unit; empty if it needs no explanation.
    scale : printed figure per stored figure.
    decimals : of the printed figure.
    before, after : what stands around a lone figure.
    """

    label: str
    note: str
    scale: float
    decimals: int
    before: str
    after: str

    def bare(self, cost: float) -> str:
        """Return a cost without its unit, for a column that names it."""
        return f"{cost * self.scale:,.{self.decimals}f}".replace("-", MINUS)

    def bare_signed(self, cost: float) -> str:
        """Return a cost without its unit, with its sign."""
        return signed(f"{cost * self.scale:,.{self.decimals}f}")

    def full(self, cost: float) -> str:
        """Return a cost with its unit."""
        return f"{self.before}{self.bare(cost)}{self.after}"


def cost_unit(unit: str) -> CostUnit:
    """Return how costs are printed that a plan states in `unit` ("m", "EUR", or any other)."""
    if unit == "m":
        note = (
            "Costs are in kilometre equivalents: distance, time and fuel, "
            "each rescaled to kilometres and added up."
        )
        return CostUnit("km eq.", note, 1e-3, 1, "", "\u00a0km\u00a0eq.")
    if unit == "EUR":
        return CostUnit("\u20ac", "", 1.0, 2, "\u20ac", "")
    name = shortened(shown(unit), 12)
    return CostUnit(name or "cost", "", 1.0, 2, "", f"\u00a0{name}" if name else "")
