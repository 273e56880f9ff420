"""The project's own saved form: one file, opened by mapping it into memory.

Layout: 7 bytes of magic and one of format version, the length of the header (uint64, little
endian), the header's sha256 (32 bytes), the header as JSON (source, report, for every array its
dtype, shape and offset, and the sha256 of all arrays), then the arrays, each aligned to 64 bytes.

A damaged file must not give wrong answers. On opening, the header is compared with its hash, and
every array of positions is checked; the arrays themselves are hashed where that takes a few
milliseconds, or when asked for.
"""

from __future__ import annotations

import hashlib
import json
import os
from operator import attrgetter
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...atomic_file import whole_file
from ...errors import MapDataError, NetworkError
from ...output_paths import SAVED
from ..columns import COLUMNS, POINT_KINDS, Per, columns_per
from ..load_report import LoadReport, Source
from ..road_network import NamedPoints, RoadNetwork, checked_network
from ..texts import TextTable
from .beginning import FORMAT_VERSION, MAGIC, READABLE
from .checks import check_arrays

__all__ = ["FORMAT_VERSION", "MAGIC", "open_network", "save_network"]

ALIGNMENT = 64
BEFORE_HEADER = len(MAGIC) + 1 + 8 + 32

KINDS_OF_3 = ("services", "rest_area", "city", "town", "village")
"""Kinds of points that version 3 knew, in the order of its codes."""

SOON_HASHED_BYTES = 16 * 2**20
"""Up to this size a file is hashed whenever it is opened: about 10 ms."""


