"""How many decimals costs are printed with, the same in every text, table and page."""

from __future__ import annotations

__all__ = ["cost_decimals"]

LARGE = 10_000.0
"""Costs from here on are printed without decimals, and so are all beside them."""

METRES = 1000.0
"""Metre-equivalents are printed as kilometre-equivalents."""

WHOLE = frozenset({"CLP", "ISK", "JPY", "KRW", "PYG", "UGX", "VND", "XAF", "XOF"})
"""Money that has no coins below its unit."""


def cost_decimals(unit: str, largest: float) -> int:
    """Return how many decimals all costs have that are printed together.

    Parameters
    ----------
    unit : str
        A plan's: "m", or money of any name.
    largest : float
        The largest of them, in that unit.

    Returns
    -------
    int
        One of kilometre-equivalents, two of money; none of large sums.
    """
    if unit == "m":
        return 0 if abs(largest) >= LARGE * METRES else 1
    return 0 if abs(largest) >= LARGE or unit in WHOLE else 2
