"""Pounds, tons, feet, inches and miles in tonnes, metres and kilometres.

All are exact by definition: NIST Handbook 44, appendix C.
"""

from __future__ import annotations

__all__ = ["FOOT_M", "INCH_M", "LONG_TON_T", "MILE_KM", "POUND_T", "SHORT_TON_T"]

POUND_T = 0.45359237e-3
SHORT_TON_T = 0.90718474
"""2,000 pounds, as in America."""

LONG_TON_T = 1.0160469088
"""2,240 pounds, as in Britain."""

FOOT_M = 0.3048
INCH_M = 0.0254
MILE_KM = 1.609344