def save_network(net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write a network so that `open_network` needs only to map the file.

    The file appears whole or not at all: it is written beside its place and then renamed.

    Parameters
    ----------
    net : RoadNetwork
        What to write.
    path : path-like
        The file; `load_network` knows it by its content, people by the suffix `.platoon`.

    Raises
    ------
    MapDataError
        The file cannot be written.
    NetworkError
        The network was not made by `from_edges` and its arrays do not fit each other.
    """
    arrays = _arrays(checked_network(net))
    try:
        check_arrays(arrays)
    except ValueError as error:
        raise NetworkError(f"network: {error}; make it with RoadNetwork.from_edges") from error
    index: dict[str, dict[str, Any]] = {}
    offset = 0
    digest = hashlib.sha256()
    for name, array in arrays.items():
        index[name] = {"dtype": array.dtype.str, "shape": array.shape, "offset": offset}
        offset += -(-array.nbytes // ALIGNMENT) * ALIGNMENT
        digest.update(_padded(array))
    header = json.dumps(
        {
            "source": net.source.to_dict(),
            "report": net.load_report.to_dict(),
            "arrays": index,
            "payload_bytes": offset,
            "payload_sha256": digest.hexdigest(),
        }
    ).encode()
    header += b" " * (-(BEFORE_HEADER + len(header)) % ALIGNMENT)
    draft_of = whole_file(as_path(path), MapDataError, suffixes=SAVED)
    with draft_of as draft, draft.open("wb") as out:
        out.write(MAGIC + bytes([FORMAT_VERSION]) + len(header).to_bytes(8, "little"))
        out.write(hashlib.sha256(header).digest() + header)
        for array in arrays.values():
            out.write(_padded(array))


def open_network(path: str | os.PathLike[str], *, verify: bool | None = None) -> RoadNetwork:
    """Open a saved network; its arrays stay on disk until they are used.

    Parameters
    ----------
    path : path-like
        A file written by `save_network`.
    verify : bool, optional
        Whether to compare all arrays with the hash they were saved with; by default only where
        that takes a few milliseconds, up to 16 MB. Damage to arrays of positions is always found.

    Returns
    -------
    RoadNetwork
        Its arrays are views of the file.

    Raises
    ------
    MapDataError
        Not a saved network, cut short, damaged, or written by another version of the format.
    """
    file = as_path(path)
    try:
        with file.open("rb") as handle:
            start = handle.read(BEFORE_HEADER)
            if not start.startswith(MAGIC):
                raise MapDataError(f"{file}: not a saved network; make one with `prepare`")
            if len(start) < BEFORE_HEADER:
                raise _damaged(file, "its header is cut short")
            version = start[len(MAGIC)]
            if version not in READABLE:
                formats = " and ".join(map(str, READABLE))
                raise MapDataError(
                    f"{file}: saved in format {version}, this version reads {formats}; run "
                    "`platoon-osm prepare` on the source again"
                )
            header_bytes = int.from_bytes(start[len(MAGIC) + 1 : -32], "little")
            size = file.stat().st_size
            if header_bytes > size:
                raise _damaged(file, "its header is cut short")
            content = handle.read(header_bytes)
        if hashlib.sha256(content).digest() != start[-32:]:
            raise _damaged(file, "its header does not match its checksum")
        header = json.loads(content)
        begin = len(start) + header_bytes
        if size != begin + header["payload_bytes"]:
            raise _damaged(file, f"{size - begin:,} bytes of {header['payload_bytes']:,}")
        payload = np.memmap(file, np.uint8, "r", begin, (header["payload_bytes"],))
        if verify is None:
            verify = len(payload) <= SOON_HASHED_BYTES
        if verify and hashlib.sha256(payload.data).hexdigest() != header["payload_sha256"]:
            raise _damaged(file, "its arrays do not match their checksum")
        arrays = {name: _view(payload, item) for name, item in header["arrays"].items()}
        if version != FORMAT_VERSION:
            arrays |= _later_columns(arrays)
        check_arrays(arrays)
        return _network(arrays, header, file.absolute())
    except OSError as error:
        raise MapDataError(
            f"{file}: cannot be read ({error.strerror}); check the path and its rights"
        ) from error
    except (KeyError, TypeError, ValueError) as error:
        # The header is as it was written, so another program wrote it, or one of the future.
        raise _damaged(file, " ".join(str(error).split())[:100]) from error


def as_path(path: Any) -> Path:
    """Refuse what cannot name a file.

    Parameters
    ----------
    path : object
        What somebody gave.

    Returns
    -------
    Path
        The same, as a path.

    Raises
    ------
    MapDataError
        It is no path, or one that no file can have.
    """
    try:
        name = os.fspath(path)
    except TypeError:
        name = b""
    if not isinstance(name, str) or "\0" in name:
        shown = " ".join(repr(path).split())[:80]
        raise MapDataError(f"file {shown}: give the path of a saved network as text or Path")
    return Path(name)


def _damaged(file: Path, why: str) -> MapDataError:
    return MapDataError(
        f"{file}: saved network is damaged or cut short ({why}); run `platoon-osm prepare` again"
    )


def _padded(array: NDArray[Any]) -> bytes:
    return np.ascontiguousarray(array).tobytes() + b"\0" * (-array.nbytes % ALIGNMENT)


def _arrays(net: RoadNetwork) -> dict[str, NDArray[Any]]:
    arrays = {column.name: attrgetter(column.name)(net) for column in COLUMNS}
    arrays["texts.offsets"] = net.texts.offsets
    arrays["texts.blob"] = net.texts.blob
    return arrays


def _view(payload: NDArray[np.uint8], item: dict[str, Any]) -> NDArray[Any]:
    dtype = np.dtype(item["dtype"])
    count = int(np.prod(item["shape"], dtype=np.int64))
    part = payload[item["offset"] : item["offset"] + count * dtype.itemsize]
    array: NDArray[Any] = np.asarray(part).view(dtype).reshape(item["shape"])
    return array


def _later_columns(arrays: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Return the defaults of columns that an earlier version did not save, and that are missing."""
    counts: dict[Per, int] = {
        "node": len(arrays["lon"]),
        "edge": len(arrays["tail"]),
        "named point": len(arrays["points.lon"]),
    }
    missing = [
        column
        for column in columns_per(*counts)
        if column.default is not None and column.name not in arrays
    ]
    if not missing:
        raise ValueError("it holds more than its version knows")
    added = {column.name: column.filled(counts[column.per]) for column in missing}
    kinds = arrays["points.kind"]
    if len(kinds) and kinds.max() >= len(KINDS_OF_3):
        raise ValueError(f"points.kind points beyond its {len(KINDS_OF_3)} entries")
    own = np.array([POINT_KINDS.index(kind) for kind in KINDS_OF_3], np.uint8)
    return {**added, "points.kind": own[kinds]}


def _network(arrays: dict[str, Any], header: dict[str, Any], file: Path) -> RoadNetwork:
    points = NamedPoints(*(arrays.pop(column.name) for column in columns_per("named point")))
    texts = TextTable(arrays.pop("texts.offsets"), arrays.pop("texts.blob"))
    report = header["report"]
    return RoadNetwork(
        **arrays,
        texts=texts,
        points=points,
        source=Source(**header["source"]),
        load_report=LoadReport(report["counts"], tuple(report["remarks"])),
        _file=file,
    )
