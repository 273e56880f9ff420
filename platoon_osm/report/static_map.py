"""The map as one still SVG, for print and for readers without JavaScript."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from .basemap import BASEMAP_STEPS, ROUTE_STEPS
from .fragments import Markup, fill, join
from .placement import Box, Cover, text_width
from .polyline import decode_polyline

__all__ = ["static_map"]

WIDTH = 960.0
LEAST_HEIGHT, MOST_HEIGHT = 760.0, 980.0
MARGIN = 60.0
CROWD_COLOUR = "#4d5560"
MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""

LETTER_SIZE = {1: 11.0, 2: 9.0, 3: 8.0}

CROWD = 8
"""Lines of more vehicles than this are too thin for dashes."""

MOST_ENDS = 3
"""More starts or destinations than this on one spot become one mark that counts them."""

Point = tuple[float, float]


def static_map(document: dict[str, Any]) -> Markup:
    """Return the still map of a report document: routes, letters, points and names."""
    view = _View(document)
    cover = Cover(WIDTH, view.height)
    vehicles = document["vehicles"]
    routes = list(_routes(document, view, cover))
    marks = list(_marks(document, view, cover))
    scale = _scale(view, cover)
    # Callouts choose their place before names do: they matter more.
    callouts = list(_callouts(document, view, cover))
    names = list(_names(document, view, cover))
    return fill(
        "static-map",
        width=f"{WIDTH:g}",
        height=f"{view.height:g}",
        title=document["title"],
        description=f"Map of {document['subtitle']}: "
        + "; ".join(f"{v['letter']} {v['origin']['name']} to {v['destination']['name']}"
                    for v in vehicles[:12]),
        network=view.network_path(document["basemap"]["known"]),
        inferred=view.path(document["basemap"]["inferred"], BASEMAP_STEPS),
        inferred_routes=view.path(document["inferred_routes"], ROUTE_STEPS),
        routes=join(routes),
        names=join(names),
        marks=join(marks),
        callouts=join(callouts),
        scale=scale,
    )  # fmt: skip


def mercator(lon: float, lat: float) -> Point:
    """Return Web Mercator coordinates of a point, in degrees at the equator; y grows south."""
    lat = max(-85.0, min(85.0, lat))
    return lon, -math.degrees(math.asinh(math.tan(math.radians(lat))))


class _View:
    """The part of the world drawn, and its pixels."""

    def __init__(self, document: dict[str, Any]) -> None:
        points = [mercator(*at) for line in _plan_lines(document) for at in line]
        for vehicle in document["vehicles"]:
            points += [
                mercator(stop["lon"], stop["lat"])
                for stop in (vehicle["origin"], vehicle["destination"])
            ]
        xs, ys = np.array(points).T
        # A plan of one place still gets a drawing some 10 km wide.
        span_x, span_y = max(float(np.ptp(xs)), 0.1), max(float(np.ptp(ys)), 0.05)
        room = WIDTH - 2 * MARGIN
        self.per_degree = min(room / span_x, (MOST_HEIGHT - 2 * MARGIN) / span_y)
        tall = span_y * self.per_degree + 2 * MARGIN
        self.height = float(round(min(max(tall, LEAST_HEIGHT), MOST_HEIGHT)))
        self._x = WIDTH / 2 - self.per_degree * float(xs.min() + xs.max()) / 2
        self._y = self.height / 2 - self.per_degree * float(ys.min() + ys.max()) / 2
        self.latitude = float(np.mean([stop[1] for stop in _stops(document)]))

    def at(self, lon: float, lat: float) -> Point:
        """Return the pixel of a point."""
        x, y = mercator(lon, lat)
        return x * self.per_degree + self._x, y * self.per_degree + self._y

    def pixels(self, line: str, steps: int) -> list[Point]:
        """Return an encoded line in pixels, without points that make no difference."""
        import shapely

        points = [self.at(lon, lat) for lon, lat in decode_polyline(line, steps)]
        if len(points) < 3:
            return points
        simple = shapely.simplify(shapely.linestrings(points), 0.6)
        return [(float(x), float(y)) for x, y in shapely.get_coordinates(simple)]

    def path(self, lines: Sequence[str], steps: int) -> str:
        """Return SVG path data of those encoded lines that come near the drawing."""
        kept = (self.pixels(line, steps) for line in lines)
        return "".join(path_data(points) for points in kept if self._near(points))

    def network_path(self, lines: Sequence[str]) -> str:
        """Return SVG path data of the background: to half a pixel, twin carriageways once."""
        kept: dict[tuple[Point, ...], list[Point]] = {}
        for line in lines:
            points = [
                (round(x * 2) / 2, round(y * 2) / 2) for x, y in self.pixels(line, BASEMAP_STEPS)
            ]
            if not self._near(points) or max(np.ptp(np.asarray(points), axis=0)) < 1.5:
                continue
            # The other carriageway has nearly the same ends, a pixel or two apart.
            ends = tuple(sorted((round(x / 3), round(y / 3)) for x, y in (points[0], points[-1])))
            kept.setdefault(ends, points)
        # A dense network would outweigh all the rest of the page: its shortest lines stay out.
        longest = sorted(kept.values(), key=lambda line: -float(np.ptp(line, axis=0).sum()))
        room = MOST_NETWORK_DATA
        parts: list[str] = []
        for points in longest:
            parts.append(path_data(points))
            room -= len(parts[-1])
            if room < 0:
                break
        return "".join(parts)

    def _near(self, points: Sequence[Point]) -> bool:
        xs, ys = zip(*points, strict=True)
        return bool(max(xs) > 0 and min(xs) < WIDTH and max(ys) > 0 and min(ys) < self.height)


def path_data(points: Sequence[Point]) -> str:
    """Return SVG path data of a line, to a tenth of a pixel, each step from the point before."""
    tenths = [(round(x * 10), round(y * 10)) for x, y in points]
    (x0, y0), *rest = tenths
    out = [f"M{x0 / 10:g} {y0 / 10:g}l"]
    for x, y in rest:
        out.append(f"{(x - x0) / 10:g} {(y - y0) / 10:g} ")
        x0, y0 = x, y
    return "".join(out).rstrip()


def _plan_lines(document: dict[str, Any]) -> Iterator[list[Point]]:
    for section in document["platoons"]:
        yield decode_polyline(section["line"], ROUTE_STEPS)
    for solo in document["solos"]:
        for part in solo["parts"]:
            yield decode_polyline(part["line"], ROUTE_STEPS)


def _stops(document: dict[str, Any]) -> list[Point]:
    return [
        (vehicle[end]["lon"], vehicle[end]["lat"])
        for vehicle in document["vehicles"]
        for end in ("origin", "destination")
    ]


def shifted(points: Sequence[Point], aside: float) -> list[Point]:
    """Return a line moved to its right by some pixels, corners mitred within limits."""
    if not aside or len(points) < 2:
        return list(points)
    flat = np.asarray(points)
    step = np.diff(flat, axis=0)
    step = step[np.hypot(*step.T) > 0]
    if not len(step):
        return list(points)
    keep = np.concatenate([[True], np.hypot(*np.diff(flat, axis=0).T) > 0])
    flat = flat[keep]
    normal = np.column_stack([-step[:, 1], step[:, 0]]) / np.hypot(*step.T)[:, None]
    before, after = np.vstack([normal[:1], normal]), np.vstack([normal, normal[-1:]])
    mitre = before + after
    # |mitre| = 2 cos(half the turn); beyond 120 degrees a mitre would run away.
    length = np.maximum((mitre**2).sum(axis=1), 1.0)
    moved = flat + aside * 2 * mitre / length[:, None]
    return [(float(x), float(y)) for x, y in moved]


def band_lines(vehicles: int) -> tuple[float, float]:
    """Return the distance between lines in a platoon band and their width, in pixels."""
    step = min(6.0, 36.0 / vehicles)
    return step, min(4.0, step * 0.68)


def _routes(document: dict[str, Any], view: _View, cover: Cover) -> Iterator[Markup]:
    vehicles = document["vehicles"]
    solo_lines: list[tuple[str, dict[str, Any], float]] = []
    for solo in document["solos"]:
        points: list[Point] = []
        for part in solo["parts"]:
            points += shifted(view.pixels(part["line"], ROUTE_STEPS), _solo_aside(part))
        cover.add_line(points)
        slots = max((part["slots"] for part in solo["parts"]), default=1)
        width = min(3.6, max(1.3, _solo_step(slots) * 0.8))
        solo_lines.append((path_data(points), vehicles[solo["vehicle"]], width))
    for path, _, width in solo_lines:
        yield fill(
            "static-line",
            path=path,
            colour="#fff",
            width=f"{width + 3.4:.3g}",
            dash="none",
            cap="butt",
        )
    for path, vehicle, width in solo_lines:
        yield fill(
            "static-line", path=path, colour=vehicle["colour"], width=f"{width:.3g}",
            dash=vehicle["dash"] or "none", cap=vehicle["cap"],
        )  # fmt: skip
    for section in document["platoons"]:
        points = view.pixels(section["line"], ROUTE_STEPS)
        step, width = band_lines(len(section["vehicles"]))
        dashed = len(section["vehicles"]) <= CROWD
        inner = 6 + step * len(section["vehicles"])
        yield fill(
            "static-band", path=path_data(points), outer=f"{inner + 2:g}", inner=f"{inner:g}"
        )
        for place, index in enumerate(section["vehicles"]):
            aside = (place - (len(section["vehicles"]) - 1) / 2) * step
            line = shifted(points, aside)
            cover.add_line(line, weight=4)
            yield fill(
                "static-line", path=path_data(line), colour=vehicles[index]["colour"],
                width=f"{width:.3g}", dash=(dashed and vehicles[index]["dash"]) or "none",
                cap=vehicles[index]["cap"],
            )  # fmt: skip


def _solo_step(slots: int) -> float:
    return min(7.0, 26.0 / max(slots - 1, 1))


def _solo_aside(part: dict[str, Any]) -> float:
    step = _solo_step(part["slots"])
    if part["band"]:
        return float((6 + band_lines(part["band"])[0] * part["band"]) / 2 + 5 + step * part["slot"])
    return float((part["slot"] - (part["slots"] - 1) / 2) * step)


def _beside(x: float, y: float, taken: list[Point]) -> float:
    """Return where a mark near (x, y) covers none before it: there, or moved along the row."""
    for turn in range(24):
        left = x + (1 if turn % 2 else -1) * ((turn + 1) // 2) * 12
        if all(abs(left - a) > 19 or abs(y - b) > 19 for a, b in taken):
            break
    taken.append((left, y))
    return left


def _marks(document: dict[str, Any], view: _View, cover: Cover) -> Iterator[Markup]:
    taken: list[Point] = []
    for end, fragment, word in (
        ("origin", "static-start", "from"),
        ("destination", "static-end", "to"),
    ):
        spots: dict[Point, list[dict[str, Any]]] = {}
        for vehicle in document["vehicles"]:
            spots.setdefault((vehicle[end]["lon"], vehicle[end]["lat"]), []).append(vehicle)
        for at, vehicles in spots.items():
            x, y = view.at(*at)
            letters = ", ".join(vehicle["letter"] for vehicle in vehicles)
            faces = [(vehicle["colour"], vehicle["letter"]) for vehicle in vehicles]
            if len(vehicles) > MOST_ENDS:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
            for place, (colour, letter) in enumerate(faces):
                left = _beside(x + 21 * (place - (len(faces) - 1) / 2), y, taken)
                cover.add_box(Box(left - 10, y - 10, 20, 20))
                yield fill(
                    fragment, x=f"{left:.1f}", y=f"{y:.1f}", colour=colour, letter=letter,
                    size=LETTER_SIZE[min(len(letter), 3)],
                    title=f"{letters} {word} {vehicles[0][end]['name']}",
                )  # fmt: skip
    for event in document["events"]:
        x, y = view.at(event["lon"], event["lat"])
        x = _beside(x, y, taken)
        cover.add_box(Box(x - 12, y - 12, 24, 24))
        yield fill(
            "static-event", x=f"{x:.1f}", y=f"{y:.1f}", icon=event["kind"],
            title=f"{event['name']}: {event['text']}",
        )  # fmt: skip


CALLOUT_HEIGHT = 34.0
WIDEST_CALLOUT = 230.0


def _callouts(document: dict[str, Any], view: _View, cover: Cover) -> Iterator[Markup]:
    for event in document["events"]:
        x, y = view.at(event["lon"], event["lat"])
        head = _clipped(f"{event['kind'].capitalize()}: {event['name']}", 11.5, True)
        line = _clipped(event["text"], 11, False)
        width = 16 + max(text_width(head, 11.5, True), text_width(line, 11))
        box = cover.place(_around(x, y, width, CALLOUT_HEIGHT, (16, 30, 48, 70, 100)), 1_000)
        if box is None:
            continue
        near = min(max(x, box.left), box.right), min(max(y, box.top), box.bottom)
        far = math.hypot(near[0] - x, near[1] - y) > 20
        leader = fill(
            "static-leader", x1=f"{x:.1f}", y1=f"{y:.1f}", x2=f"{near[0]:.1f}", y2=f"{near[1]:.1f}"
        ) if far else Markup("")  # fmt: skip
        yield fill(
            "static-callout", leader=leader, x=f"{box.left:.1f}", y=f"{box.top:.1f}",
            width=f"{width:.1f}", text_x=f"{box.left + 8:.1f}", head_y=f"{box.top + 14:.1f}",
            line_y=f"{box.top + 28:.1f}", head=head, line=line,
        )  # fmt: skip


def _clipped(text: str, size: float, bold: bool) -> str:
    while len(text) > 2 and text_width(text, size, bold) > WIDEST_CALLOUT:
        text = text[: max(1, int(len(text) * 0.9) - 1)].rstrip("\u2026 ") + "\u2026"
    return text


def _around(
    x: float, y: float, width: float, height: float, distances: Sequence[float]
) -> Iterator[tuple[Box, float]]:
    """Yield boxes around a point, each with what its distance costs."""
    for away in distances:
        lefts = (x - width / 2, x - width - away * 0.5, x + away * 0.5, x - width - away, x + away)
        for left in lefts:
            for top in (y - height - away, y + away):
                yield Box(left, top, width, height), away * 0.5
        yield Box(x + away, y - height / 2, width, height), away * 0.5
        yield Box(x - away - width, y - height / 2, width, height), away * 0.5


def _names(document: dict[str, Any], view: _View, cover: Cover) -> Iterator[Markup]:
    placed: list[tuple[float, float, float]] = []
    for lon, lat, name, rank in document["towns"]:
        x, y = view.at(lon / BASEMAP_STEPS, lat / BASEMAP_STEPS)
        if rank > 1 or not (0 < x < WIDTH and 0 < y < view.height):
            continue
        text = _clipped(name, 11.5, False)
        width = text_width(text, 11.5)
        # A blank margin round the text keeps names apart, a wide one thins out lesser towns.
        gap = 18 if rank else 6
        if any(
            abs(x - other_x) < (width + other) / 2 + gap and abs(y - other_y) < 18 + gap / 2
            for other_x, other_y, other in placed
        ):
            continue
        places = (
            (Box(x - width / 2 - 4, y - 20, width + 8, 18), 0.0),
            (Box(x - width / 2 - 4, y + 3, width + 8, 18), 0.5),
            (Box(x + 2, y - 9, width + 8, 18), 1.0),
            (Box(x - width - 10, y - 9, width + 8, 18), 1.0),
            (Box(x - width / 2 - 4, y - 30, width + 8, 18), 1.5),
            (Box(x - width / 2 - 4, y + 12, width + 8, 18), 1.5),
        )
        box = cover.place(places, 8.0)
        if box is not None:
            placed.append((x, y, width))
            yield fill("static-name", x=f"{box.left + 4:.1f}", y=f"{box.top + 13:.1f}", text=text)


def _scale(view: _View, cover: Cover) -> Markup:
    metres_per_pixel = 111_320 * math.cos(math.radians(view.latitude)) / max(view.per_degree, 1e-9)
    widest = 120 * metres_per_pixel
    step = 10 ** math.floor(math.log10(widest))
    length = max(factor * step for factor in (1, 2, 5) if factor * step <= widest)
    width = length / metres_per_pixel
    cover.add_box(Box(4, view.height - 32, width + 20, 30))
    return fill(
        "static-scale", y=f"{view.height - 14:g}", width=f"{width:.1f}", text=_round_length(length)
    )


def _round_length(length_m: float) -> str:
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"
