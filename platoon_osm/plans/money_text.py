"""Amounts of money as text."""

from __future__ import annotations

__all__ = ["money"]


def money(cents: int, currency: str) -> str:
    """Return an amount with its currency.

    Parameters
    ----------
    cents : int
        The amount.
    currency : str
        ISO 4217 code.

    Returns
    -------
    str
        As "1,234.50 EUR".
    """
    return f"{cents / 100:,.2f} {currency}"
