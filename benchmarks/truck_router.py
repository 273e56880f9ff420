"""Whether another truck router takes the same roads: Valhalla's truck costing beside ours.

Two comparisons, both of shortest ways, since speeds and preferences differ by taste and access does
not. First a road and its detour, once for each tag: which of the two does a truck take? Then random
pairs of places on two true extracts: is the shortest way equally long?

Run with `python -m benchmarks.truck_router`. It needs the package `pyvalhalla` (3.9 was measured,
for Python 3.12 or later), whose programs build the tiles, and reads ../shared/data/osm. It writes
its tables to docs/tags.md.
"""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from benchmarks.access import EVERY, FOLDER, PAGE
from benchmarks.sections import markdown_table, write_section

Tags = dict[str, str]

OPEN_ROAD = {"highway": "primary"}
FORWARD, BACKWARD = "along", "against"
STEP_DEG = 0.02
SIDE_DEG = 0.002
COLUMNS = 20
ORIGIN = (10.0, 51.0)
PAIRS = 400
SEED = 13

TAGS: tuple[Tags, ...] = (
    {},
    *({"maxheight": v} for v in ("3.5", "3.5 m", "4.2", "11'6\"", "350 cm", "3,5", "default")),
    *({"maxweight": v} for v in ("7.5", "7,5 t", "7500 kg", "44", "10 st", "none")),
    *({key: "3.5"} for key in ("maxweight:hgv", "maxweightrating", "maxgcweight")),
    *({"maxaxleload": v} for v in ("8", "13")),
    *({"maxlength": v} for v in ("12", "18.75")),
    *({"maxwidth": v} for v in ("2.3", "3")),
    {"maxheight:forward": "3.5"},
    {"maxwidth:physical": "2.3"},
    *({"hgv": v} for v in ("no", "yes", "designated", "destination", "delivery", "discouraged")),
    *({"hgv": v} for v in ("agricultural", "private", "local", "unsuitable", "no;destination")),
    *({key: "no"} for key in ("goods", "motor_vehicle", "vehicle", "access", "motorcar")),
    *({"access": v} for v in ("private", "destination", "customers", "permit", "forestry")),
    {"access": "no", "hgv": "yes"},
    {"motor_vehicle": "no", "hgv": "designated"},
    {"hgv": "no", "hgv:forward": "yes"},
    {"hgv:forward": "no"},
    {"hgv:backward": "no"},
    {"oneway": "-1"},
    {"oneway": "yes"},
    {"oneway:hgv": "yes"},
    {"oneway": "yes", "oneway:hgv": "no"},
    {"oneway": "reversible"},
    {"junction": "roundabout"},
    {"hov": "designated"},
    {"hgv:conditional": "no @ (weight>7.5)"},
    {"hgv:conditional": "no @ (Mo-Su 00:00-24:00)"},
    {"hgv": "no", "hgv:conditional": "yes @ (length<20)"},
    {"trailer": "no"},
    {"hazmat": "no"},
)
"""What the road in question carries besides `highway=primary`."""

NODE_TAGS: tuple[Tags, ...] = (
    *({"barrier": v} for v in ("gate", "bollard", "toll_booth", "block", "lift_gate")),
    {"barrier": "gate", "access": "no"},
    {"barrier": "gate", "access": "private"},
    {"barrier": "bollard", "hgv": "yes"},
    {"barrier": "height_restrictor", "maxheight": "2.5"},
    {"barrier": "border_control"},
)
"""What a node in the middle of it carries instead."""

TURNS: tuple[Tags, ...] = (
    {"restriction": "no_straight_on"},
    {"restriction:hgv": "no_straight_on"},
    {"restriction": "no_straight_on", "except": "hgv"},
    {"restriction": "no_straight_on", "except": "psv"},
    {"restriction:conditional": "no_straight_on @ (weight>7.5)"},
    {"restriction:bus": "no_straight_on"},
)
"""What forbids the way onto it."""


