"""Compare the exits of the tables in maps/italy/ with the waypoints of Travel Mapping.

    python maps/build_italy.py --waypoints HighwayData/hwy_data/ITA/itaa

Travel Mapping (https://github.com/TravelMapping/HighwayData) lists the exits of every motorway, as
files of lines "label URL" with the position in the URL. A label that begins with "+" is a bend.
"""

from __future__ import annotations

import re
from pathlib import Path

from italy_towns import Exit, distance_km

NEAR_KM = 2.0
"""How near an exit of ours must lie to be the same one."""

LINE = re.compile(r"(\S+) .*[?&]lat=(-?[0-9.]+)&lon=(-?[0-9.]+)\s*")


def read_waypoints(path: Path) -> list[Exit]:
    """Give the exits of one file, bends left out; lines of another form are none."""
    lines = map(LINE.fullmatch, path.read_text(encoding="utf-8").splitlines())
    found = [line.groups() for line in lines if line]
    return [
        Exit(path.stem, label, float(lat), float(lon))
        for label, lat, lon in found
        if not label.startswith("+")
    ]


def compare_waypoints(exits: list[Exit], folder: Path) -> list[str]:
    """Say for how many of their exits one of ours is near, and name the others."""
    theirs = [point for path in sorted(folder.glob("*.wpt")) for point in read_waypoints(path)]
    if not theirs:
        return [f"{folder}: holds no waypoints; give the folder with the .wpt files of Italy"]
    gaps = []
    for point in theirs:
        at = point.lat, point.lon
        gaps.append(min((distance_km(at, (ours.lat, ours.lon)), ours) for ours in exits))
    near = sum(km <= NEAR_KM for km, _ in gaps)
    share = f"{near / len(gaps):.1%}"
    lines = [f"{near} of {len(gaps)} waypoints ({share}) have an exit within {NEAR_KM:g} km"]
    return lines + [
        f"look:  {point.motorway} {point.name}: {km:.1f} km from {ours.motorway} {ours.name}"
        for (km, ours), point in sorted(zip(gaps, theirs, strict=True), reverse=True)
        if km > NEAR_KM
    ]
