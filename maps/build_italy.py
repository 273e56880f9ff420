"""Build the bundled map of the Italian motorways from the tables in maps/italy/.

    python maps/build_italy.py            # writes maps/italy-motorways.osm
    python maps/build_italy.py --check    # prints lengths and doubtful sections, writes nothing
    python maps/build_italy.py --towns    # prints how far exits lie from the towns of their names
    python maps/build_italy.py --waypoints FOLDER  # the same from Travel Mapping's list of exits

The tables give the interchanges, exits and ends of every motorway with kilometre post and
position (format: maps/README.md). This script draws a smooth line through the positions, makes
two one-way carriageways of it, adds the links, and writes OSM XML. The same tables always give
the same bytes.
"""

from __future__ import annotations

import argparse
import csv
import math
import re
import sys
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations, pairwise, permutations
from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

import numpy as np
import numpy.typing as npt
from italy_towns import Exit, compare
from italy_waypoints import compare_waypoints

HERE = Path(__file__).resolve().parent
TABLES = HERE / "italy"
OUTPUT = HERE / "italy-motorways.osm"

STOP_KINDS = ("end", "junction", "interchange")  # the line passes, vehicles leave or enter
POINT_KINDS = ("service", "rest")  # placed beside the line by their km, without a position
KINDS = (*STOP_KINDS, *POINT_KINDS, "shape", "break")
ROW_COLUMNS = ("km", "kind", "name", "ref", "lat", "lon")
MOTORWAY_COLUMNS = ("ref", "name", "official_km", "toll", "maxspeed", "source")
PLACE_COLUMNS = ("name", "kind", "lat", "lon", "population")
FERRY_COLUMNS = ("name", "minutes", "motorway", "exit", "lat", "lon", "source")
PARKING_COLUMNS = ("motorway", "km", "name", "spaces", "source")
REF = re.compile(r"(A|D|R|RA)([0-9]{1,3})")  # autostrada, diramazione, raccordi
REF_BASE = {"A": 0, "D": 500, "R": 600, "RA": 700}  # for the ids
ITALY = (35.0, 47.5, 6.0, 19.0)  # south, north, west, east

CARRIAGEWAY_OFFSET = 12.0  # m from the centreline to the middle of a carriageway
GATE_OFFSET = 200.0  # m from the centreline to the node where an exit meets other roads
SERVICE_OFFSET = 80.0  # m from the centreline to a service area on one side
COMPASS = {"Nord": (1, 0), "Sud": (-1, 0), "Est": (0, 1), "Ovest": (0, -1)}  # north, east
MAX_SPACING = 2000.0  # m between nodes of a carriageway
MAX_SAGITTA = 25.0  # m between the smooth curve and the straight line between two nodes
AT_ONCE = 32  # ends of a straight line that are tried together
DENSE_STEP = 25.0  # m between the points of the curve before it is thinned out
LENGTH_TOLERANCE = 0.01  # a section shorter than its posts by more than this gets bends
MIN_BENT = 1500.0  # m, shorter sections stay smooth: bends would be too tight for a motorway
HALF_WAVE = 4500.0  # m, preferred length of a bend
MIN_HALF_WAVE = 800.0  # m
MAX_AMPLITUDE = 900.0  # m, how far a bend may leave the smooth curve
MAX_STEEPNESS = 0.6  # amplitude of a bend as a share of its length
MAX_INTERCHANGE_GAP = 2500.0  # m between the motorways of one interchange
RAMP_LEAD = 250.0  # m that a ramp follows the carriageway where two motorways cross
LENGTH_ERROR = 0.03  # --check: built length against the official length
STRAIGHT_SLACK = 0.3  # km, --check: straight distance beyond the difference of the posts
LOW_RATIO = 0.7  # --check: straight distance as a share of the difference of the posts

# The last two digits of an OSM id tell what the object is; see object_id().
ROLE_FORWARD, ROLE_BACKWARD, ROLE_GATE = 0, 1, 2
ROLE_LINK = 10  # 10-13: links of an exit
ROLE_POINT = 30  # 30-39: service areas at the same km
ROLE_RAMP = 40  # 40-99: ramps of an interchange (ways), their shape points (nodes)
PLACE_ID = 9 * 10**11
FERRY_ID = 8 * 10**11

Array = npt.NDArray[np.float64]


class TableError(ValueError):
    """A table cannot be used; the message names file, row and remedy in one line."""


# --- tables -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Motorway:
    """One row of motorways.csv."""

    ref: str
    name: str
    official_km: float
    toll: str
    maxspeed: int
    lanes: int


@dataclass(frozen=True)
class Row:
    """One row of a motorway table; `where` names file and row in messages."""

    where: str
    km: float
    kind: str
    name: str
    ref: str
    lat: float = math.nan
    lon: float = math.nan

    @property
    def placed(self) -> bool:
        """Tell whether the row has a position of its own."""
        return not math.isnan(self.lat)

    @property
    def metre(self) -> int:
        """Give the kilometre post in metres."""
        return round(self.km * 1000)


@dataclass(frozen=True)
class Place:
    """One row of places.csv."""

    name: str
    kind: str
    lat: float
    lon: float
    population: int


@dataclass(frozen=True)
class Quay:
    """One row of ferries.csv: a quay, the exit that leads to it, and how long the ferry sails."""

    where: str
    ferry: str
    minutes: int
    motorway: str
    exit: str
    lat: float
    lon: float


