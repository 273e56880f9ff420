"""Plans of every kind a page has to bear, by name: made once, from networks that are made once.

`KINDS` names them all, `plan_kind(name)` makes one; `QUICK` are those that stand for the others
where every one costs a browser's time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timedelta
from functools import cache

import numpy as np
from bundled import italy
from california import california, tall_country
from plans_by_legs import with_vehicles
from po_valley import JUNCTIONS, THREE, Journey, fifty, make_plan, po_valley, route, two_platoons

from platoon_osm.costs.paper import PaperCosts
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.joint import plan_joint
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.trip import Trip

SIX = datetime(2026, 3, 2, 6)
COSTS = PaperCosts(tau=1.0, xi=0.18)

Made = tuple[Plan, RoadNetwork]
MAKERS: dict[str, Callable[[], Made]] = {}


def kind(make: Callable[[], Made]) -> Callable[[], Made]:
    """Enter a maker under its name, with words for underscores."""
    MAKERS[make.__name__.replace("_", " ")] = make
    return make


@cache
def plan_kind(name: str) -> Made:
    """Return a plan of a kind, and its network."""
    return MAKERS[name]()


@cache
def valley() -> RoadNetwork:
    return po_valley()


def hours(number: float) -> timedelta:
    return timedelta(hours=number)


def timed(
    plan: Plan,
    start: datetime = SIX,
    apart: float = 0.25,
    within: Callable[[int], float] | None = None,
) -> Plan:
    """Give a plan times: vehicles leave one after another, `within` some hours if it says so."""
    trips = []
    for k, vehicle in enumerate(plan.vehicles):
        first = start + hours(apart * (k % 12))
        latest = None if within is None else first + hours(within(k))
        trips.append(Trip(vehicle.vehicle, 0, 1, first, None, latest))
    return with_times(plan, trips)  # fmt: skip


def valley_plan(journeys: Sequence[Journey]) -> Plan:
    return make_plan(valley(), journeys)


# -- how many ------------------------------------------------------------------------------------


@kind
def one_vehicle() -> Made:
    return timed(valley_plan(THREE[:1])), valley()


@kind
def two_vehicles() -> Made:
    return timed(valley_plan(THREE[:2])), valley()


@kind
def three_vehicles() -> Made:
    return timed(valley_plan(THREE), within=lambda _: 12), valley()


@kind
def eight_vehicles() -> Made:
    return timed(valley_plan(fifty()[:8])), valley()


@kind
def twenty_vehicles() -> Made:
    return timed(_crowd(20)), valley()


@kind
def fifty_vehicles() -> Made:
    return timed(_crowd(50)), valley()


@kind
def five_hundred_vehicles() -> Made:
    return timed(_crowd(500)), valley()


@kind
def one_platoon_of_fifty() -> Made:
    return valley_plan(fifty()), valley()


@kind
def two_platoons_on_one_road() -> Made:
    return two_platoons(valley()), valley()


def _crowd(count: int) -> Plan:
    """Vehicles drawn at random, six in ten of them in platoons of two to five."""
    draw = np.random.default_rng(count)
    names = [f"Truck {k + 1}" for k in range(count)]
    groups = []
    while names:
        size = min(int(draw.choice([1, 1, 1, 1, 2, 3, 4, 5])), len(names))
        mine, names = names[:size], names[size:]
        groups.append(valley_plan(_journeys(mine, draw)))
    every = [vehicle for group in groups for vehicle in group.vehicles]
    return with_vehicles(groups[0], every)


def _journeys(names: Sequence[str], draw: np.random.Generator) -> list[Journey]:
    """A master's journey of at least four roads, and members who drive a part of it."""
    places = list(JUNCTIONS)
    while True:
        start, end = (int(node) for node in draw.choice(len(places), 2, replace=False))
        way = [places[int(v)] for v in valley().path_nodes(route(valley(), start, end))]
        if len(way) > (4 if len(names) > 1 else 2):
            break
    journeys: list[Journey] = [(names[0], way[0], way[-1], None, None)]
    for name in names[1:]:
        while True:
            merge, split = sorted(int(i) for i in draw.choice(len(way), 2, replace=False))
            ends = [str(place) for place in draw.choice(places, 2, replace=False)]
            start_at = way[merge] if draw.random() < 0.3 else ends[0]
            end_at = way[split] if draw.random() < 0.3 else ends[1]
            joint = _metres(start_at, way[merge]) + _metres(way[split], end_at)
            shared = _metres(way[merge], way[split])
            if joint + 0.9 * shared < _metres(start_at, end_at):
                break
        journeys.append((name, start_at, end_at, way[merge], way[split]))
    return journeys


