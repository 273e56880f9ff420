"""The bytes of a map file and what to say about where they came from."""

from __future__ import annotations

import gzip
import hashlib
import zlib
from pathlib import Path

from ..errors import MapDataError
from ..network.load_report import Source

__all__ = ["ATTRIBUTION", "LICENCE", "file_digest", "osm_source", "read_bytes"]

LICENCE = "ODbL 1.0"
ATTRIBUTION = "© OpenStreetMap contributors"


def read_bytes(file: Path) -> tuple[bytes, str]:
    """Return a file's content, unpacked if it is gzip, and the sha256 of the file itself.

    Parameters
    ----------
    file : Path
        The file.

    Returns
    -------
    tuple[bytes, str]
        Content, and hex digest.

    Raises
    ------
    MapDataError
        The file cannot be read or its compression is broken.
    """
    try:
        content = file.read_bytes()
    except OSError as error:
        raise MapDataError(f"{file}: cannot be read ({error.strerror}); check the path") from error
    digest = hashlib.sha256(content).hexdigest()
    if content.startswith(b"\x1f\x8b"):
        try:
            content = gzip.decompress(content)
        except (OSError, EOFError, zlib.error) as error:
            raise MapDataError(f"{file}: gzip is cut short or damaged; fetch it again") from error
    return content, digest


def file_digest(file: Path) -> str:
    """Return the sha256 of a file, read piece by piece.

    Parameters
    ----------
    file : Path
        The file.

    Returns
    -------
    str
        Hex digest.

    Raises
    ------
    MapDataError
        The file cannot be read.
    """
    try:
        with file.open("rb") as handle:
            return hashlib.file_digest(handle, "sha256").hexdigest()
    except OSError as error:
        raise MapDataError(f"{file}: cannot be read ({error.strerror}); check the path") from error


def osm_source(name: str, sha256: str = "", extracted: str = "") -> Source:
    """Return the identity of data from OpenStreetMap, with its licence.

    Parameters
    ----------
    name : str
        What it is called.
    sha256 : str
        Hex digest of the file.
    extracted : str
        When the data was cut from the map, ISO 8601.

    Returns
    -------
    Source
        The identity.
    """
    return Source(name, sha256, extracted, LICENCE, ATTRIBUTION)
