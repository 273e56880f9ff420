"""The project's own saved form: one file, opened by mapping it into memory.

Layout: 8 bytes of magic, the length of the header (uint64, little endian), the header as JSON
(format version, source, report, and for every array its dtype, shape and offset), then the arrays,
each aligned to 64 bytes. Nothing is parsed on opening but the header.
"""

from __future__ import annotations

import json
import os
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MapDataError
from ..whole_file import whole_file
from .load_report import LoadReport, Source
from .road_network import NamedPoints, RoadNetwork
from .texts import TextTable

__all__ = ["FORMAT_VERSION", "MAGIC", "open_network", "save_network"]

MAGIC = b"PLTNNET\x01"
FORMAT_VERSION = 1
ALIGNMENT = 64


def save_network(net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write a network so that `open_network` needs only to map the file.

    The file appears whole or not at all: it is written beside its place and then renamed.
    """
    arrays = _arrays(net)
    index: dict[str, dict[str, Any]] = {}
    offset = 0
    for name, array in arrays.items():
        index[name] = {"dtype": array.dtype.str, "shape": array.shape, "offset": offset}
        offset += -(-array.nbytes // ALIGNMENT) * ALIGNMENT
    header = json.dumps(
        {
            "version": FORMAT_VERSION,
            "source": net.source.to_dict(),
            "report": net.load_report.to_dict(),
            "arrays": index,
            "payload_bytes": offset,
        }
    ).encode()
    header += b" " * (-(len(MAGIC) + 8 + len(header)) % ALIGNMENT)
    with whole_file(path, MapDataError) as draft, draft.open("wb") as out:
        out.write(MAGIC + len(header).to_bytes(8, "little") + header)
        for array in arrays.values():
            out.write(np.ascontiguousarray(array).tobytes())
            out.write(b"\0" * (-array.nbytes % ALIGNMENT))


def open_network(path: str | os.PathLike[str]) -> RoadNetwork:
    """Open a saved network; its arrays stay on disk until they are used.

    Raises
    ------
    MapDataError
        Not a saved network, cut short, or written by another version of the format.
    """
    file = Path(path)
    try:
        with file.open("rb") as handle:
            start = handle.read(len(MAGIC) + 8)
            if len(start) < len(MAGIC) + 8 or not start.startswith(MAGIC):
                raise MapDataError(f"{file}: not a saved network; make one with `prepare`")
            header_bytes = int.from_bytes(start[len(MAGIC) :], "little")
            size = file.stat().st_size
            if header_bytes > size:
                raise _cut_short(file)
            try:
                header = json.loads(handle.read(header_bytes))
            except ValueError as error:
                raise _cut_short(file) from error
        if not isinstance(header, dict):
            raise _cut_short(file)
        if header.get("version") != FORMAT_VERSION:
            raise MapDataError(
                f"{file}: saved in format {header.get('version')}, this version reads "
                f"{FORMAT_VERSION}; run `platoon-osm prepare` on the source again"
            )
        begin = len(start) + header_bytes
        if size < begin + header["payload_bytes"]:
            raise _cut_short(file)
        payload = np.memmap(file, np.uint8, "r", begin, (header["payload_bytes"],))
        arrays = {name: _view(payload, item) for name, item in header["arrays"].items()}
        net = _network(arrays, header)
        net._kept["file"] = file.absolute()
        return net
    except OSError as error:
        raise MapDataError(f"{file}: cannot be read ({error.strerror})") from error
    except (KeyError, TypeError, ValueError) as error:
        raise _cut_short(file) from error


def _cut_short(file: Path) -> MapDataError:
    return MapDataError(
        f"{file}: saved network is damaged or cut short; run `platoon-osm prepare` again"
    )


def _arrays(net: RoadNetwork) -> dict[str, NDArray[Any]]:
    arrays = {
        item.name: value
        for item in fields(net)
        if isinstance(value := getattr(net, item.name), np.ndarray)
    }
    for item in fields(net.points):
        arrays[f"points.{item.name}"] = getattr(net.points, item.name)
    arrays["texts.offsets"] = net.texts.offsets
    arrays["texts.blob"] = net.texts.blob
    return arrays


def _view(payload: NDArray[np.uint8], item: dict[str, Any]) -> NDArray[Any]:
    dtype = np.dtype(item["dtype"])
    count = int(np.prod(item["shape"], dtype=np.int64))
    part = payload[item["offset"] : item["offset"] + count * dtype.itemsize]
    array: NDArray[Any] = np.asarray(part).view(dtype).reshape(item["shape"])
    return array


def _network(arrays: dict[str, Any], header: dict[str, Any]) -> RoadNetwork:
    points = NamedPoints(
        **{item.name: arrays.pop(f"points.{item.name}") for item in fields(NamedPoints)}
    )
    texts = TextTable(arrays.pop("texts.offsets"), arrays.pop("texts.blob"))
    report = header["report"]
    return RoadNetwork(
        **arrays,
        texts=texts,
        points=points,
        source=Source(**header["source"]),
        load_report=LoadReport(report["counts"], tuple(report["remarks"])),
    )
