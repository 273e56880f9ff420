"""What a stop beside the road offers to a vehicle: each part of it is judged by its own tags."""

from __future__ import annotations

from datetime import datetime

from ..network.restrictions import decode
from ..network.road_stop import RoadStop
from ..network.stop_tags import OFFERS, offers_of
from .access import Way
from .judgement import judge
from .profile import Vehicle

__all__ = ["offers_to"]


def offers_to(stop: RoadStop, vehicle: Vehicle, when: datetime | None = None) -> tuple[str, ...]:
    """Return what a vehicle may do at a stop.

    Parameters
    ----------
    stop : RoadStop
        Where.
    vehicle : Vehicle
        Who comes.
    when : datetime, optional
        What clocks on the spot show; without it, hours are left open.

    Returns
    -------
    tuple of str
        Of "parking", "fuel" and "charging", what is not closed to it by access or by its size.
    """
    layers = decode(stop.tags)
    if not layers:
        return stop.offers
    found = {
        offer
        for layer in layers
        if judge([layer], vehicle, when).way != Way.CLOSED
        for offer in offers_of([layer if vehicle.heavy else {**layer, "hgv": ""}])
    }
    return tuple(offer for offer in OFFERS if offer in found)