@dataclass(frozen=True)
class Tables:
    """All tables of the map; rows by motorway, spaces for trucks by (motorway, metre, name)."""

    motorways: list[Motorway]
    rows: dict[str, list[Row]]
    places: list[Place]
    quays: list[Quay]
    parkings: dict[tuple[str, int, str], str]


Record = tuple[str, dict[str, str]]


def records(path: Path, columns: tuple[str, ...]) -> Iterator[Record]:
    """Yield the lines of a CSV table as (where, fields), without blank lines."""
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise TableError(f"{path.name}: missing; add the table (see maps/README.md)") from None
    except UnicodeDecodeError:
        raise TableError(f"{path.name}: not UTF-8; save the table as UTF-8") from None
    reader = csv.reader(text.splitlines())
    header = next(reader, [])
    missing = [column for column in columns if column not in header]
    if missing:
        raise TableError(
            f"{path.name} row 1: no column {missing[0]!r}; begin the table with {','.join(columns)}"
        )
    for cells in reader:
        where = f"{path.name} row {reader.line_num}"
        if not any(cell.strip() for cell in cells):
            continue
        if len(cells) != len(header):
            raise TableError(
                f"{where}: {len(cells)} fields instead of {len(header)};"
                " put names that contain a comma in double quotes"
            )
        yield where, {key: cell.strip() for key, cell in zip(header, cells, strict=True)}


def number(record: Record, column: str, low: float, high: float) -> float:
    where, fields = record
    try:
        value = float(fields[column])
    except ValueError:
        raise TableError(
            f"{where}: {column} {fields[column]!r} is not a number; write it like 123.4"
        ) from None
    if not low <= value <= high:
        raise TableError(
            f"{where}: {column} {fields[column]} is not between {low:g} and {high:g}; correct it"
        )
    return value


def choice(record: Record, column: str, allowed: tuple[str, ...]) -> str:
    where, fields = record
    if fields[column] not in allowed:
        raise TableError(
            f"{where}: {column} {fields[column]!r} is unknown; use one of {', '.join(allowed)}"
        )
    return fields[column]


def position(record: Record) -> tuple[float, float]:
    south, north, west, east = ITALY
    return number(record, "lat", south, north), number(record, "lon", west, east)


def read_motorways(path: Path) -> list[Motorway]:
    motorways: dict[str, Motorway] = {}
    for record in records(path, MOTORWAY_COLUMNS):
        where, fields = record
        ref = fields["ref"]
        if not REF.fullmatch(ref):
            raise TableError(f"{where}: ref {ref!r} is not like A1, D18 or RA13; correct it")
        if ref in motorways:
            raise TableError(f"{where}: {ref} is listed twice; remove one of the rows")
        motorways[ref] = Motorway(
            ref=ref,
            name=fields["name"],
            official_km=number(record, "official_km", 0.1, 1000),
            toll=choice(record, "toll", ("yes", "no", "partly")),
            maxspeed=int(number(record, "maxspeed", 30, 150)),
            lanes=int(number(record, "lanes", 1, 5)) if fields.get("lanes") else 2,
        )
    return sorted(motorways.values(), key=lambda motorway: motorway_number(motorway.ref))


def read_places(path: Path) -> list[Place]:
    places: dict[str, Place] = {}
    for record in records(path, PLACE_COLUMNS):
        where, fields = record
        if not fields["name"]:
            raise TableError(f"{where}: no name; write the name of the city or town")
        if fields["name"] in places:
            raise TableError(f"{where}: {fields['name']} is listed twice; remove one of the rows")
        places[fields["name"]] = Place(
            fields["name"],
            choice(record, "kind", ("city", "town")),
            *position(record),
            int(number(record, "population", 1, 1e7)),
        )
    return list(places.values())


def exit_of(quay: Quay, rows: dict[str, list[Row]]) -> Row | None:
    """Find the exit that leads to a quay."""
    for row in rows.get(quay.motorway, []):
        if row.name == quay.exit and row.kind in ("junction", "end"):
            return row
    return None


def read_quays(path: Path, rows: dict[str, list[Row]]) -> list[Quay]:
    """Read the ferries, two rows each; none without the table."""
    quays = []
    for record in records(path, FERRY_COLUMNS) if path.exists() else ():
        where, fields = record
        quay = Quay(
            where,
            fields["name"],
            int(number(record, "minutes", 1, 2000)),
            fields["motorway"],
            fields["exit"],
            *position(record),
        )
        if exit_of(quay, rows) is None:
            raise TableError(
                f"{where}: {quay.motorway} has no exit {quay.exit!r}; name an exit of its table"
            )
        quays.append(quay)
    for name in dict.fromkeys(quay.ferry for quay in quays):
        ends = [quay for quay in quays if quay.ferry == name]
        if len(ends) != 2 or ends[0].minutes != ends[1].minutes:
            raise TableError(
                f"{ends[0].where}: ferry {name!r} needs two rows with the same minutes; correct it"
            )
    return quays


