"""What stands behind the figures, as CSV; and every vehicle at every point, as Parquet."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..atomic_file import whole_file
from ..csv_tables import write_table
from ..report.language.speech import speaking
from .comparison import PRINTED, Row, network_label
from .example import Example
from .measures import INVOLVEMENTS, TOTALS, Measures
from .monte_carlo import StudyResult
from .one_run import DRIVES_AFTER, DRIVES_BEFORE, JOINED, MASTER_GOES_ON, MASTER_UNDERWAY
from .random_network import Draw

__all__ = [
    "write_comparison", "write_costs", "write_involvement", "write_network", "write_parquet",
]  # fmt: skip


DIGITS = 9
"""Of numbers in CSV, so that the same numbers are the same bytes."""


def write_comparison(path: Path, rows: Sequence[Row]) -> None:
    """Write the comparison, one printed number under one reading a line.

    Parameters
    ----------
    path : Path
        The file to write.
    rows : sequence of Row
        Of `compare`.
    """
    header = [
        "number", "paper", "unit", "network", "mixing", "terms", "counted", "method", "ours",
        "low_95", "high_95", "agrees",
    ]  # fmt: skip
    with speaking("en"):
        names = {number: printed.label for number, printed in PRINTED.items()}
    write_table(path, header, (
        [
            names[row.number],
            " to ".join(f"{v:g}" for v in PRINTED[row.number].value), PRINTED[row.number].unit,
            row.network, row.mixing, row.terms, row.counted, row.method, row.ours.value,
            row.ours.low, row.ours.high, int(row.agrees()),
        ]
        for row in rows
    ), DIGITS)  # fmt: skip


def write_costs(path: Path, results: Sequence[StudyResult]) -> None:
    """Write the two cost surfaces over tau and xi, for every reading and method.

    Parameters
    ----------
    path : Path
        The file to write.
    results : sequence of StudyResult
        One for each placing of the vehicles.
    """
    header = [
        "network", "method", "mixing", "terms", "total", "tau_percent", "xi_percent", "alone_km",
        "joint_km",
        "saving_percent",
    ]  # fmt: skip

    def rows() -> Iterable[Sequence[object]]:
        for result in results:
            for k, method in enumerate(result.study.methods):
                for x, reading in enumerate(result.study.readings):
                    found = Measures(result, k, x)
                    for total in TOTALS:
                        alone, joint = found.cost_surfaces(total)
                        for (tau, xi), a, b in zip(
                            result.study.grid_points().tolist(), alone, joint, strict=True
                        ):
                            yield [
                                network_label(result), method, reading.mixing, reading.terms,
                                total, 100 * tau, 100 * xi,
                                float(a) / 1000, float(b) / 1000, 100 * (1 - float(b) / float(a)),
                            ]  # fmt: skip

    write_table(path, header, rows(), DIGITS)


def write_involvement(path: Path, results: Sequence[StudyResult], method: str) -> None:
    """Write the share of members taking part over tau and xi, for every reading.

    Parameters
    ----------
    path : Path
        The file to write.
    results : sequence of StudyResult
        One for each placing of the vehicles.
    method : {"dijkstra", "astar", "astar-closed-once"}
        One that all of them ran.
    """
    header = [
        "network", "mixing", "terms", "counted", "tau_percent", "xi_percent", "involved_percent",
    ]  # fmt: skip

    def rows() -> Iterable[Sequence[object]]:
        for result in results:
            k = [*result.study.methods].index(method)  # type: ignore[arg-type]
            for x, reading in enumerate(result.study.readings):
                found = Measures(result, k, x)
                for name in INVOLVEMENTS:
                    surface = found.involvement(name)[0]
                    for (tau, xi), share in zip(
                        result.study.grid_points().tolist(), surface, strict=True
                    ):
                        yield [
                            network_label(result), reading.mixing, reading.terms, name,
                            100 * tau, 100 * xi, 100 * float(share),
                        ]  # fmt: skip

    write_table(path, header, rows(), DIGITS)


def write_network(path: Path, examples: Sequence[tuple[str, Example]]) -> None:
    """Write the lines and points of the network figure.

    Parameters
    ----------
    path : Path
        The file to write.
    examples : sequence of (str, Example)
        A title and a run for each panel.
    """
    header = ["panel", "item", "vehicle", "from_x_km", "from_y_km", "to_x_km", "to_y_km"]

    def rows() -> Iterable[Sequence[object]]:
        for label, example in examples:
            draw = example.draw
            net = draw.net
            for edge in range(net.m):
                item = "access" if draw.access[edge] else "road"
                yield [label, item, "", *_ends(draw, edge)]
            for vehicle, parts in enumerate(example.routes):
                role = "master" if vehicle == example.master else "alone"
                for item, part in zip((role, "platoon", role), parts, strict=True):
                    for edge in part.tolist():
                        longest = item == "platoon" and vehicle == example.longest
                        shown = "longest platoon" if longest else item
                        yield [label, shown, vehicle, *_ends(draw, edge)]
            for vehicle, node in enumerate(draw.origins.tolist()):
                at = (float(draw.x_m[node]) / 1000, float(draw.y_m[node]) / 1000)
                yield [label, "spawn point", vehicle, *at, "", ""]

    write_table(path, header, rows(), DIGITS)


def _ends(draw: Draw, edge: int) -> tuple[float, ...]:
    """Return x and y of an edge's tail and head [km]."""
    nodes = int(draw.net.tail[edge]), int(draw.net.head[edge])
    return tuple(float(a[node]) / 1000 for node in nodes for a in (draw.x_m, draw.y_m))