@cache
def _metres(start: str, end: str) -> float:
    net, place = valley(), list(JUNCTIONS).index
    return sum(float(net.length_m[edge]) for edge in route(net, place(start), place(end)))


# -- when ----------------------------------------------------------------------------------------


@kind
def without_times() -> Made:
    return valley_plan(THREE), valley()


@kind
def one_is_late() -> Made:
    within = [12, 3.5, 12]
    return timed(valley_plan(THREE), within=lambda k: within[k]), valley()


@kind
def late_in_company() -> Made:
    """Every one could be in time alone; those who wait for the others are late."""
    plan = valley_plan(THREE)
    alone = [vehicle.alone.time_s / 3600 for vehicle in plan.vehicles]
    return timed(plan, apart=2, within=lambda k: alone[k] + 0.2), valley()


@kind
def all_are_late() -> Made:
    """Some even alone, some for the company."""
    return timed(valley_plan(THREE), within=lambda _: 1.5), valley()


@kind
def late_even_alone() -> Made:
    journeys: list[Journey] = [(name, start, end, None, None) for name, start, end, *_ in THREE]
    return timed(valley_plan(journeys), within=lambda _: 1.5), valley()


@kind
def over_several_days() -> Made:
    """Who meets has left a day and a half apart; the last arrives on the third day."""
    return timed(valley_plan(THREE), start=SIX + hours(14), apart=19), valley()


# -- with whom -----------------------------------------------------------------------------------


@kind
def all_alone() -> Made:
    journeys: list[Journey] = [(name, start, end, None, None) for name, start, end, *_ in THREE]
    return timed(valley_plan(journeys)), valley()


@kind
def opposite_directions() -> Made:
    west: list[Journey] = [
        ("D", "Trieste", "Torino", None, None),
        ("E", "Udine Sud", "Bergamo", "Palmanova", "Bergamo"),
        ("F", "Belluno", "Savona", "Mestre", "Rho-Pero"),
    ]
    east, other = valley_plan(THREE), valley_plan(west)
    return with_vehicles(east, (*east.vehicles, *other.vehicles)), valley()


@kind
def all_end_together() -> Made:
    journeys: list[Journey] = [
        ("A", "Torino", "Trieste", None, None),
        ("B", "Genova Ovest", "Trieste", "Brescia Centro", "Trieste"),
        ("C", "Chiasso", "Trieste", "Rho-Pero", "Trieste"),
    ]
    return timed(valley_plan(journeys)), valley()


@kind
def all_start_together() -> Made:
    journeys: list[Journey] = [
        ("A", "Torino", "Trieste", None, None),
        ("B", "Torino", "Belluno", "Torino", "Mestre"),
        ("C", "Torino", "Brennero", "Torino", "Verona Nord"),
    ]
    return timed(valley_plan(journeys)), valley()


@kind
def the_same_trip_thrice() -> Made:
    journeys: list[Journey] = [("A", "Torino", "Trieste", None, None)]
    journeys += [(name, "Torino", "Trieste", "Torino", "Trieste") for name in "BC"]
    return timed(valley_plan(journeys)), valley()


# -- where ---------------------------------------------------------------------------------------