def read_parkings(path: Path, rows: dict[str, list[Row]]) -> dict[tuple[str, int, str], str]:
    """Read the spaces for trucks of service and rest areas; none without the table."""
    parkings = {}
    for record in records(path, PARKING_COLUMNS) if path.exists() else ():
        where, fields = record
        metre = round(number(record, "km", 0, 999.9) * 1000)
        areas = [
            row
            for row in rows.get(fields["motorway"], [])
            if row.kind in POINT_KINDS and (row.metre, row.name) == (metre, fields["name"])
        ]
        if not areas:
            raise TableError(
                f"{where}: {fields['motorway']} has no area {fields['name']!r} at km"
                f" {fields['km']}; name a service or rest row of its table"
            )
        spaces = str(int(number(record, "spaces", 1, 5000)))
        parkings[fields["motorway"], metre, fields["name"]] = spaces
    return parkings


def read_row(record: Record) -> Row:
    where, fields = record
    km = round(number(record, "km", 0, 999.9), 1)
    kind = choice(record, "kind", KINDS)
    name, ref = fields["name"], fields["ref"]
    if kind in (*STOP_KINDS, *POINT_KINDS) and not name:
        raise TableError(f"{where}: {kind} without a name; write the name on the signs")
    if kind in POINT_KINDS or (kind == "break" and not fields["lat"]):
        return Row(where, km, kind, name, ref)
    if not fields["lat"] or not fields["lon"]:
        raise TableError(f"{where}: {kind} without position; give lat and lon, 4 decimals")
    return Row(where, km, kind, name, ref, *position(record))


def read_rows(path: Path, motorway: str) -> list[Row]:
    """Read the rows of one motorway and check the rules that concern this table only."""
    rows = [read_row(record) for record in records(path, ROW_COLUMNS)]
    for before, row in pairwise(rows):
        if row.km < before.km:
            raise TableError(
                f"{row.where}: km {row.km:.1f} after km {before.km:.1f}; sort the rows by km"
            )
    placed = [row for row in rows if row.placed]
    if len(placed) < 2:
        raise TableError(f"{path.name}: fewer than two rows with a position; add the two ends")
    for before, row in pairwise(placed):
        if before.kind != "break" and row.km == before.km:
            raise TableError(
                f"{row.where}: km {row.km:.1f} twice; move one of the rows by 0.3 km or more"
            )
        if (row.lat, row.lon) == (before.lat, before.lon):
            raise TableError(
                f"{row.where}: same position as {before.where}; correct one of the two"
            )
    check_interchange_names(rows, motorway)
    return rows


def check_interchange_names(rows: list[Row], motorway: str) -> None:
    seen: set[str] = set()
    for row in rows:
        if row.kind != "interchange":
            continue
        if motorway not in row.name.split(" ")[0].split("/"):
            raise TableError(
                f"{row.where}: interchange {row.name!r} does not begin with {motorway};"
                " name it like 'A4/A22 Verona'"
            )
        if row.name in seen:
            raise TableError(f"{row.where}: interchange {row.name!r} twice; rename one of them")
        seen.add(row.name)


def read_tables(folder: Path) -> Tables:
    motorways = read_motorways(folder / "motorways.csv")
    known = {motorway.ref for motorway in motorways}
    for path in sorted(folder.glob("*.csv")):
        if REF.fullmatch(path.stem) and path.stem not in known:
            raise TableError(f"{path.name}: not listed in motorways.csv; add a row for {path.stem}")
    rows = {m.ref: read_rows(folder / f"{m.ref}.csv", m.ref) for m in motorways}
    places = read_places(folder / "places.csv")
    quays = read_quays(folder / "ferries.csv", rows)
    parkings = read_parkings(folder / "truck_parkings.csv", rows)
    tables = Tables(motorways, rows, places, quays, parkings)
    check_interchanges(tables)
    return tables


def interchanges(tables: Tables) -> dict[str, list[tuple[str, Row]]]:
    """Interchange name -> the motorways that carry it, with their rows."""
    found: dict[str, list[tuple[str, Row]]] = {}
    for motorway in tables.motorways:
        for row in tables.rows[motorway.ref]:
            if row.kind == "interchange":
                found.setdefault(row.name, []).append((motorway.ref, row))
    return found


def check_interchanges(tables: Tables) -> None:
    for name, members in interchanges(tables).items():
        if len(members) == 1:
            raise TableError(
                f"{members[0][1].where}: interchange {name!r} is in no other table;"
                " add it there or make this row a junction"
            )
        for (_, one), (_, other) in combinations(members, 2):
            gap = straight_km(one, other) * 1000
            if gap > MAX_INTERCHANGE_GAP:
                raise TableError(
                    f"{other.where}: interchange {name!r} is {gap / 1000:.1f} km from"
                    f" {one.where}; correct the position that is wrong"
                )


# --- geometry -----------------------------------------------------------------------------


class Frame:
    """Metres east and north of a point, good for a few tens of kilometres (WGS84 radii)."""

    def __init__(self, lat: float, lon: float) -> None:
        self.lat, self.lon = lat, lon
        sine = math.sin(math.radians(lat))
        curvature = 1 - 0.00669437999 * sine * sine
        self.north = math.radians(6378137.0 * (1 - 0.00669437999) / curvature**1.5)
        self.east = math.radians(6378137.0 / math.sqrt(curvature)) * math.cos(math.radians(lat))

    def metres(self, lat: float, lon: float) -> Array:
        """Convert a position to metres east and north."""
        return np.array([(lon - self.lon) * self.east, (lat - self.lat) * self.north])

    def degrees(self, x: float, y: float) -> tuple[float, float]:
        """Convert metres east and north to a position."""
        return self.lat + y / self.north, self.lon + x / self.east


