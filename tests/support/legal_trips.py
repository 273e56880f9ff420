"""The fastest legal trip of one vehicle, asked in one line."""

from platoon_osm.planning.legal.driver import one_driver
from platoon_osm.planning.legal.driver.trip_question import TripQuestion

__all__ = ["fastest", "least_late"]


def fastest(*asked, aim="arrive", dominance=True, **named):
    """Return the fastest trip of a question that is given by its fields, and perhaps its aim."""
    if len(asked) > 8:
        *asked, aim = asked
    return one_driver.fastest(TripQuestion(*asked, **named), aim, dominance=dominance)


def least_late(*asked, **named):
    """Return the earliest arrival likewise."""
    return one_driver.least_late(TripQuestion(*asked, **named))
