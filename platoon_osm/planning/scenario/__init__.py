"""Scenarios: what to plan, as people write it by hand or keep it in tables."""

from .reading import read_scenario
from .record import Scenario
from .trip_tables import read_trips

__all__ = ["Scenario", "read_scenario", "read_trips"]