def frame_between(one: Row, other: Row) -> Frame:
    return Frame((one.lat + other.lat) / 2, (one.lon + other.lon) / 2)


def chord(one: Row, other: Row) -> Array:
    """Vector in metres from one row to the other."""
    frame = frame_between(one, other)
    return frame.metres(other.lat, other.lon) - frame.metres(one.lat, one.lon)


def straight_km(one: Row, other: Row) -> float:
    return float(np.hypot(*chord(one, other))) / 1000


def line_length(points: Array) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def unit(vector: Array) -> Array:
    norm = float(np.hypot(*vector))
    return vector / norm if norm > 0 else np.array([1.0, 0.0])


def directions(points: Array) -> Array:
    """Return the unit direction of the line at each of its points."""
    slopes: Array = np.asarray(np.gradient(points, axis=0), dtype=np.float64)
    lengths = np.sqrt((slopes**2).sum(axis=1, keepdims=True))
    heads: Array = slopes / np.maximum(lengths, 1e-9)
    return heads


def tangents(rows: list[Row], ring: bool) -> list[Array]:
    """Direction of the road at each row: chords before and after, the nearer row counts more."""
    chords = [chord(one, other) for one, other in pairwise(rows)]
    inner = [mean_direction(before, after) for before, after in pairwise(chords)]
    first = last = mean_direction(chords[-1], chords[0])
    if not ring:
        first = end_direction(chords[0], inner[0] if inner else chords[0])
        last = end_direction(chords[-1], inner[-1] if inner else chords[-1])
    return [first, *inner, last]


def mean_direction(before: Array, after: Array) -> Array:
    """Chords divided by the square root of their lengths, added (centripetal weights)."""
    weighted = unit(before) / math.sqrt(float(np.hypot(*before)))
    return unit(weighted + unit(after) / math.sqrt(float(np.hypot(*after))))


def end_direction(outer: Array, neighbour: Array) -> Array:
    """Mirror the neighbour's direction on the chord, so that the last section is an arc."""
    axis = unit(outer)
    mirrored = 2 * float(axis @ unit(neighbour)) * axis - unit(neighbour)
    return unit(axis + mirrored)


def hermite(start: Array, end: Array, leave: Array, arrive: Array) -> Array:
    """Dense cubic curve between two points with given unit directions."""
    distance = float(np.hypot(*(end - start)))
    t = np.linspace(0.0, 1.0, max(8, math.ceil(distance / DENSE_STEP)) + 1)[:, np.newaxis]
    curve: Array = (
        (2 * t**3 - 3 * t**2 + 1) * start
        + (t**3 - 2 * t**2 + t) * distance * leave
        + (3 * t**2 - 2 * t**3) * end
        + (t**3 - t**2) * distance * arrive
    )
    return curve


