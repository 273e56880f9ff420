"""Where something may be written: never over what it is made from, nor over what is no file.

One rule for all that is written, by the command and from Python: folders on the way that are
missing are made, and are gone again if nothing is written.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path

from .errors import PlatoonError, ScenarioError, brief
from .shown_text import well_formed

__all__ = ["PAGES", "SAVED", "Output", "check_outputs", "checked_file", "checked_folder"]

PAGES = (".html", ".htm")
"""Suffixes of pages."""
SAVED = (".platoon",)
"""Of saved networks."""

STREAMS = ("/dev/stdin", "/dev/stdout", "/dev/stderr")
STREAM_FOLDERS = ("/dev/fd/", "/proc/")
"""What lies there are streams by another name; replacing them would write to nowhere."""

KINDS = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISSOCK, "a socket"),
)


@dataclass(frozen=True, slots=True)
class Output:
    """Something that is to be written.

    Attributes
    ----------
    name : str
        What asked for it, as "--html".
    path : Path or None
        A file, or a folder; None is standard output.
    suffixes : tuple of str
        Those its format has, lower case with their dot; none for a folder.
    holds : tuple of str
        Patterns of the files that are written into it if it is a folder; none for a file.
    is_text : bool
        Whether it may go to standard output.
    """

    name: str
    path: Path | None
    suffixes: tuple[str, ...] = ()
    holds: tuple[str, ...] = ()
    is_text: bool = False

    @property
    def label(self) -> str:
        """What it is called in a message: its option and its path."""
        return f"{self.name} {'-' if self.path is None else self.path}"


def checked_file(
    path: str | os.PathLike[str],
    refusal: type[PlatoonError] = ScenarioError,
    suffixes: Sequence[str] = (),
) -> Path:
    """Return the file that writing to a path would make or replace; links are followed.

    Its folder may not exist yet, no more than that of `checked_folder`.

    Parameters
    ----------
    path : path-like
        Of the file to be.
    refusal : type of PlatoonError
        The error to raise.
    suffixes : sequence of str
        Those its format has, lower case; a name without any suffix will do as well.

    Returns
    -------
    Path
        Absolute, without links.

    Raises
    ------
    PlatoonError
        No path, a suffix of another format, a folder, device or pipe, a file or folder that may
        not be written, or a file on the way to it.
    """
    place = _as_path(path, refusal)
    status = _status(place, refusal)
    if status is not None and not stat.S_ISREG(status.st_mode):
        kind = next((name for is_it, name in KINDS if is_it(status.st_mode)), "no file")
        remedy = f"give the name of a file, such as {_model(suffixes)}"
        raise refusal(f"{place}: is {kind} and cannot be written; {remedy}")
    target = Path(os.path.realpath(place))
    if status is not None and not os.access(target, os.W_OK):
        raise refusal(f"{place}: cannot be written; change its rights or name another file")
    _check_room(place, target.parent, refusal)
    if suffixes and place.suffix and place.suffix.lower() not in suffixes:
        raise refusal(
            f"{place}: a file of this kind ends in {' or '.join(suffixes)}, not "
            f"{brief(place.suffix)}; name it {place.stem}{suffixes[0]}"
        )
    return target


def checked_folder(
    path: str | os.PathLike[str], refusal: type[PlatoonError] = ScenarioError
) -> Path:
    """Return a folder to write into, which may not exist yet.

    Parameters
    ----------
    path : path-like
        Of the folder.
    refusal : type of PlatoonError
        The error to raise.

    Returns
    -------
    Path
        Absolute, without links.

    Raises
    ------
    PlatoonError
        No path, a file in its place or on the way to it, or a folder that may not be written.
    """
    place = _as_path(path, refusal)
    status = _status(place, refusal)
    if status is not None and not stat.S_ISDIR(status.st_mode):
        raise refusal(f"{place}: is a file; name a folder to write into")
    target = Path(os.path.realpath(place))
    _check_room(place, target, refusal)
    return target


def check_outputs(outputs: Sequence[Output], inputs: Iterable[Path] = ()) -> None:
    """Check all that a command is to write, before it does anything.

    Parameters
    ----------
    outputs : sequence of Output
        All of them.
    inputs : iterable of Path
        Files that the command reads; those that do not exist are left to whoever reads them.

    Raises
    ------
    ScenarioError
        An output that is an input, two that are one file, what `checked_file` and
        `checked_folder` refuse, or a format that does not go to standard output.
    """
    sources = [path for path in inputs if path.is_file()]
    seen: list[tuple[Output, Path]] = []
    streams = [output for output in outputs if output.path is None]
    for output in streams:
        if not output.is_text:
            what = "several files" if output.holds else "no text"
            raise ScenarioError(f"{output.label}: is {what}; give a name to write to")
    if len(streams) > 1:
        names = " and ".join(output.label for output in streams)
        raise ScenarioError(f"{names}: standard output takes one; give the other a file")
    if streams:
        _check_stream(streams[0], sources)
    for output in outputs:
        if output.path is None:
            continue
        if output.holds:
            target = checked_folder(output.path)
        else:
            target = checked_file(output.path, suffixes=output.suffixes)
        for source in sources:
            if written := _written_over(output, target, source):
                raise ScenarioError(
                    f"{output.label}: would replace {written}, which is read; name another"
                )
        for other, place in seen:
            if _clash(output, target, other, place):
                raise ScenarioError(
                    f"{other.label} and {output.label}: write the same file; name another for one"
                )
        seen.append((output, target))


def _as_path(path: object, refusal: type[PlatoonError]) -> Path:
    text = os.fspath(path) if isinstance(path, str | os.PathLike) else None
    if not isinstance(text, str) or not text or "\0" in text:
        raise refusal(f"{brief(path)}: is no path; name a file to write")
    if well_formed(text) != text:  # bytes that are no UTF-8: not every writer can open them
        raise refusal(f"{well_formed(text)}: is no name in UTF-8; name it otherwise")
    absolute = os.path.normpath(Path(text).absolute())
    if absolute in STREAMS or absolute.startswith(STREAM_FOLDERS):
        raise refusal(f"{text}: is a stream; name a file, or - for standard output")
    return Path(text)


def _status(place: Path, refusal: type[PlatoonError]) -> os.stat_result | None:
    try:
        return place.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError) as error:
        told = error.strerror if isinstance(error, OSError) else error
        raise refusal(f"{place}: cannot be written ({told}); name another") from None


def _check_room(place: Path, folder: Path, refusal: type[PlatoonError]) -> None:
    """Refuse a place whose folder is not there and cannot be made, or takes no files."""
    there = folder
    while not there.exists() and there != there.parent:
        there = there.parent
    if not there.is_dir():
        raise refusal(f"{place}: {there} is no folder; name another")
    if not os.access(there, os.W_OK | os.X_OK):
        raise refusal(f"{place}: {there} takes no files; name another folder")


def _model(suffixes: Sequence[str]) -> str:
    return f"plan{suffixes[0]}" if suffixes else "plan.html"


def _check_stream(output: Output, sources: Sequence[Path]) -> None:
    """Refuse standard output where a shell has led it into a file that is read, as `>>` does."""
    try:
        stream = os.fstat(1)
    except OSError:
        return
    for source in sources:
        if os.path.samestat(stream, source.stat()):
            raise ScenarioError(f"{output.label}: standard output is {source}, which is read")


def _same(one: Path, other: Path) -> bool:
    if os.path.normcase(os.path.realpath(one)) == os.path.normcase(os.path.realpath(other)):
        return True
    try:
        return one.samefile(other)
    except OSError:
        return False  # one of them is not there yet


def _inside(folder: Path, patterns: Sequence[str]) -> Iterator[Path]:
    if folder.is_dir():
        for entry in sorted(folder.iterdir()):
            if any(_matches(entry.name, pattern) for pattern in patterns):
                yield entry


def _matches(name: str, pattern: str) -> bool:
    # Where file systems do not tell cases apart, neither may we; elsewhere it costs little.
    return fnmatch(name.casefold(), pattern.casefold())


def _written_over(output: Output, target: Path, source: Path) -> Path | None:
    if not output.holds:
        return source if _same(target, source) else None
    return next((source for file in _inside(target, output.holds) if _same(file, source)), None)


def _clash(one: Output, target: Path, other: Output, place: Path) -> bool:
    if _same(target, place):
        both = one.holds and other.holds
        return not both or _overlap(one.holds, other.holds)
    for folder, at, file, name in ((one, target, other, place), (other, place, one, target)):
        if folder.holds and not file.holds:
            if _same(at, name.parent) and any(_matches(name.name, p) for p in folder.holds):
                return True
            if any(_same(entry, name) for entry in _inside(at, folder.holds)):
                return True
    return False


def _overlap(one: Sequence[str], other: Sequence[str]) -> bool:
    return any(_matches(a, b) or _matches(b, a) for a in one for b in other)
