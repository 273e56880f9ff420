"""The text of a file, whichever program saved it; what is no text is refused by its real name.

UTF-8 and UTF-16 are told by their byte order mark. UTF-16 without a mark is known by the NUL bytes
of its first characters, of which plain text has none; where they stand tells the order.
Windows-1252 cannot be told from its siblings for sure, so it is named as a guess and refused:
a vehicle's name read wrongly would go into every table.
"""

from __future__ import annotations

import codecs
import os
from pathlib import Path

from ...errors import ScenarioError, brief

__all__ = ["MOST_BYTES", "beginning_of", "kind_by_content", "path_of", "read_text"]

MOST_BYTES = 256 * 2**20
"""No table of trips is longer; it keeps a device or a map given by mistake from filling memory."""

KINDS = (
    (b"PK\x03\x04", "zip", "a workbook or another zip archive"),
    (b"SQLite format 3\x00", "gpkg", "a GeoPackage or another database"),
    (b"\xd0\xcf\x11\xe0", "ole", "a workbook of old Excel, or one with a password"),
    (b"%PDF", "pdf", "a PDF document"),
    (b"\x1f\x8b", "gzip", "a file packed with gzip"),
    (b"BZh", "bzip2", "a file packed with bzip2"),
    (b"PLATOON", "platoon", "a saved network"),
    (b"<?xml", "xml", "an XML file, such as a map"),
    (b"<osm", "xml", "an XML file, such as a map"),
    (b"<!doctype", "html", "a web page"),
    (b"<html", "html", "a web page"),
)
"""What files of other kinds begin with, what they are called here, and what to call them."""

MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
"""Byte order marks; those of UTF-32 begin like those of UTF-16 and come first."""


def path_of(path: str | os.PathLike[str], what: str) -> Path:
    """Return a path as such.

    Parameters
    ----------
    path : str or path-like
        The name of a file.
    what : str
        What it should be, for messages: "a TOML file".

    Returns
    -------
    Path
        The same.

    Raises
    ------
    ScenarioError
        It is none, or a folder.
    """
    try:
        if not isinstance(path, str | os.PathLike) or not os.fspath(path):
            raise TypeError
        file = Path(path)
        is_folder = file.is_dir()
    except (TypeError, ValueError):
        raise ScenarioError(f"{brief(path)}: is no path; name {what}") from None
    except OSError as error:
        raise ScenarioError(f"{_short(path)}: cannot be read ({error.strerror})") from error
    if is_folder:
        raise ScenarioError(f"{file}: cannot be read, it is a folder; name {what} in it")
    return file


def _short(path: object) -> str:
    return str(path)[:80]


def beginning_of(file: Path, most: int) -> bytes:
    """Return the first bytes of a file.

    Parameters
    ----------
    file : Path
        The file.
    most : int
        How many at most.

    Returns
    -------
    bytes
        Fewer if the file is shorter.

    Raises
    ------
    ScenarioError
        It cannot be read.
    """
    try:
        with file.open("rb") as handle:
            return handle.read(most)
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        raise ScenarioError(
            f"{_short(file)}: cannot be read ({why}); check the path and its rights"
        ) from error


def kind_by_content(data: bytes) -> tuple[str, str] | None:
    """Tell which kind of file that is no plain text begins so.

    Parameters
    ----------
    data : bytes
        The beginning of a file.

    Returns
    -------
    (str, str) or None
        What it is called in `KINDS`, and in messages; None if it may be text.
    """
    start = data.removeprefix(codecs.BOM_UTF8).lstrip()[:16].lower()
    for marker, name, about in KINDS:
        if data.startswith(marker) or (marker[:1] == b"<" and start.startswith(marker)):
            return name, about
    return None


def read_text(file: Path, what: str, content: bytes | None = None) -> str:
    r"""Read a text file, its line ends as \n.

    Parameters
    ----------
    file : Path
        The file.
    what : str
        What it should be, for messages: "a TOML file".
    content : bytes, optional
        What it holds, if that was read before.

    Returns
    -------
    str
        Its text without a byte order mark.

    Raises
    ------
    ScenarioError
        It cannot be read, is of another kind, or in an encoding other than UTF-8 and UTF-16.
    """
    data = beginning_of(file, MOST_BYTES + 1) if content is None else content
    if found := kind_by_content(data):
        raise ScenarioError(f"{file}: is {found[1]} by its content, not {what}; name {what}")
    if len(data) > MOST_BYTES:
        raise ScenarioError(
            f"{file}: is longer than {MOST_BYTES // 2**20} MB, too long for {what}; split it"
        )
    return _decoded(file, data, what).replace("\r\n", "\n").replace("\r", "\n")


def _decoded(file: Path, data: bytes, what: str) -> str:
    mark, encoding = next(
        ((mark, name) for mark, name in MARKS if data.startswith(mark)), (b"", _unmarked(data))
    )
    try:
        text = data[len(mark) :].decode(encoding)
    except UnicodeDecodeError as error:
        raise ScenarioError(f"{file}: {_why(data, encoding, error)}") from error
    if (at := text.find("\0")) >= 0:
        line = text.count("\n", 0, at) + 1
        raise ScenarioError(
            f"{file}: line {line} holds binary data, so this is no text; name {what}"
        )
    return text


def _unmarked(data: bytes) -> str:
    """Tell UTF-16 by its first two characters, which are Latin in headers and in TOML."""
    first = [byte == 0 for byte in data[:4]]
    if first == [False, True, False, True]:
        return "utf-16-le"
    if first == [True, False, True, False]:
        return "utf-16-be"
    return "utf-8"


def _why(data: bytes, encoding: str, error: UnicodeDecodeError) -> str:
    if encoding != "utf-8":
        name = encoding[:6].upper()
        return f"begins as {name} text and breaks off or is damaged; save it again as UTF-8"
    line = data.count(b"\n", 0, error.start) + 1
    if error.end == len(data) and error.reason == "unexpected end of data":
        return f"line {line} ends in the middle of a character; the file was cut short"
    begin = data.rfind(b"\n", 0, error.start) + 1
    end = data.find(b"\n", error.start)
    around = data[
        max(begin, error.start - 12) : min(end if end >= 0 else len(data), error.end + 12)
    ]
    try:
        guess = around.decode("cp1252").strip()
    except UnicodeDecodeError:
        return f'line {line} is not UTF-8; save the file as UTF-8 (in Excel as "CSV UTF-8")'
    return (
        f"line {line} is not UTF-8 but, it seems, Windows-1252 ({brief(guess)}); save the file as "
        'UTF-8 (in Excel as "CSV UTF-8")'
    )