def along(points: Array) -> Array:
    """Distance of every point from the first one along the line."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def sway(curve: Array, half_waves: int) -> Array:
    """Sideways bends of amplitude one that start and end in the direction of the curve."""
    share = along(curve) / line_length(curve)
    ramp = np.clip(np.minimum(share, 1 - share) * half_waves, 0.0, 1.0)
    height = np.sin(half_waves * math.pi * share) * ramp**2 * (3 - 2 * ramp)
    normal = directions(curve) @ np.array([[0.0, -1.0], [1.0, 0.0]])
    offsets: Array = normal * height[:, np.newaxis]
    return offsets


def with_bends(curve: Array, length: float) -> Array:
    """Add symmetric bends that make the curve `length` metres long, as far as limits allow."""
    base = line_length(curve)
    half_waves = 2 * max(1, round(base / HALF_WAVE / 2))
    while True:
        offsets = sway(curve, half_waves)
        limit = min(MAX_AMPLITUDE, MAX_STEEPNESS * base / half_waves)
        enough = line_length(curve + limit * offsets) >= length
        if enough or base / (half_waves + 2) < MIN_HALF_WAVE:
            break
        half_waves += 2
    low, high = 0.0, limit
    for _ in range(30):
        middle = (low + high) / 2
        if line_length(curve + middle * offsets) < length:
            low = middle
        else:
            high = middle
    bent: Array = curve + high * offsets
    return bent


def thinned(curve: Array) -> list[int]:
    """Choose the points to keep: as few as spacing and sagitta allow, both ends included."""
    kept, last = [0], len(curve) - 1
    while kept[-1] < last:
        kept.append(reach(curve, kept[-1]))
    return kept


def reach(curve: Array, start: int) -> int:
    """Return how far a straight line from a point may stand for all of the curve between."""
    stop, last = start + 1, len(curve) - 1
    while stop < last:
        spans = curve[stop + 1 : stop + 1 + AT_ONCE] - curve[start]
        ends = stop + 1 - start + np.arange(len(spans))
        distance = np.hypot(*spans.T)
        east, north = (curve[start : stop + 1 + len(spans)] - curve[start]).T
        aside = np.abs(np.outer(spans[:, 1], east) - np.outer(spans[:, 0], north))
        aside[np.arange(len(east)) > ends[:, np.newaxis]] = 0.0
        sagitta = np.full(len(spans), np.inf)
        np.divide(aside.max(axis=1), distance, out=sagitta, where=distance > 0)
        too_far = np.flatnonzero((distance > MAX_SPACING) | (sagitta > MAX_SAGITTA))
        if len(too_far):
            return stop + int(too_far[0])
        stop += len(spans)
    return stop


def section_curve(start: Row, end: Row, leave: Array, arrive: Array, frame: Frame) -> Array:
    """Draw the road between two rows, in metres of the frame."""
    curve = hermite(
        frame.metres(start.lat, start.lon), frame.metres(end.lat, end.lon), leave, arrive
    )
    posts = (end.km - start.km) * 1000
    length = line_length(curve)
    if length < MIN_BENT or length >= posts * (1 - LENGTH_TOLERANCE):
        return curve[thinned(curve)]
    bent = with_bends(curve, posts)
    loss = posts / line_length(bent[thinned(bent)])  # straight pieces are shorter than the curve
    if 1 < loss < 1 + 2 * LENGTH_TOLERANCE:
        bent = with_bends(curve, posts * loss)
    return bent[thinned(bent)]


# --- lines --------------------------------------------------------------------------------


class Point(NamedTuple):
    """A point of a centreline; east and north are the direction of increasing km."""

    metre: int
    lat: float
    lon: float
    east: float
    north: float

    def beside(self, right: float, ahead: float = 0.0) -> tuple[float, float]:
        """Position so many metres to the right of and ahead of this point."""
        return Frame(self.lat, self.lon).degrees(
            right * self.north + ahead * self.east, -right * self.east + ahead * self.north
        )


@dataclass
class Line:
    """An uninterrupted piece of a motorway: its rows with position and its points."""

    rows: list[Row]
    ring: bool = False
    points: list[Point] = field(default_factory=list)
    lengths: list[float] = field(default_factory=list)  # m, built length after each row

    @property
    def stops(self) -> list[Row]:
        """List the rows where vehicles leave or enter."""
        rows = self.rows[:-1] if self.ring else self.rows
        return [row for row in rows if row.kind in STOP_KINDS]

    def at(self, metre: int) -> Point:
        """Find the point with this metre, on the straight line between two points if need be."""
        after = next(i for i, point in enumerate(self.points) if point.metre >= metre)
        point = self.points[after]
        if point.metre == metre or after == 0:
            return point
        before = self.points[after - 1]
        share = (metre - before.metre) / (point.metre - before.metre)
        lat = before.lat + share * (point.lat - before.lat)
        lon = before.lon + share * (point.lon - before.lon)
        return Point(metre, lat, lon, point.east, point.north)


def split_rows(rows: list[Row]) -> list[list[Row]]:
    """Cut the rows with position at the breaks."""
    pieces: list[list[Row]] = [[]]
    for row in rows:
        if row.placed:
            pieces[-1].append(row)
        if row.kind == "break":
            pieces.append([])
    return pieces


def checked_piece(piece: list[Row], table: str) -> Line:
    if len(piece) < 2:
        raise TableError(f"{table}.csv: a break leaves no road before or after it; remove it")
    first, last = piece[0], piece[-1]
    if len(piece) > 3 and (first.lat, first.lon) == (last.lat, last.lon):
        return Line(piece, ring=True)
    for row in (first, last):
        if row.kind not in STOP_KINDS:
            raise TableError(
                f"{row.where}: the road ends at a {row.kind} row; make it an end or a junction"
            )
    return Line(piece)


def draw(line: Line) -> Line:
    """Fill in the points of a line."""
    directions_at = tangents(line.rows, line.ring)
    for (start, end), (leave, arrive) in zip(
        pairwise(line.rows), pairwise(directions_at), strict=True
    ):
        frame = frame_between(start, end)
        points = section_curve(start, end, leave, arrive, frame)
        line.lengths.append(line_length(points))
        shares = along(points) / line.lengths[-1]
        heads = directions(points)
        heads[0], heads[-1] = leave, arrive
        for share, (x, y), (east, north) in zip(shares, points, heads, strict=True):
            metre = start.metre + round(float(share) * (end.metre - start.metre))
            point = Point(metre, *frame.degrees(float(x), float(y)), float(east), float(north))
            if not line.points or metre > line.points[-1].metre:
                line.points.append(point)
    return line


def draw_motorway(rows: list[Row], table: str) -> list[Line]:
    return [draw(checked_piece(piece, table)) for piece in split_rows(rows)]


# --- OSM objects --------------------------------------------------------------------------

Tags = dict[str, str]


@dataclass
class Osm:
    """Nodes and ways by id."""

    nodes: dict[int, tuple[float, float, Tags]] = field(default_factory=dict)
    ways: dict[int, tuple[list[int], Tags]] = field(default_factory=dict)

    def node(self, identity: int, where: tuple[float, float], tags: Tags | None = None) -> int:
        """Add a node."""
        if identity in self.nodes:
            raise TableError(f"two objects got the id {identity}; move one of the rows by 0.1 km")
        self.nodes[identity] = (where[0], where[1], tags or {})
        return identity

    def way(self, identity: int, nodes: list[int], tags: Tags) -> None:
        """Add a way."""
        if identity in self.ways:
            raise TableError(f"two roads got the id {identity}; move one of the rows by 0.1 km")
        self.ways[identity] = (nodes, tags)


class Stop(NamedTuple):
    """Where a row meets the carriageways: nodes traffic arrives at and nodes it departs from."""

    point: Point
    arrive: list[int]
    depart: list[int]


def motorway_number(ref: str) -> int:
    """Give the motorway a number: A22 -> 22, D18 (a diramazione) -> 518."""
    found = REF.fullmatch(ref)
    if found is None:
        raise ValueError(ref)
    return REF_BASE[found[1]] + int(found[2])


def object_id(ref: str, metre: int, role: int) -> int:
    """Motorway, metre and role as digits: an id changes only when its own row changes."""
    return (motorway_number(ref) * 1_000_000 + metre) * 100 + role


def tagged(**tags: str | int) -> Tags:
    """Leave out empty tags."""
    return {key: str(value) for key, value in tags.items() if value != ""}


def toll_tag(motorway: Motorway) -> str:
    """Give one value for the whole motorway: partly tolled ones are tolled on most of it."""
    return "no" if motorway.toll == "no" else "yes"


def add_carriageways(osm: Osm, motorway: Motorway, line: Line) -> dict[int, Stop]:
    """Add both carriageways of a line; return the stops by their metre."""
    names = {row.metre: row for row in line.stops}
    points = line.points[:-1] if line.ring else line.points
    for role, side in ((ROLE_FORWARD, 1), (ROLE_BACKWARD, -1)):
        for point in points:
            row = names.get(point.metre)
            tags = tagged(highway="motorway_junction", name=row.name, ref=row.ref) if row else {}
            where = point.beside(side * CARRIAGEWAY_OFFSET)
            osm.node(object_id(motorway.ref, point.metre, role), where, tags)
    add_carriageway_ways(osm, motorway, line)
    return {row.metre: make_stop(motorway.ref, line, row) for row in line.stops}


def add_carriageway_ways(osm: Osm, motorway: Motorway, line: Line) -> None:
    """Add the ways from stop to stop, in both directions."""
    tags = tagged(
        highway="motorway",
        ref=motorway.ref,
        name=motorway.name,
        oneway="yes",
        maxspeed=motorway.maxspeed,
        lanes=motorway.lanes,
        toll=toll_tag(motorway),
    )
    metres = [point.metre for point in line.points]
    last = len(metres) - 1
    stops = {row.metre for row in line.stops}
    cuts = [i for i, metre in enumerate(metres) if metre in stops or i in (0, last)]
    closed = [*metres[:-1], metres[0]] if line.ring else metres
    for start, end in pairwise(cuts):
        for role in (ROLE_FORWARD, ROLE_BACKWARD):
            nodes = [object_id(motorway.ref, metre, role) for metre in closed[start : end + 1]]
            if role == ROLE_BACKWARD:
                nodes.reverse()
            osm.way(object_id(motorway.ref, metres[start], role), nodes, tags)


def make_stop(ref: str, line: Line, row: Row) -> Stop:
    forward = object_id(ref, row.metre, ROLE_FORWARD)
    backward = object_id(ref, row.metre, ROLE_BACKWARD)
    first = row is line.rows[0] and not line.ring
    last = row is line.rows[-1] and not line.ring
    arrive = [backward] if first else [forward] if last else [forward, backward]
    depart = [forward] if first else [backward] if last else [forward, backward]
    return Stop(line.at(row.metre), arrive, depart)


def add_exit(osm: Osm, motorway: Motorway, row: Row, stop: Stop) -> None:
    """Add the gate node beside the road (ahead of it at an end) and its links."""
    through = len(stop.arrive) == 2
    ahead = 1 if stop.arrive[0] % 100 == ROLE_FORWARD else -1
    where = stop.point.beside(GATE_OFFSET) if through else stop.point.beside(0, ahead * GATE_OFFSET)
    booth = "toll_booth" if motorway.toll == "yes" else ""
    identity = object_id(motorway.ref, row.metre, ROLE_GATE)
    gate = osm.node(identity, where, tagged(barrier=booth, name=row.name))
    tags = link_tags(motorway, row.name, 40)
    links = [[node, gate] for node in stop.arrive] + [[gate, node] for node in stop.depart]
    for index, nodes in enumerate(links):
        osm.way(object_id(motorway.ref, row.metre, ROLE_LINK + index), nodes, tags)


def link_tags(motorway: Motorway, destination: str, maxspeed: int) -> Tags:
    return tagged(
        highway="motorway_link",
        oneway="yes",
        destination=destination,
        maxspeed=maxspeed,
        lanes=1,
        toll=toll_tag(motorway),
    )


def add_interchange(osm: Osm, members: list[tuple[Motorway, Row, Stop]]) -> None:
    """Add ramps from every carriageway of each motorway to every carriageway of the others."""
    first, row, _ = members[0]
    index = ROLE_RAMP
    for (_, _, origin), (target, _, goal) in permutations(members, 2):
        tags = link_tags(target, f"{target.ref} {target.name}".strip(), 60)
        for leave in origin.arrive:
            for enter in goal.depart:
                if index > 99:
                    raise TableError(f"{row.where}: too many motorways meet here; split it")
                identity = object_id(first.ref, row.metre, index)
                shape = ramp_points((leave, origin.point), (enter, goal.point))
                nodes = [osm.node(identity + i * 10**12, at) for i, at in enumerate(shape, 1)]
                osm.way(identity, [leave, *nodes, enter], tags)
                index += 1


def ramp_points(origin: tuple[int, Point], goal: tuple[int, Point]) -> list[tuple[float, float]]:
    """Shape a ramp where motorways cross; no points where they pass at a distance."""
    (leave, here), (enter, there) = origin, goal
    frame = Frame(here.lat, here.lon)
    gap = float(np.hypot(*frame.metres(there.lat, there.lon)))
    if gap > 3 * RAMP_LEAD:
        return []
    points = []
    for node, point, sign in ((leave, here, 1), (enter, there, -1)):
        side = 1 if node % 100 == ROLE_FORWARD else -1
        points.append(point.beside(side * 4 * CARRIAGEWAY_OFFSET, sign * side * RAMP_LEAD))
    return points


def area_place(point: Point, row: Row) -> tuple[float, float]:
    """Place a service area on the side that its name tells, else between the carriageways.

    Areas of one name are a pair, one for each direction, as most of the tables' are; a rest area
    or truck park is called after the exit by which both directions reach it.
    """
    toward = COMPASS.get(row.name.rpartition(" ")[2]) if row.kind == "service" else None
    middle = point.beside(0.0)
    if toward is None:
        return middle
    sides = [point.beside(sign * SERVICE_OFFSET) for sign in (1, -1)]
    north, east = toward
    return max(sides, key=lambda at: north * (at[0] - middle[0]) + east * (at[1] - middle[1]))


def add_points(osm: Osm, motorway: Motorway, tables: Tables, lines: list[Line]) -> None:
    """Add service and rest areas beside the road; all of them are open to trucks."""
    used: dict[int, int] = {}
    for row in tables.rows[motorway.ref]:
        if row.kind not in POINT_KINDS:
            continue
        line = next((x for x in lines if x.rows[0].km <= row.km <= x.rows[-1].km), None)
        if line is None:
            raise TableError(f"{row.where}: km {row.km:.1f} is beside no road; correct the km")
        index = used[row.metre] = used.get(row.metre, -1) + 1
        highway = "services" if row.kind == "service" else "rest_area"
        identity = object_id(motorway.ref, row.metre, ROLE_POINT + index)
        where = area_place(line.at(row.metre), row)
        tags = tagged(highway=highway, name=row.name, ref=row.ref, hgv="yes")
        if spaces := tables.parkings.get((motorway.ref, row.metre, row.name)):
            tags["capacity:hgv"] = spaces
        osm.node(identity, where, tags)


def add_places(osm: Osm, places: list[Place]) -> None:
    for place in places:
        identity = PLACE_ID + zlib.crc32(place.name.encode())
        tags = tagged(place=place.kind, name=place.name, population=place.population)
        osm.node(identity, (place.lat, place.lon), tags)


def add_ferries(osm: Osm, tables: Tables) -> None:
    """Add ferries as ways between quays, and roads from the exits to the quays and back."""
    ends: dict[str, list[int]] = {}
    for quay in tables.quays:
        base = FERRY_ID + zlib.crc32(quay.ferry.encode()) * 10
        mine = ends.setdefault(quay.ferry, [])
        row = exit_of(quay, tables.rows)
        assert row is not None  # read_quays has seen it
        gate = object_id(quay.motorway, row.metre, ROLE_GATE)
        tags = tagged(amenity="ferry_terminal", name=f"{quay.exit}, {quay.ferry}")
        terminal = osm.node(base + len(mine), (quay.lat, quay.lon), tags)
        gap = Frame(quay.lat, quay.lon).metres(*osm.nodes[gate][:2])
        if float(np.hypot(*gap)) > MAX_INTERCHANGE_GAP:
            raise TableError(
                f"{quay.where}: the quay is more than {MAX_INTERCHANGE_GAP / 1000} km from"
                f" {quay.exit}; correct the position that is wrong"
            )
        road = tagged(
            highway="motorway_link", oneway="yes", destination=quay.ferry, maxspeed=50, lanes=1
        )
        for index, nodes in enumerate(([gate, terminal], [terminal, gate])):
            osm.way(base + 2 + 2 * len(mine) + index, nodes, road)
        mine.append(terminal)
        if len(mine) == 2:
            duration = f"{quay.minutes // 60:02d}:{quay.minutes % 60:02d}"
            tags = tagged(route="ferry", name=quay.ferry, duration=duration, hgv="yes")
            osm.way(base, mine, {**tags, "motor_vehicle": "yes"})


def build(tables: Tables, lines: dict[str, list[Line]]) -> Osm:
    osm = Osm()
    motorways = {motorway.ref: motorway for motorway in tables.motorways}
    stops: dict[tuple[str, int], Stop] = {}
    for ref, motorway in motorways.items():
        for line in lines[ref]:
            found = add_carriageways(osm, motorway, line)
            stops.update({(ref, metre): stop for metre, stop in found.items()})
            for row in line.stops:
                if row.kind != "interchange":
                    add_exit(osm, motorway, row, found[row.metre])
        add_points(osm, motorway, tables, lines[ref])
    for members in interchanges(tables).values():
        add_interchange(osm, [(motorways[ref], row, stops[ref, row.metre]) for ref, row in members])
    add_ferries(osm, tables)
    add_places(osm, tables.places)
    return osm


# --- output -------------------------------------------------------------------------------

HEADER = """<?xml version="1.0" encoding="UTF-8"?>
<osm version="0.6" generator="platoon_osm maps/build_italy.py"\
 attribution="platoon_osm, tables in maps/italy" license="MIT">
