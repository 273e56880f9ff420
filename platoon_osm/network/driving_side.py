"""Where vehicles keep to the left, by the code of the country.

Source: Vienna Convention on Road Traffic 1968, art. 10, and the list of countries at
https://wiki.openstreetmap.org/wiki/Key:driving_side; codes are those of ISO 3166-1.
"""

from __future__ import annotations

__all__ = ["keeps_left"]

LEFT = frozenset({
    "AG", "AI", "AU", "BB", "BD", "BM", "BN", "BS", "BT", "BW", "CC", "CK", "CX", "CY", "DM",
    "FJ", "FK", "GB", "GD", "GG", "GY", "HK", "ID", "IE", "IM", "IN", "JE", "JM", "JP", "KE",
    "KI", "KN", "KY", "LC", "LK", "LS", "MO", "MS", "MT", "MU", "MV", "MW", "MY", "MZ", "NA",
    "NF", "NP", "NR", "NU", "NZ", "PG", "PK", "PN", "SB", "SC", "SG", "SH", "SR", "SZ", "TC",
    "TH", "TK", "TL", "TO", "TT", "TV", "TZ", "UG", "VC", "VG", "VI", "WS", "ZA", "ZM", "ZW",
})  # fmt: skip


def keeps_left(country: str) -> bool:
    """Say whether vehicles keep to the left.

    Parameters
    ----------
    country : str
        ISO 3166 code of a country or of a part of one, "GB" or "US-CA"; empty if unknown.

    Returns
    -------
    bool
        False where the country is not known: most of the world's roads are driven on the right.
    """
    return country.partition("-")[0] in LEFT
