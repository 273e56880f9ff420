"""Stops for trucks on the way of the vehicles of a plan, with what the map says of them."""

from __future__ import annotations

from collections.abc import Iterator

from ...network.antimeridian import near_deg
from ...network.placed import network_below
from ...network.preparing.unrolled import centre_longitude_deg
from ...network.road_network import RoadNetwork
from ...network.road_stop import RoadStop
from ...network.stops import stops_along
from ...plans.plan import Plan
from ...shown_text import shortened, shown
from ..drawing.basemap import BASEMAP_STEPS
from ..language.speech import number, say
from .model_map import StopLabel
from .place_labels import LONGEST_NAME

__all__ = ["stop_labels", "told_of"]

MOST_STOPS = 600
"""Of more on all ways together, the first of the vehicles that are told first."""

KINDS = {
    "services": "stops.services",
    "rest_area": "stops.rest-area",
    "parking": "stops.parking",
    "fuel": "stops.fuel",
    "charging": "stops.charging",
}
FUELS = {
    "diesel": "stops.diesel",
    "biodiesel": "stops.biodiesel",
    "hydrogen": "stops.hydrogen",
}
"""Fuels that have a word in each language; the names of others are the same everywhere."""
AS_WRITTEN = {"adblue": "AdBlue"}


def stop_labels(plan: Plan, net: RoadNetwork) -> tuple[StopLabel, ...]:
    """Return the stops on the ways of a plan.

    Parameters
    ----------
    plan : Plan
        Its ways are driven as they stand.
    net : RoadNetwork
        The network it was made on, with or without places between its junctions.

    Returns
    -------
    tuple of StopLabel
        Each once, in the order in which vehicles pass them.
    """
    below = network_below(net)
    found: dict[tuple[float, float, str], RoadStop] = {}
    for stretch in (plan.stretches[k] for way in plan.ways for k in way):
        for passed in stops_along(below, stretch.edges, stretch.span):
            stop = passed.stop
            found.setdefault((stop.lon, stop.lat, stop.tags), stop)
    middle = centre_longitude_deg(net)
    return tuple(_label(stop, middle) for stop in list(found.values())[:MOST_STOPS])


def _label(stop: RoadStop, middle: float) -> StopLabel:
    name = shortened(shown(stop.name), LONGEST_NAME) or say(KINDS[stop.kind])
    # The page lies on a plane: across the antimeridian longitudes are counted on.
    own = float(near_deg(stop.lon, middle)), stop.lat
    lon, lat = (round(degrees * BASEMAP_STEPS) for degrees in own)
    return StopLabel(lon, lat, name, told_of(stop))


def told_of(stop: RoadStop) -> str:
    """Return what there is at a stop, in the language that is spoken.

    Parameters
    ----------
    stop : RoadStop
        Where.

    Returns
    -------
    str
        Its kind, then spaces for trucks, fuels and charging as far as they are known.
    """
    return ", ".join(_parts(stop))


def _parts(stop: RoadStop) -> Iterator[str]:
    yield say(KINDS[stop.kind])
    if stop.capacity is not None:
        yield say("stops.spaces", spaces=number(stop.capacity))
    elif "parking" in stop.offers and stop.kind in ("fuel", "charging"):
        yield say("stops.parking")
    if stop.fuels:
        yield from (_fuel(fuel) for fuel in stop.fuels)
    elif "fuel" in stop.offers and stop.kind != "fuel":
        yield say("stops.fuel")
    if stop.power_kw is not None:
        yield say("stops.power", power=number(stop.power_kw))
    elif "charging" in stop.offers and stop.kind != "charging":
        yield say("stops.charging")


def _fuel(fuel: str) -> str:
    return say(FUELS[fuel]) if fuel in FUELS else AS_WRITTEN.get(fuel, fuel.upper())