<!-- Hand-compiled schematic of the Italian motorways at junction resolution, made from the
     tables in maps/italy. Not a survey and not an extract of the OpenStreetMap database. -->
"""


def tag_lines(tags: Tags) -> Iterator[str]:
    for key, value in sorted(tags.items()):
        yield f"  <tag k={quoteattr(key)} v={quoteattr(value)}/>\n"


def osm_lines(osm: Osm) -> Iterator[str]:
    yield HEADER
    for identity, (lat, lon, tags) in sorted(osm.nodes.items()):
        close = ">" if tags else "/>"
        yield f' <node id="{identity}" version="1" lat="{lat:.5f}" lon="{lon:.5f}"{close}\n'
        if tags:
            yield from tag_lines(tags)
            yield " </node>\n"
    for identity, (nodes, tags) in sorted(osm.ways.items()):
        yield f' <way id="{identity}" version="1">\n'
        for node in nodes:
            yield f'  <nd ref="{node}"/>\n'
        yield from tag_lines(tags)
        yield " </way>\n"
    yield "</osm>\n"


# --- check --------------------------------------------------------------------------------


class Report(NamedTuple):
    """Lines to print and the number of errors among them."""

    lines: list[str]
    errors: int


def label(row: Row) -> str:
    return row.name or f"{row.kind} at km {row.km:.1f}"


def doubtful_sections(ref: str, line: Line) -> Report:
    """Report sections whose straight distance does not go with their posts."""
    report, errors = [], 0
    for (start, end), built in zip(pairwise(line.rows), line.lengths, strict=True):
        straight, posts = straight_km(start, end), end.km - start.km
        text = (
            f"{ref} {label(start)} - {label(end)}: posts {posts:.1f} km,"
            f" straight {straight:.1f} km, built {built / 1000:.1f} km"
        )
        if straight > posts + STRAIGHT_SLACK:
            errors += 1
            report.append(f"error: {text}: a position or a post is wrong")
        elif posts > 1 and straight < LOW_RATIO * posts:
            report.append(f"look:  {text}: much straighter than its posts")
        elif abs(built / 1000 - posts) > max(2 * STRAIGHT_SLACK, 0.05 * posts):
            report.append(f"look:  {text}: length does not match")
    return Report(report, errors)


def check(tables: Tables, lines: dict[str, list[Line]]) -> Report:
    """Report one line per motorway, then the sections to look at."""
    head = f"{'ref':<4} {'exits':>5} {'official':>9} {'posts':>7} {'built':>7} {'error':>7}"
    report, details, errors = [head], [], 0
    exits = official = posts_sum = built_sum = 0.0
    for motorway in tables.motorways:
        mine = lines[motorway.ref]
        stops = sum(len(line.stops) for line in mine)
        posts = sum(line.rows[-1].km - line.rows[0].km for line in mine)
        built = sum(sum(line.lengths) for line in mine) / 1000
        off = built / motorway.official_km - 1
        report.append(
            f"{motorway.ref:<4} {stops:5d} {motorway.official_km:9.1f} {posts:7.1f}"
            f" {built:7.1f} {off:+7.1%}"
        )
        if abs(off) > LENGTH_ERROR:
            errors += 1
            details.append(f"error: {motorway.ref} is {off:+.1%} off its official length")
        for line in mine:
            sections = doubtful_sections(motorway.ref, line)
            details += sections.lines
            errors += sections.errors
        exits, official = exits + stops, official + motorway.official_km
        posts_sum, built_sum = posts_sum + posts, built_sum + built
    report.append(
        f"all  {exits:5.0f} {official:9.1f} {posts_sum:7.1f} {built_sum:7.1f}"
        f" {built_sum / official - 1:+7.1%}"
    )
    count = sum(len(line.lengths) for mine in lines.values() for line in mine)
    checked = (
        f"checked: {count} sections, straight distance against posts; "
        f"{len(tables.motorways)} lengths; {len(interchanges(tables))} interchanges, the distance "
        f"of their motorways; {len(tables.quays)} quays; {len(tables.parkings)} areas with spaces"
    )
    return Report([*report, *details, checked, f"{errors} errors"], errors)


def exits_of(tables: Tables) -> list[Exit]:
    return [
        Exit(ref, row.name, row.lat, row.lon)
        for ref, rows in tables.rows.items()
        for row in rows
        if row.kind in STOP_KINDS
    ]


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Build the OSM file of the Italian motorways.")
    parser.add_argument("--tables", type=Path, default=TABLES, help="folder with the tables")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="OSM XML file to write")
    parser.add_argument("--check", action="store_true", help="report doubtful rows, write nothing")
    parser.add_argument("--towns", action="store_true", help="compare exits with towns, no writing")
    parser.add_argument("--waypoints", type=Path, help="compare exits with .wpt files, no writing")
    options = parser.parse_args(arguments)
    try:
        tables = read_tables(options.tables)
        lines = {ref: draw_motorway(rows, ref) for ref, rows in tables.rows.items()}
        osm = build(tables, lines)
    except TableError as error:
        print(error, file=sys.stderr)
        return 2
    if options.towns:
        print("\n".join(compare(exits_of(tables))))
        return 0
    if options.waypoints:
        print("\n".join(compare_waypoints(exits_of(tables), options.waypoints)))
        return 0
    if options.check:
        report = check(tables, lines)
        print("\n".join(report.lines))
        return 1 if report.errors else 0
    options.output.write_text("".join(osm_lines(osm)), encoding="utf-8", newline="\n")
    print(f"{options.output}: {len(osm.nodes)} nodes, {len(osm.ways)} ways")
    return 0


if __name__ == "__main__":
    sys.exit(main())
