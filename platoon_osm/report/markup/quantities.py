"""Figures as people read them: distances, litres, shares and costs with their unit."""

from __future__ import annotations

from dataclasses import dataclass

from ...plans.clock import whole_minutes
from ...plans.cost_decimals import cost_decimals
from ...shown_text import shortened, shown
from ..language.speech import number, say, spoken

__all__ = [
    "MINUS",
    "CostUnit",
    "carbon",
    "clock_span",
    "cost_unit",
    "gain_or_loss",
    "kilometres",
    "litres",
    "percent",
    "signed",
    "true_minus",
]

MINUS = "\u2212"

CENTS = 2
"""Decimals of money told to the cent."""


def signed(text: str) -> str:
    """Return a figure's text with its sign.

    Parameters
    ----------
    text : str
        As Python prints it.

    Returns
    -------
    str
        With a plus sign or a true minus sign; none for zero.
    """
    if text.startswith("-"):
        return _unsigned_zero(MINUS + text[1:])
    return _unsigned_zero("+" + text)


def _unsigned_zero(text: str) -> str:
    return text if any(digit in text for digit in "123456789") else text[1:]


def true_minus(text: str) -> str:
    """Return a figure's text with a true minus sign for a hyphen.

    Parameters
    ----------
    text : str
        As Python prints it.

    Returns
    -------
    str
        As people read it.
    """
    return text.replace("-", MINUS)


def gain_or_loss(saved: float) -> str:
    """Return what pages call a saving, which gives it its colour.

    Parameters
    ----------
    saved : float
        A cost or a share saved.

    Returns
    -------
    str
        "gain", "loss" or "even".
    """
    return "gain" if saved > 0 else "loss" if saved < 0 else "even"


def kilometres(length_m: float) -> str:
    """Return a length as "544 km", with a decimal below 10 km.

    Parameters
    ----------
    length_m : float
        In metres.

    Returns
    -------
    str
        In kilometres.
    """
    km = length_m / 1000
    return f"{number(km, 1 if abs(km) < 9.95 else 0)} km"


def litres(fuel_l: float) -> str:
    """Return a volume of fuel as "21.4 l".

    Parameters
    ----------
    fuel_l : float
        In litres.

    Returns
    -------
    str
        With its unit.
    """
    return f"{_told(fuel_l, 1 if abs(fuel_l) < 999.5 else 0)}\u00a0l"


def _told(value: float, decimals: int) -> str:
    """Return a number of which nothing is left when it is rounded without a sign."""
    return number(round(value, decimals) + 0.0, decimals)


def clock_span(seconds: float) -> str:
    """Return a time span as a figure: "24 min", from an hour on "1:05 h".

    Parameters
    ----------
    seconds : float
        The span [s].

    Returns
    -------
    str
        Rounded as all durations are.
    """
    hours, minutes = divmod(whole_minutes(seconds), 60)
    return f"{number(hours)}:{minutes:02d} h" if hours else f"{minutes} min"


def carbon(mass_kg: float) -> str:
    """Return a mass of CO2e as "105 kg", with a decimal below 10 kg.

    Parameters
    ----------
    mass_kg : float
        In kilograms.

    Returns
    -------
    str
        With its unit.
    """
    return f"{_told(mass_kg, 1 if abs(mass_kg) < 9.95 else 0)}\u00a0kg"


def percent(share: float) -> str:
    """Return a share (0.013) as "1.3 %".

    Parameters
    ----------
    share : float
        Of 1.

    Returns
    -------
    str
        In percent.
    """
    return say("form.percent", number=number(share * 100, 1))


@dataclass(frozen=True, slots=True)
class CostUnit:
    """How costs of one unit are printed.

    Attributes
    ----------
    label : str
        Heads a column.
    note : str
        Explains the unit; empty if it needs no explanation.
    scale : float
        Printed figure per stored figure.
    decimals : int
        Of the printed figure.
    before, after : str
        What stands around a lone figure.
    """

    label: str
    note: str
    scale: float
    decimals: int
    before: str
    after: str

    def bare(self, cost: float) -> str:
        """Return a cost without its unit, for a column that names it.

        Parameters
        ----------
        cost : float
            In the plan's unit.

        Returns
        -------
        str
            As it is printed.
        """
        return true_minus(number(cost * self.scale, self.decimals))

    def bare_signed(self, cost: float) -> str:
        """Return a cost without its unit, with its sign.

        Parameters
        ----------
        cost : float
            In the plan's unit.

        Returns
        -------
        str
            As it is printed.
        """
        return signed(number(cost * self.scale, self.decimals))

    def full(self, cost: float) -> str:
        """Return a cost with its unit.

        Parameters
        ----------
        cost : float
            In the plan's unit.

        Returns
        -------
        str
            As it is printed.
        """
        text = self.bare(cost)
        if self.before and text.startswith(MINUS):
            return f"{MINUS}{self.before}{text[1:]}{self.after}"
        return f"{self.before}{text}{self.after}"


SYMBOLS = {"EUR": "\u20ac", "USD": "$"}
"""Of money; any other is called by its name, which stands behind an amount."""


def cost_unit(unit: str, largest: float = 0.0, *, to_the_cent: bool = False) -> CostUnit:
    """Return how costs of a plan are printed.

    Parameters
    ----------
    unit : str
        The plan's: "m", "EUR", or any other.
    largest : float
        The largest cost that is printed; where it is large, no cost has decimals.
    to_the_cent : bool
        Whether costs are whole cents, all of which are printed, so that they add up.

    Returns
    -------
    CostUnit
        How they are printed.
    """
    decimals = CENTS if to_the_cent else cost_decimals(unit, largest)
    if unit == "m":
        label = say("unit.km")
        after = "\u00a0" + label.replace(" ", "\u00a0")
        return CostUnit(label, say("unit.km-note"), 1e-3, decimals, "", after)
    if symbol := SYMBOLS.get(unit):
        if spoken().currency_first:
            return CostUnit(symbol, "", 1.0, decimals, symbol, "")
        return CostUnit(symbol, "", 1.0, decimals, "", f"\u00a0{symbol}")
    name = shortened(shown(unit), 12)
    return CostUnit(
        name or say("unit.cost"), "", 1.0, decimals, "", f"\u00a0{name}" if name else ""
    )
