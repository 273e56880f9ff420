"""What the values of access tags mean for a goods vehicle, and which key decides.

Everything that is known of the values stands in `VALUES`, of barriers in `BARRIERS`. A list of
values ("no;destination") is as strict as its strictest part. Of the keys that are there the most
specific decides: hgv before goods before motor_vehicle before vehicle before access.

Source: https://wiki.openstreetmap.org/wiki/Key:access, and the pages of the keys named here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from enum import IntEnum

from .profile import Vehicle

__all__ = [
    "BARRIERS",
    "CHAIN",
    "HAZARDOUS",
    "LANES",
    "RESERVED",
    "VALUES",
    "Way",
    "barrier_way",
    "chain_of",
    "deciding",
    "read_value",
]


class Way(IntEnum):
    """Who may pass, from the most open to the strictest."""

    OPEN = 0
    ENDS = 1
    CLOSED = 2


VALUES: Mapping[str, Way] = {
    **dict.fromkeys(
        (
            "yes", "designated", "permissive", "official", "public", "true", "1", "allowed",
            "discouraged", "limited", "unknown", "lane", "lanes", "",
        ),
        Way.OPEN,
    ),
    **dict.fromkeys(
        (
            "destination", "delivery", "deliveries", "customers", "customer", "permit", "private",
            "residents", "resident", "local", "visitors", "guests", "employees", "staff",
            "members", "tenants", "owner", "loading", "loading_and_unloading", "unloading",
            "business", "service", "students",
        ),
        Way.ENDS,
    ),
    **dict.fromkeys(
        (
            "no", "false", "0", "none", "agricultural", "forestry", "hov", "psv", "bus", "buses",
            "coach", "taxi", "tram", "military", "restricted", "closed", "emergency", "police",
            "use_sidepath", "dismount", "impassable", "construction", "abandoned",
            "bicycle", "foot", "motorcar", "motorcycle", "moped", "maintenance",
        ),
        Way.CLOSED,
    ),
}  # fmt: skip
"""Open: anybody. Ends: who starts or ends a trip there, never transit. Closed: nobody that this
package plans for. A value that is not here is closed, and the loader counts it."""

CHAIN = ("hgv_articulated", "hgv", "goods", "motor_vehicle", "vehicle", "access")
"""Keys from the most specific to the most general; the first that is there decides."""

HAZARDOUS = ("hazmat", "hazmat:water")
"""Keys that hold besides for dangerous goods, with `hazmat:` and a class of goods or a category of
tunnels."""

RESERVED = ("hov", "psv", "bus", "taxi", "tram", "coach")
"""Keys of those for whom a carriageway may be reserved: `hov=only`, `bus=only`."""

ONLY = frozenset({"only", "required"})
RESERVED_FOR = {**dict.fromkeys(RESERVED, ONLY), "hov": ONLY | {"designated"}}
"""`hov=designated` on a whole carriageway leaves no lane to others; `bus=designated` alone does."""

LANES = ":lanes"

BARRIERS: Mapping[str, Way] = {
    **dict.fromkeys(
        (
            "gate", "lift_gate", "swing_gate", "sliding_gate", "sliding_beam", "toll_booth",
            "border_control", "checkpoint", "cattle_grid", "entrance", "kerb", "height_restrictor",
            "width_restrictor", "rumble_strip", "no", "",
        ),
        Way.OPEN,
    ),
    **dict.fromkeys(
        (
            "bollard", "rising_bollard", "block", "jersey_barrier", "debris", "cycle_barrier",
            "motorcycle_barrier", "stile", "kissing_gate", "turnstile", "full-height_turnstile",
            "log", "chain", "rope", "planter", "bus_trap", "sump_buster", "wall", "fence", "hedge",
            "guard_rail", "ditch", "horse_stile", "hampshire_gate", "wicket_gate", "bump_gate",
            "spikes", "tyres", "barrier_board", "delineators", "wedge", "tank_trap", "cable",
        ),
        Way.CLOSED,
    ),
}  # fmt: skip
"""What a barrier on a road is without an access tag of its own; with one, that decides. One that is
not here is open, and the loader counts it."""

LOCKED = "locked"
DIVIDERS = re.compile(r"[;,|]")


def read_value(text: str) -> tuple[Way, tuple[str, ...]]:
    """Read the value of an access key.

    Parameters
    ----------
    text : str
        One value, or a list of them.

    Returns
    -------
    way : Way
        The strictest of the list.
    unknown : tuple of str
        Values that are not in the table.
    """
    parts = [part.strip().lower().replace(" ", "_") for part in DIVIDERS.split(text)]
    found = [part for part in parts if part] or [""]
    unknown = tuple(part for part in found if part not in VALUES)
    return max(VALUES.get(part, Way.CLOSED) for part in found), unknown


def chain_of(vehicle: Vehicle) -> Iterator[str]:
    """Return the access keys that hold for a vehicle, the most specific first.

    Parameters
    ----------
    vehicle : Vehicle
        Who drives.

    Yields
    ------
    str
        Keys of `CHAIN`.
    """
    if vehicle.heavy:
        if vehicle.trailer:
            yield "hgv_articulated"
        yield "hgv"
    yield from CHAIN[2:]


def deciding(tags: Mapping[str, str], vehicle: Vehicle) -> Iterator[tuple[str, Way]]:
    """Return the access keys that decide for a vehicle; all of them hold.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road or a barrier, conditions settled.
    vehicle : Vehicle
        Who drives.

    Yields
    ------
    key : str
        That decides.
    way : Way
        What it says.
    """
    own = next((key for key in chain_of(vehicle) if key in tags), None)
    if own is not None:
        yield own, read_value(tags[own])[0]
    if vehicle.hazardous:
        for key in tags:
            if _is_hazmat(key, vehicle.tunnel_code):
                yield key, read_value(tags[key])[0]
    if vehicle.trailer and "trailer" in tags:
        yield "trailer", read_value(tags["trailer"])[0]
    # A truck that is named itself may drive on a carriageway that is reserved for others.
    if own not in ("hgv_articulated", "hgv", "goods"):
        for key in RESERVED:
            if tags.get(key, "").strip().lower() in RESERVED_FOR[key]:
                yield key, Way.CLOSED


def _is_hazmat(key: str, code: str) -> bool:
    """Tell whether a key is about a load that a vehicle with a tunnel code may have."""
    head, _, kind = key.partition(":")
    if head != "hazmat" or kind.startswith("adr_tunnel"):
        return False
    # A letter is a category of tunnels; any other word or number is a kind of goods, which a
    # vehicle does not tell: each counts.
    return kind.upper() not in tuple("ABCDE") or kind.upper() >= code


def barrier_way(tags: Mapping[str, str]) -> Way:
    """Return what a barrier is to vehicles for which no access key decides.

    Parameters
    ----------
    tags : mapping of str to str
        Of a node.

    Returns
    -------
    Way
        Open where there is no barrier.
    """
    kind = tags.get("barrier", "").strip().lower()
    if tags.get(LOCKED, "").strip().lower() in ("yes", "true", "1"):
        return Way.CLOSED
    return BARRIERS.get(kind, Way.OPEN)