@dataclass(frozen=True)
class Detour:
    """One road with a longer way around it; the road's two ends lie on open stubs."""

    number: int
    way: Tags
    node: Tags
    turn: Tags

    def positions(self) -> list[tuple[float, float]]:
        """Return lon and lat of: stub, fork, middle, join, stub, and the detour's corner."""
        row, column = divmod(self.number, COLUMNS)
        lon, lat = ORIGIN[0] + column * STEP_DEG, ORIGIN[1] + row * STEP_DEG
        line = [(lon + k * SIDE_DEG, lat) for k in range(5)]
        return [*line, (lon + 2 * SIDE_DEG, lat + 2 * SIDE_DEG)]

    def elements(self) -> Iterator[str]:
        """Return it as OSM XML, nodes first."""
        first = self.number * 10 + 1
        for k, (lon, lat) in enumerate(self.positions()):
            yield _element(
                "node", first + k, self.node if k == 2 else {}, f"lon='{lon}' lat='{lat}'"
            )
        for k, (nodes, tags) in enumerate(
            (
                ((0, 1), OPEN_ROAD),
                ((1, 2, 3), {**OPEN_ROAD, **self.way}),
                ((3, 4), OPEN_ROAD),
                ((1, 5, 3), OPEN_ROAD),
            )
        ):
            refs = "".join(f"<nd ref='{first + node}'/>" for node in nodes)
            yield _element("way", first + k, tags, "", refs)
        if self.turn:
            members = "".join(
                f"<member type='{kind}' ref='{first + ref}' role='{role}'/>"
                for kind, ref, role in (("way", 0, "from"), ("node", 1, "via"), ("way", 1, "to"))
            )
            yield _element("relation", first, {"type": "restriction", **self.turn}, "", members)

    def told(self) -> str:
        """Return its tags in words."""
        tags = self.way or self.node or self.turn
        return " ".join(f"{key}={value}" for key, value in tags.items()) or "no tag"


def _element(kind: str, number: int, tags: Tags, more: str, inside: str = "") -> str:
    told = "".join(f"<tag k={quoteattr(k)} v={quoteattr(v)}/>" for k, v in tags.items())
    return f"<{kind} id='{number}' version='1' {more}>{inside}{told}</{kind}>"


def detours() -> list[Detour]:
    """Return one for each combination of tags."""
    each = [
        *((tags, {}, {}) for tags in TAGS),
        *(({}, tags, {}) for tags in NODE_TAGS),
        *(({}, {}, tags) for tags in TURNS),
    ]
    return [Detour(number, *tags) for number, tags in enumerate(each)]


def write_detours(path: Path) -> None:
    """Write all of them as one map."""
    elements = [element for one in detours() for element in one.elements()]
    elements.sort(key=lambda text: ("<node", "<way ", "<rela").index(text[:5]))
    path.write_text(f"<osm version='0.6'>{''.join(elements)}</osm>", encoding="utf-8")


