"""A small Po valley and hand-made plans on it."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from plans_by_legs import plan_of, with_vehicles

from platoon_osm.costs.paper import paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import POINT_KINDS, NamedPoints, RoadNetwork
from platoon_osm.network.texts import encode_texts
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.records import Leg, NetworkIdentity, PlatoonPoint, Stop
from platoon_osm.plans.vehicles import VehiclePlan

JUNCTIONS = {
    "Torino": (7.75, 45.10), "Santhià": (8.17, 45.37), "Novara Est": (8.66, 45.47),
    "Rho-Pero": (9.06, 45.52), "Como": (9.05, 45.79), "Chiasso": (9.03, 45.84),
    "Bergamo": (9.67, 45.67), "Brescia Centro": (10.18, 45.51), "Verona Nord": (10.93, 45.44),
    "Vicenza Est": (11.60, 45.51), "Padova Est": (11.94, 45.43), "Mestre": (12.22, 45.50),
    "Treviso Sud": (12.24, 45.64), "Belluno": (12.26, 46.12), "Portogruaro": (12.83, 45.80),
    "Palmanova": (13.30, 45.91), "Udine Sud": (13.21, 46.02), "Tarvisio": (13.58, 46.50),
    "Trieste": (13.73, 45.68), "Rovereto": (11.03, 45.88), "Trento Sud": (11.11, 46.05),
    "Bolzano Sud": (11.33, 46.47), "Bressanone": (11.64, 46.71), "Brennero": (11.51, 47.00),
    "Genova Ovest": (8.89, 44.41), "Tortona": (8.87, 44.89), "Piacenza Sud": (9.71, 45.03),
    "Cremona": (10.03, 45.16), "Savona": (8.46, 44.32), "Alessandria": (8.64, 44.93),
    "Parma": (10.35, 44.85), "Modena Nord": (10.87, 44.66), "Bologna": (11.30, 44.51),
    "Ferrara": (11.58, 44.85), "Firenze": (11.17, 43.83), "La Spezia": (9.87, 44.12),
    "Rimini": (12.55, 44.03), "Milano Sud": (9.20, 45.39), "Imola": (11.73, 44.37),
    "Aosta": (7.35, 45.74), "Cuneo": (7.64, 44.45), "Ventimiglia": (7.62, 43.81),
}  # fmt: skip

ROADS = {
    "A4": ["Torino", "Santhià", "Novara Est", "Rho-Pero", "Bergamo", "Brescia Centro",
           "Verona Nord", "Vicenza Est", "Padova Est", "Mestre", "Portogruaro", "Palmanova",
           "Trieste"],
    "A9": ["Rho-Pero", "Como", "Chiasso"], "A27": ["Mestre", "Treviso Sud", "Belluno"],
    "A23": ["Palmanova", "Udine Sud", "Tarvisio"],
    "A22": ["Modena Nord", "Verona Nord", "Rovereto", "Trento Sud", "Bolzano Sud", "Bressanone",
            "Brennero"],
    "A7": ["Genova Ovest", "Tortona", "Milano Sud"],
    "A21": ["Torino", "Alessandria", "Tortona", "Piacenza Sud", "Cremona", "Brescia Centro"],
    "A1": ["Milano Sud", "Piacenza Sud", "Parma", "Modena Nord", "Bologna", "Firenze"],
    "A50": ["Rho-Pero", "Milano Sud"], "A13": ["Bologna", "Ferrara", "Padova Est"],
    "A14": ["Bologna", "Imola", "Rimini"], "A15": ["Parma", "La Spezia"],
    "A12": ["Genova Ovest", "La Spezia"], "A10": ["Genova Ovest", "Savona", "Ventimiglia"],
    "A6": ["Torino", "Cuneo", "Savona"], "A5": ["Santhià", "Aosta"],
    "A26": ["Novara Est", "Alessandria", "Genova Ovest"],
}  # fmt: skip

TOWNS = {
    "Torino": (7.686, 45.07, 860_000), "Milano": (9.19, 45.464, 1_370_000),
    "Genova": (8.934, 44.407, 560_000), "Bologna": (11.343, 44.494, 390_000),
    "Firenze": (11.256, 43.77, 370_000), "Venezia": (12.336, 45.437, 250_000),
    "Verona": (10.99, 45.438, 257_000), "Padova": (11.877, 45.407, 210_000),
    "Trieste": (13.777, 45.65, 204_000), "Brescia": (10.22, 45.54, 196_000),
    "Parma": (10.328, 44.80, 197_000), "Modena": (10.925, 44.647, 185_000),
    "Trento": (11.121, 46.067, 118_000), "Bolzano": (11.354, 46.498, 106_000),
    "Bergamo": (9.67, 45.695, 121_000), "Piacenza": (9.693, 45.052, 103_000),
    "Udine": (13.235, 46.063, 99_000), "Alessandria": (8.615, 44.913, 93_000),
    "Treviso": (12.245, 45.667, 84_000), "La Spezia": (9.82, 44.103, 93_000),
    "Rimini": (12.565, 44.06, 149_000), "Savona": (8.48, 44.309, 61_000),
    "Aosta": (7.32, 45.737, 34_000), "Novara": (8.622, 45.446, 104_000),
    "Cuneo": (7.547, 44.389, 56_000), "Belluno": (12.217, 46.138, 36_000),
}  # fmt: skip

NAMELESS = {"Imola": "52"}
"""Junctions that have no name but an exit number."""

Rename = Callable[[str], str]


def po_valley(rename: Rename = str, source: Source | None = None) -> RoadNetwork:
    """A schematic network with winding roads; `rename` may spoil every name in it."""
    names = list(JUNCTIONS)
    at = np.array([JUNCTIONS[name] for name in names])
    rng = np.random.default_rng(1)
    tail: list[int] = []
    head: list[int] = []
    refs: list[str] = []
    plain_refs: list[str] = []
    inferred: list[bool] = []
    shapes: list[np.ndarray] = []
    for ref, stops in ROADS.items():
        for a, b in pairwise(stops):
            i, j = names.index(a), names.index(b)
            k = max(4, int(np.hypot(*(at[j] - at[i])) / 0.03))
            share = np.linspace(0, 1, k)[:, None]
            bend = rng.normal(0, 0.014, (k, 2)).cumsum(axis=0)
            bend -= share * bend[-1]
            bend[0] = bend[-1] = 0
            shape = at[i] + share * (at[j] - at[i]) + bend * 0.8
            for ends, points in (((i, j), shape), ((j, i), shape[::-1])):
                tail.append(ends[0])
                head.append(ends[1])
                refs.append(rename(ref))
                plain_refs.append(ref)
                inferred.append((a, b) == ("Piacenza Sud", "Cremona"))
                shapes.append(points)
    first = np.concatenate([[0], np.cumsum([len(shape) for shape in shapes])])
    flat = np.vstack(shapes)
    node_names = ["" if name in NAMELESS else rename(name) for name in names]
    exits = [rename(NAMELESS.get(name, str(number))) for number, name in enumerate(names, 1)]
    road_names = [rename(f"Autostrada {ref}") for ref in plain_refs]
    town_names = [rename(name) for name in TOWNS]
    texts, (node_codes, exit_codes, ref_codes, name_codes, town_codes) = encode_texts(
        node_names, exits, refs, road_names, town_names
    )
    city, town = POINT_KINDS.index("city"), POINT_KINDS.index("town")
    points = NamedPoints(
        np.array([lon for lon, _, _ in TOWNS.values()]),
        np.array([lat for _, lat, _ in TOWNS.values()]),
        np.array([city if p > 100_000 else town for *_, p in TOWNS.values()], np.uint8),
        town_codes,
        np.array([people for *_, people in TOWNS.values()], np.int64),
    )
    return RoadNetwork.from_edges(
        tail, head, lon=at[:, 0], lat=at[:, 1], node_name=node_codes, ref=ref_codes,
        node_ref=exit_codes, name=name_codes,
        inferred=inferred, shape_first=first, shape_lon=flat[:, 0], shape_lat=flat[:, 1],
        texts=texts, points=points,
        source=source or Source(
            "po-valley.osm", "3f9c" * 15 + "77a1", "2026-01-15T00:00:00Z", "CC0",
            "Made by hand for tests",
        ),
    )  # fmt: skip


def route(net: RoadNetwork, origin: int, destination: int) -> tuple[int, ...]:
    """Shortest path, as edge ids."""
    best: dict[int, tuple[float, int]] = {origin: (0.0, -1)}
    queue = [(0.0, origin)]
    while queue:
        far, node = heapq.heappop(queue)
        if node == destination or far > best[node][0]:
            continue
        for edge in range(net.first_out[node], net.first_out[node + 1]):
            reach, to = far + float(net.length_m[edge]), int(net.head[edge])
            if reach < best.get(to, (np.inf, -1))[0]:
                best[to] = (reach, edge)
                heapq.heappush(queue, (reach, to))
    edges: list[int] = []
    node = destination
    while node != origin:
        edges.append(best[node][1])
        node = int(net.tail[edges[-1]])
    return tuple(reversed(edges))


def leg(
    net: RoadNetwork, weights: EdgeWeights, edges: Sequence[int], partners: Sequence[str] = ()
) -> Leg:
    ids = np.asarray(edges, np.int64)
    length = float(net.length_m[ids].sum())
    cost = weights.platoon if partners else weights.solo
    return Leg(
        role="platoon" if partners else "solo",
        edges=tuple(int(e) for e in ids),
        partners=tuple(partners),
        length_m=length,
        time_s=length / 22.2,
        fuel_l=length * 0.00032 * (0.82 if partners else 1.0),
        cost=float(cost[ids].sum()),
        inferred_m=float(net.length_m[ids][net.inferred[ids]].sum()),
    )


Journey = tuple[str, str, str, str | None, str | None]


def make_plan(
    net: RoadNetwork,
    journeys: Sequence[Journey],
    rename: Rename = str,
    **changes: Any,
) -> Plan:
    """A plan from (vehicle, from, to, merge, separation); the first vehicle is the master."""
    weights = paper_weights(net, tau=1.0, xi=0.18, speed_kmh=80.0)
    place = list(JUNCTIONS).index
    master_path = route(net, place(journeys[0][1]), place(journeys[0][2]))
    master_nodes = [int(v) for v in net.path_nodes(master_path)]
    shared: dict[str, tuple[int, ...]] = {}
    for name, _, _, merge, split in journeys[1:]:
        if merge and split:
            i, j = master_nodes.index(place(merge)), master_nodes.index(place(split))
            shared[name] = master_path[i:j]

    def platoon_legs(name: str, edges: Sequence[int]) -> list[Leg]:
        """Cut a stretch where the company changes."""
        legs: list[tuple[list[int], tuple[str, ...]]] = []
        for edge in edges:
            company = tuple(
                rename(other)
                for other in [journeys[0][0], *shared]
                if other != name
                and (other == journeys[0][0] or edge in shared[other])
                and (name != journeys[0][0] or edge in shared[other])
            )
            if legs and legs[-1][1] == company:
                legs[-1][0].append(edge)
            else:
                legs.append(([edge], company))
        return [leg(net, weights, part, company) for part, company in legs]

    def stop(name: str) -> Stop:
        node = place(name)
        return Stop(node, float(net.lon[node]), float(net.lat[node]), rename(name.split()[0]))

    def point(node: int, before: Sequence[int]) -> PlatoonPoint:
        km = float(net.length_m[np.asarray(before, np.int64)].sum()) / 1000
        at = float(net.lon[node]), float(net.lat[node])
        return PlatoonPoint(node, node, *at, net.place_name(node), km)

    vehicles = []
    for rank, (name, origin, destination, merge, split) in enumerate(journeys):
        alone = route(net, place(origin), place(destination))
        common: dict[str, Any] = {
            "vehicle": rename(name), "origin": stop(origin), "destination": stop(destination),
            "alone": leg(net, weights, alone),
        }  # fmt: skip
        if rank == 0:
            vehicles.append(
                VehiclePlan(role="master", legs=tuple(platoon_legs(name, alone)), **common)
            )
        elif merge and split:
            before = route(net, place(origin), place(merge))
            after = route(net, place(split), place(destination))
            legs = [*platoon_legs(name, shared[name])]
            if before:
                legs.insert(0, leg(net, weights, before))
            if after:
                legs.append(leg(net, weights, after))
            vehicles.append(
                VehiclePlan(
                    role="member",
                    legs=tuple(legs),
                    merge=point(place(merge), before),
                    separation=point(place(split), (*before, *shared[name])),
                    **common,
                )
            )
        else:
            vehicles.append(
                VehiclePlan(
                    role="alone",
                    legs=(leg(net, weights, alone),),
                    reason=rename("no way of joining the master costs less than driving alone"),
                    **common,
                )
            )
    source = net.source
    values: dict[str, Any] = {
        "case": "C", "asked": "best", "objective": "member",
        "method": "dijkstra", "unit": "m", "params": dict(weights.params),
        "network": NetworkIdentity(
            source.name, source.sha256, source.extracted, source.licence, source.attribution,
            net.n, net.m, net.identity(),
        ),
        "conditions": ("waiting is free", "vehicles are alike"), "version": "0.1.0",
    }  # fmt: skip
    return plan_of(vehicles, **{**values, **changes})


THREE: list[Journey] = [
    ("A", "Torino", "Trieste", None, None),
    ("B", "Genova Ovest", "Belluno", "Brescia Centro", "Mestre"),
    ("C", "Chiasso", "Brennero", "Rho-Pero", "Verona Nord"),
]


def fifty() -> list[Journey]:
    """Journeys of fifty vehicles, some of them alone."""
    ways = [
        ("Genova Ovest", "Belluno", "Brescia Centro", "Mestre"),
        ("Chiasso", "Brennero", "Rho-Pero", "Verona Nord"),
        ("Bologna", "Tarvisio", "Padova Est", "Palmanova"),
        ("Cuneo", "Ferrara", "Torino", "Padova Est"),
        ("Parma", "La Spezia", None, None),
        ("Aosta", "Udine Sud", "Santhià", "Palmanova"),
        ("Rimini", "Bolzano Sud", None, None),
    ]  # fmt: skip
    journeys: list[Journey] = [("Truck 1", "Torino", "Trieste", None, None)]
    journeys += [(f"Truck {i + 2}", *ways[i % len(ways)]) for i in range(49)]
    return journeys


TWO_PLATOONS: list[list[Journey]] = [
    THREE,
    [
        ("D", "Aosta", "Udine Sud", None, None),
        ("E", "Savona", "Portogruaro", "Rho-Pero", "Portogruaro"),
        ("F", "Como", "Padova Est", "Rho-Pero", "Padova Est"),
        ("G", "Parma", "La Spezia", None, None),
    ],
]


def two_platoons(net: RoadNetwork, rename: Rename = str) -> Plan:
    """Two platoons that share much of their road, and a vehicle alone."""
    first, second = (make_plan(net, journeys, rename) for journeys in TWO_PLATOONS)
    return with_vehicles(first, (*first.vehicles, *second.vehicles))
