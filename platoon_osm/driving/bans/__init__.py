"""Driving bans of countries for heavy goods vehicles: weekends, holidays, nights and summers."""
