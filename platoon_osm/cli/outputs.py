"""What verbs write: named by options, checked before any work, and written together at its end."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

from ..atomic_file import all_or_none, filled_folder, whole_file
from ..errors import ScenarioError
from ..output_paths import Output, check_outputs

__all__ = ["STREAM", "existing_files", "output_kind", "speaker", "tell_written", "write_all"]

STREAM = "-"
"""How standard output is named; a file of that name is ./-."""

Job = tuple[Output, Callable[[Path], Any]]


def output_kind(
    name: str,
    suffixes: Sequence[str] = (),
    *,
    holds: Sequence[str] = (),
    is_text: bool = False,
) -> Callable[[Any], Output]:
    """Return what reads the name of something to write, as the type of an option.

    Parameters
    ----------
    name : str
        The option, as "--html".
    suffixes, holds, is_text : see `Output`
        Of what is written.

    Returns
    -------
    callable
        Makes an `Output` of what was typed.
    """

    def read(text: Any) -> Output:
        if isinstance(text, Output):  # click reads defaults twice
            return text
        if not str(text):
            raise ScenarioError(f"{name}: empty; give a name to write to")
        path = None if text == STREAM else Path(text)
        made = Output(name, path, tuple(suffixes), tuple(holds), is_text)
        check_outputs([made])  # before anything is read; again beside the others and the inputs
        return made

    return read


def existing_files(*places: object) -> list[Path]:
    """Return those of some texts and paths that are files; names of bundled maps are none.

    Parameters
    ----------
    *places : object
        Texts, paths, or anything else that is left out.

    Returns
    -------
    list of Path
        Files that are there.
    """
    found = []
    for place in places:
        if isinstance(place, str | Path) and str(place) and "\0" not in str(place):
            path = Path(place)
            try:
                found += [path] if path.is_file() else []
            except OSError:
                continue  # whoever reads it says what is wrong
    return found


def write_all(jobs: Sequence[Job], begin: Callable[[str], None]) -> None:
    """Write everything; all files appear, or none.

    Parameters
    ----------
    jobs : sequence of (Output, callable)
        What is written, and what writes it to a path: a file, or a folder that exists.
    begin : callable
        Told what is being written.

    Raises
    ------
    PlatoonError
        Whatever a writer refuses.
    """
    stream = b""
    for output, write in jobs:
        if output.path is None:
            begin("writing to standard output")
            with TemporaryDirectory() as folder:
                draft = Path(folder) / f"plan{output.suffixes[0] if output.suffixes else ''}"
                write(draft)
                stream = draft.read_bytes()
    with all_or_none():
        for output, write in jobs:
            if output.path is None:
                continue
            begin(f"writing {output.path}")
            if output.holds:
                with filled_folder(output.path) as draft:
                    write(draft)
            else:
                # A writer that others added may be interrupted half way; ours write whole files.
                with whole_file(output.path, suffixes=output.suffixes) as draft:
                    write(draft)
    if stream:
        sys.stdout.buffer.write(stream)
        sys.stdout.flush()


def speaker(outputs: Iterable[Output]) -> Callable[[str], None]:
    """Return what prints lines for people: to standard error if an output takes the other.

    Parameters
    ----------
    outputs : iterable of Output
        All that are written.

    Returns
    -------
    callable
        Prints a text and a line end.
    """
    return partial(click.echo, err=any(output.path is None for output in outputs))


def tell_written(outputs: Iterable[Output], say: Callable[[str], None]) -> None:
    """Say which files were written.

    Parameters
    ----------
    outputs : iterable of Output
        All that were.
    say : callable
        Prints a line.
    """
    for output in outputs:
        if output.path is not None:
            say(f"Written: {output.path}")
