"""How many are many: from where on drawings and lists count what they would name."""

from __future__ import annotations

__all__ = ["CROWD", "MANY_EVENTS", "MOST_SPOKEN"]

CROWD = 8
"""More vehicles than this are a crowd: narrow rows, lines without dashes, marks that count."""

MANY_EVENTS = 8
"""Of more callouts than this, those without a good place are left out."""

MOST_SPOKEN = 12
"""Vehicles that the spoken description of a picture names one by one."""
