"""The instances from a folder: as tables, or as their authors published them.

Tables are `links.csv`, `instances.csv` and `published.csv`. The published folder has
`Link list.csv` and, for each set, `ODdata_x_y.npy` and `deptimes_x_y.npy`, y being the number of an
instance of x trucks; it may lie in a folder `data`. Its savings are not among them.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from ...errors import ScenarioError, brief
from ...kinds import is_number, is_whole
from .pickled import plain_objects
from .records import SETS, DutchData, DutchInstance, DutchTruck, Published

__all__ = ["read_dutch"]

NAMED = re.compile(r"ODdata_(\d+)_(\d+)\.npy")

CITIES = 20


def read_dutch(folder: Path) -> DutchData:
    """Read the instances.

    Parameters
    ----------
    folder : Path
        Of tables, or the published one.

    Returns
    -------
    DutchData
        With what was published about them, if the folder says it.

    Raises
    ------
    ScenarioError
        Another folder, or a file that is broken.
    """
    if (folder / "instances.csv").is_file():
        return DutchData(
            tuple(_links(folder / "links.csv", ("from", "to", "km"), ",")),
            tuple(_instances(folder / "instances.csv")),
            dict(_published(folder / "published.csv")),
        )
    inside = folder / "data" if (folder / "data" / "Link list.csv").is_file() else folder
    if (inside / "Link list.csv").is_file():
        columns = ("From Node", "To Node", "Distance in km")
        return DutchData(
            tuple(_links(inside / "Link list.csv", columns, ";")), tuple(_originals(inside)), {}
        )
    raise ScenarioError(
        f"{folder}: holds neither instances.csv nor 'Link list.csv'; give the folder of the "
        "published instances (doi 10.1287/ijoc.2020.0302.cd)"
    )


def _rows(path: Path, columns: Iterable[str], part: str) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield where each row stands, and its cells."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise ScenarioError(f"{path}: is missing; the folder needs it") from None
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{path}: cannot be read; give the published file") from error
    reader = csv.DictReader(text.splitlines(), delimiter=part)
    missing = [name for name in columns if name not in (reader.fieldnames or ())]
    if missing:
        raise ScenarioError(f"{path}: has no column {missing[0]!r}; give the published file")
    for row in reader:
        yield f"{path}, line {reader.line_num}", row


def _number(where: str, row: Mapping[str, Any], name: str) -> float:
    try:
        found = float(row[name])
        if found != found or abs(found) > 1e9:
            raise ValueError
    except (TypeError, ValueError):
        raise ScenarioError(f"{where}: {name} is {brief(row[name])}; give a number") from None
    return found


def _whole(where: str, row: Mapping[str, Any], name: str) -> int:
    found = _number(where, row, name)
    if found != int(found) or found < 0:
        raise ScenarioError(f"{where}: {name} is {brief(row[name])}; give a whole number")
    return int(found)


def _links(
    path: Path, columns: tuple[str, str, str], part: str
) -> Iterator[tuple[int, int, float]]:
    found = 0
    for where, row in _rows(path, columns, part):
        if not any(row.get(name) for name in columns):
            continue
        a, b = (_whole(where, row, name) for name in columns[:2])
        km = _number(where, row, columns[2])
        if km <= 0 or a == b:
            raise ScenarioError(f"{where}: {a} to {b} is {km:g} km; give a length above 0")
        found += 1
        yield a, b, km
    if not found:
        raise ScenarioError(f"{path}: names no links; give the published file")


def _instances(path: Path) -> Iterator[DutchInstance]:
    columns = ("set", "n_trucks", "instance", "origin", "destination", "dep_min")
    groups: dict[tuple[str, int, int], list[DutchTruck]] = {}
    for where, row in _rows(path, columns, ","):
        key = (row["set"], _whole(where, row, "n_trucks"), _whole(where, row, "instance"))
        groups.setdefault(key, []).append(
            _truck(
                where, _whole(where, row, "origin"), _whole(where, row, "destination"),
                _number(where, row, "dep_min"),
            )
        )  # fmt: skip
    for (name, trucks, number), own in groups.items():
        if len(own) != trucks:
            raise ScenarioError(
                f"{path}: instance {number} of {brief(name)} has {len(own)} trucks of {trucks}"
            )
        yield DutchInstance(name, number, tuple(own))


def _truck(where: str, origin: int, destination: int, departure_min: float) -> DutchTruck:
    if origin == destination:
        raise ScenarioError(f"{where}: goes from city {origin} to itself; give two cities")
    return DutchTruck(origin, destination, departure_min)


def _published(path: Path) -> Iterator[tuple[tuple[str, int, int, int, int], Published]]:
    columns = (
        "set", "n_trucks", "flexibility_min", "max_trucks_per_platoon", "platoons_per_trip",
        "fuel_savings_pct", "platoon_km_pct", "trucks_in_platoon_pct",
    )  # fmt: skip
    for where, row in _rows(path, columns, ","):
        many = row["platoons_per_trip"]
        if many not in ("1", "inf"):
            raise ScenarioError(f"{where}: platoons_per_trip is {brief(many)}; use 1 or inf")
        key = tuple(_whole(where, row, name) for name in columns[1:4])
        yield (
            (row["set"], key[0], key[1], key[2], 1 if many == "1" else 0),
            Published(*(_number(where, row, name) for name in columns[5:])),
        )


def _originals(folder: Path) -> Iterator[DutchInstance]:
    """Yield the instances as their authors published them."""
    found = 0
    for name in SETS:
        files = [
            (int(match[1]), int(match[2]), path)
            for path in (folder / name).glob("ODdata_*.npy")
            if (match := NAMED.fullmatch(path.name))
        ]
        for trucks, number, path in sorted(files):
            ends = _items(path, plain_objects(path), trucks)
            beside = path.with_name(f"deptimes_{trucks}_{number}.npy")
            times = _items(beside, plain_objects(beside), trucks)
            found += 1
            yield DutchInstance(
                name, number,
                tuple(
                    _truck(str(path), *_ends(path, both), _time(beside, at))
                    for both, at in zip(ends, times, strict=True)
                ),
            )  # fmt: skip
    if not found:
        raise ScenarioError(
            f"{folder}: holds no instances (ODdata_x_y.npy in {', '.join(SETS)}); give the "
            "published folder"
        )


def _items(path: Path, found: Any, trucks: int) -> list[Any]:
    """Return what is said of each truck, from a list, or a mapping by truck."""
    if isinstance(found, Mapping):
        keys = list(found)
        if all(is_whole(key) for key in keys):
            keys.sort()
        found = [found[key] for key in keys]
    if not isinstance(found, list | tuple) or len(found) != trucks:
        raise ScenarioError(f"{path}: does not hold {trucks} trucks; take the published file")
    return list(found)


def _ends(path: Path, both: Any) -> tuple[int, int]:
    both = both.tolist() if hasattr(both, "tolist") else both
    if isinstance(both, list | tuple) and len(both) == 2 and all(is_whole(end) for end in both):
        return int(both[0]), int(both[1])
    raise ScenarioError(f"{path}: {brief(both)} is no origin and destination; take the published")


def _time(path: Path, at: Any) -> float:
    at = at.item() if hasattr(at, "item") else at
    if is_number(at):
        return float(at)
    raise ScenarioError(f"{path}: {brief(at)} is no departure in minutes; take the published file")