class Other:
    """Valhalla, with tiles of one extract."""

    def __init__(self, extract: Path, folder: Path) -> None:
        import osmium
        import valhalla
        from valhalla.config import get_config

        tiles = folder / "tiles"
        tiles.mkdir(parents=True)
        config: dict[str, Any] = get_config(tile_dir=tiles, tile_extract="", verbose=False)
        config["mjolnir"].update(tile_extract="", admin="", timezone="", traffic_extract="")
        pbf, written = folder / "map.osm.pbf", folder / "valhalla.json"
        _as_pbf(extract, pbf)
        written.write_text(json.dumps(config), encoding="utf-8")
        build = Path(valhalla.__file__).parent / "bin" / "valhalla_build_tiles"
        subprocess.run([build, "-c", written, pbf], check=True, capture_output=True)
        self._actor = valhalla.Actor(str(written))
        self.version: str = valhalla.__version__

        self._tags = {
            way.id: dict(way.tags) for way in osmium.FileProcessor(str(pbf), osmium.osm.WAY)
        }

    def shortest_m(self, places: Sequence[tuple[float, float]], truck: dict[str, Any]) -> float:
        """Return the length of the shortest way between two places, inf if there is none."""
        try:
            answer = self._actor.route(_asked(places, truck))
        except RuntimeError:
            return float("inf")
        return float(answer["trip"]["summary"]["length"]) * 1000

    def passes(self, places: Sequence[tuple[float, float]], truck: dict[str, Any]) -> list[str]:
        """Return the restrictions that the map has on that way."""
        (leg,) = self._actor.route(_asked(places, truck))["trip"]["legs"]
        traced = self._actor.trace_attributes(
            {
                "encoded_polyline": leg["shape"],
                "shape_match": "walk_or_snap",
                "costing": "truck",
                "costing_options": {"truck": truck},
                "filters": {"attributes": ["edge.way_id"], "action": "include"},
            }
        )
        ways = dict.fromkeys(edge["way_id"] for edge in traced["edges"])
        restrictions = (
            f"{key}={value}"
            for way in ways
            for key, value in self._tags[way].items()
            if (key.startswith("max") and key != "maxspeed") or key in ("access", "hgv")
        )
        return list(dict.fromkeys(restrictions))


def _asked(places: Sequence[tuple[float, float]], truck: dict[str, Any]) -> dict[str, Any]:
    return {
        "locations": [{"lon": lon, "lat": lat} for lon, lat in places],
        "costing": "truck",
        "costing_options": {"truck": truck},
        "directions_type": "none",
    }


def _as_pbf(extract: Path, path: Path) -> None:
    import osmium

    with osmium.SimpleWriter(str(path), overwrite=True) as writer:
        for element in osmium.FileProcessor(str(extract)):
            writer.add(element)


class Ours:
    """The roads that are open to a vehicle, and the shortest ways on them."""

    def __init__(self, extract: Path, vehicle: str, classes: Sequence[str]) -> None:
        from platoon_osm.sources.load import load_network
        from platoon_osm.vehicles.closures import Closures
        from platoon_osm.vehicles.profile import VEHICLES

        self.vehicle = VEHICLES[vehicle]
        self.net = load_network(extract, classes)
        judged = self.net.attached(Closures).of(self.vehicle)
        self.open = ~(judged.closed | judged.ends)
        self.weight = np.where(self.open, self.net.length_m, np.inf)
        nodes: dict[int, list[int]] = {}
        for node, osm in enumerate(self.net.node_id.tolist()):
            nodes.setdefault(osm, []).append(node)
        self.nodes = nodes

    def shortest_m(self, origin: int, destination: int) -> float:
        """Return the length of the shortest way between two nodes of the map, inf if none."""
        from platoon_osm.search.engine import many_to_many

        costs = many_to_many(
            self.net, self.weight, self.nodes[origin], self.nodes[destination], engine="reference"
        )
        return float(np.min(costs))

    def connected(self) -> NDArray[np.int64]:
        """Return the nodes of the largest part of the open roads in which each reaches each.

        From elsewhere the other router moves to a road near by, which is another question.
        """
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import connected_components

        tail, head = self.net.tail[self.open], self.net.head[self.open]
        links = csr_array((np.ones(len(tail)), (tail, head)), shape=(self.net.n, self.net.n))
        _, part = connected_components(links, connection="strong")
        return np.flatnonzero(part == np.bincount(part).argmax())

    def truck(self) -> dict[str, Any]:
        """Return the vehicle as Valhalla wants it told."""
        one = self.vehicle
        return {
            "shortest": True,
            "height": one.height_m,
            "width": one.width_m,
            "length": one.length_m,
            "weight": one.mass_t,
            "axle_load": one.axle_load_t,
            "hazmat": bool(one.tunnel_code),
        }