@kind
def a_tall_country() -> Made:
    """As California, of three vehicles between San Francisco and Los Angeles."""
    net = tall_country()
    trips = [
        Trip("A", "San Francisco", "Los Angeles", SIX, None, SIX + hours(14)),
        Trip("B", "Sacramento", "Los Angeles", SIX),
        Trip("C", "Redding", "Bakersfield", SIX - hours(2)),
    ]
    return plan_joint(net, COSTS, trips, "C"), net


@kind
def real_california() -> Made:
    """The real motorways; the tall country where they are not at hand."""
    net = california()
    if net is None:
        return plan_kind("a tall country")
    trips = [
        Trip("A", (-122.41, 37.775), (-118.243, 34.052), SIX),
        Trip("B", (-121.494, 38.58), (-118.243, 34.052), SIX),
        Trip("C", (-122.27, 37.8), (-117.16, 32.715), SIX),
    ]
    return plan_joint(net, COSTS, trips, "C"), net


@kind
def a_wide_country() -> Made:
    """Straight from west to east, and hardly taller than its marks."""
    journeys: list[Journey] = [
        ("A", "Torino", "Trieste", None, None),
        ("B", "Novara Est", "Portogruaro", "Novara Est", "Portogruaro"),
    ]
    return timed(valley_plan(journeys)), valley()


@kind
def a_short_trip() -> Made:
    return timed(valley_plan([("A", "Como", "Chiasso", None, None)])), valley()


@kind
def beside_the_road() -> Made:
    net = italy()
    trips = [
        Trip("A", "Torino", "Trieste"),
        Trip("B", (8.774, 45.472), "Padova Est"),
        Trip("C", (10.27, 45.46), (12.05, 45.437)),
        Trip("D", (12.05, 45.437), (10.27, 45.46)),
    ]
    return plan_joint(net, COSTS, trips, "C", master="A"), net


@kind
def the_real_map() -> Made:
    net = italy()
    trips = [
        Trip("A", "Torino", "Trieste", SIX, None, SIX + hours(8)),
        Trip("B", "Genova", "Belluno", SIX),
        Trip("C", "Milano", "Bolzano", SIX),
        Trip("D", "Napoli", "Torino", SIX),
    ]
    return plan_joint(net, COSTS, trips, "C"), net


# -- in which words ------------------------------------------------------------------------------

LONG = "Cold chain forwarding, Rotterdam to Thessaloniki by way of everywhere, no. "
RTL = "\u0634\u0627\u062d\u0646\u0629 \u0627\u0644\u0634\u0645\u0627\u0644 "
CJK = "\u5317\u6d77\u9053\u904b\u8f38\u682a\u5f0f\u4f1a\u793e"


@kind
def long_names() -> Made:
    more = ", Autostazione e Centro Intermodale Interporto"
    return _renamed(lambda name: f"{LONG}{name}" if len(name) < 3 else name + more)


@kind
def names_in_other_scripts() -> Made:
    def foreign(name: str) -> str:
        return f"{RTL}{name}" if len(name) % 2 else f"{CJK} {name}"

    return _renamed(foreign)


@kind
def names_without_a_break() -> Made:
    return _renamed(lambda name: name.replace(" ", "") + "x" * 60)


def _renamed(rename: Callable[[str], str]) -> Made:
    net = po_valley(rename)
    return timed(make_plan(net, THREE, rename)), net


@kind
def large_sums() -> Made:
    """Six digits in a unit that is none of ours."""
    return timed(make_plan(valley(), THREE, unit="JPY")), valley()


@kind
def euros_by_the_million() -> Made:
    return timed(make_plan(valley(), fifty()[:8], unit="EUR")), valley()


KINDS = tuple(MAKERS)

QUICK = (
    "one vehicle", "three vehicles", "eight vehicles", "fifty vehicles", "all are late",
    "over several days", "all alone", "opposite directions", "all end together", "a tall country",
    "long names",
)  # fmt: skip