def write_parquet(path: Path, results: Sequence[StudyResult]) -> None:
    """Write one row for each placing, run, method, mixing, point and vehicle.

    Costs are those of the first choice of terms; with others the rows would be many times as many.

    Parameters
    ----------
    path : Path
        The file to write.
    results : sequence of StudyResult
        One for each placing of the vehicles.
    """
    import pyarrow
    from pyarrow import parquet

    schema = pyarrow.schema(
        [
            ("network", pyarrow.dictionary(pyarrow.int8(), pyarrow.string())),
            ("method", pyarrow.dictionary(pyarrow.int8(), pyarrow.string())),
            ("mixing", pyarrow.dictionary(pyarrow.int8(), pyarrow.string())),
            ("run", pyarrow.int32()), ("vehicle", pyarrow.int16()),
            ("tau", pyarrow.float32()), ("xi", pyarrow.float32()), ("is_master", pyarrow.bool_()),
            ("applicable", pyarrow.bool_()), ("cost_alone_m", pyarrow.float64()),
            ("cost_joint_m", pyarrow.float64()), ("platoon_km", pyarrow.float32()),
            ("merge_node", pyarrow.int32()), ("separation_node", pyarrow.int32()),
            *((name, pyarrow.bool_()) for name in HOW),
        ]
    )  # fmt: skip
    with whole_file(path) as draft, parquet.ParquetWriter(draft, schema, compression="zstd") as out:
        for result in results:
            for k in range(len(result.study.methods)):
                for x in range(len(result.study.mixings)):
                    columns = _columns(result, k, x)
                    out.write_table(pyarrow.table(columns, schema=schema))


HOW = {
    "joined": JOINED, "drives_alone_before": DRIVES_BEFORE, "drives_alone_after": DRIVES_AFTER,
    "master_underway": MASTER_UNDERWAY, "master_goes_on": MASTER_GOES_ON,
}  # fmt: skip


def _columns(result: StudyResult, k: int, x: int) -> dict[str, object]:
    import pyarrow

    joint = result.joint(k, x)
    runs, vehicles = joint.shape[:2]

    def spread(values: NDArray[Any], axes: tuple[int, ...]) -> NDArray[Any]:
        return np.broadcast_to(np.expand_dims(values, axes), joint.shape).ravel()

    def same(text: str) -> object:
        codes = np.zeros(joint.size, np.int8)
        return pyarrow.DictionaryArray.from_arrays(codes, pyarrow.array([text]))

    at = result.study.grid_points().astype(np.float32)
    how = result.of("how", k, x).ravel()
    return {
        "network": same(network_label(result)), "method": same(result.study.methods[k]),
        "mixing": same(result.study.mixings[x]),
        "run": spread(np.arange(runs, dtype=np.int32), (1, 2)),
        "vehicle": spread(np.arange(vehicles, dtype=np.int16), (0, 2)),
        "tau": spread(at[:, 0], (0, 1)), "xi": spread(at[:, 1], (0, 1)),
        "is_master": spread(~result.is_member(), (2,)),
        "applicable": spread(result.applicable[:, k], (2,)),
        "cost_alone_m": spread(result.solo(k, x), (2,)), "cost_joint_m": joint.ravel(),
        "platoon_km": (result.of("platoon_m", k, x).ravel() / 1000).astype(np.float32),
        "merge_node": result.of("merge", k, x).ravel(),
        "separation_node": result.of("separation", k, x).ravel(),
        **{name: (how & bit) > 0 for name, bit in HOW.items()},
    }  # fmt: skip