def by_tag(folder: Path) -> tuple[str, list[list[str]], int, int]:
    """Return the other's version, rows of what differs, how many were asked, how many differ."""
    extract = folder / "detours.osm"
    write_detours(extract)
    ours, other = Ours(extract, "eu-40t", ["primary"]), Other(extract, folder / "detours")
    differ: dict[str, dict[str, tuple[str, str]]] = {}
    asked = 0
    for one, way in itertools.product(detours(), (FORWARD, BACKWARD)):
        if way == BACKWARD and one.turn:
            continue
        first = one.number * 10 + 1
        ends = [(first, 0), (first + 4, 4)]
        if way == BACKWARD:
            ends.reverse()
        places = [one.positions()[k] for _, k in ends]
        limit_m = _straight_m(places) * 1.02
        mine = ours.shortest_m(ends[0][0], ends[1][0]) < limit_m
        its = other.shortest_m(places, ours.truck()) < limit_m
        asked += 1
        if mine != its:
            words = ("takes it", "goes around")
            differ.setdefault(one.told(), {})[way] = (words[not mine], words[not its])
    rows = []
    for told, ways in differ.items():
        # One row where both directions are alike.
        if len(ways) == 2 and len(set(ways.values())) == 1:
            ways = {"both": ways[FORWARD]}
        rows += [[f"`{told}`", way, *answers] for way, answers in ways.items()]
    return other.version, rows, asked, sum(map(len, differ.values()))


def _straight_m(places: Sequence[tuple[float, float]]) -> float:
    from platoon_osm.network.geodesy import distance_m

    (lon, lat), (to_lon, to_lat) = places
    return float(distance_m(lon, lat, to_lon, to_lat))


def on_extract(name: str, vehicle: str, folder: Path) -> list[str]:
    """Return a row of the second table: how many of random pairs are equally long."""
    ours = Ours(FOLDER / name, vehicle, [*EVERY, *SMALL])
    other = Other(FOLDER / name, folder / name)
    net, generator = ours.net, np.random.default_rng(SEED)
    nodes = ours.connected()
    counts = {"equal": 0, "ours longer": 0, "ours shorter": 0, "only ours": 0, "only its": 0}
    none, passed = 0, []
    for origin, destination in generator.choice(nodes, (PAIRS, 2)).tolist():
        places = [(float(net.lon[k]), float(net.lat[k])) for k in (origin, destination)]
        mine = ours.shortest_m(int(net.node_id[origin]), int(net.node_id[destination]))
        its = other.shortest_m(places, ours.truck())
        if np.isinf(mine) and np.isinf(its):
            none += 1
        elif np.isinf(mine) or np.isinf(its):
            counts["only its" if np.isinf(mine) else "only ours"] += 1
        elif abs(mine - its) <= max(0.01 * its, 30.0):
            counts["equal"] += 1
        else:
            counts["ours longer" if mine > its else "ours shorter"] += 1
            passed.append(", ".join(other.passes(places, ours.truck())) or "no restriction")
            print(name, places, f"{mine:.0f} {its:.0f}", passed[-1], file=sys.stderr)
    return [
        name,
        vehicle,
        f"{PAIRS - none}",
        *(str(count) for count in counts.values()),
        "; ".join(passed),
    ]


SMALL = ["unclassified", "residential", "living_street", "service", "road", "track"]
EXTRACTS = (("harrisburg.osm.pbf", "us-80k-lb"), ("north-bayreuth.osm.gz", "eu-40t"))


def main() -> None:
    """Write both tables."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        version, rows, asked, differ = by_tag(folder)
        first = markdown_table(["tag", "direction", "here", f"Valhalla {version}"], rows)
        header = ["extract", "vehicle", "pairs", "equal", "ours longer", "ours shorter"]
        table = [on_extract(*one, folder) for one in EXTRACTS]
        second = markdown_table([*header, "only ours", "only its", "its way there passes"], table)
    told = f"{asked - differ} of {asked} answers are the same. These differ:"
    text = f"{told}\n\n{first}\n\n{second}"
    print(text)
    write_section("router", text, PAGE)


if __name__ == "__main__":
    main()
