"""Folders that must not outlive the work they were made for, wherever it is interrupted.

Each is noted before it is made, so that an interrupt between two lines of Python loses none; what
is still noted when the process ends is removed then.
"""

from __future__ import annotations

import atexit
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

__all__ = ["DRAFT", "folder_if_filled", "forget", "make_folder", "remove", "remove_all"]

_noted: dict[Path, int] = {}
"""Folders, with the process that made them: one that was forked must not tidy up for another."""

DRAFT = ".draft-"
"""How names of folders begin that hold drafts."""


def make_folder(folder: Path, mode: int = 0o777) -> None:
    """Make a folder, and note it.

    Parameters
    ----------
    folder : Path
        One that does not exist, in one that does.
    mode : int
        Its rights, as `os.mkdir` takes them.

    Raises
    ------
    OSError
        It cannot be made.
    """
    _noted[folder] = os.getpid()
    try:
        folder.mkdir(mode)
    except OSError:
        forget(folder)  # whatever is there is somebody else's
        raise


def forget(folder: Path) -> None:
    """Let a folder be: it belongs to what was to be made.

    Parameters
    ----------
    folder : Path
        One that was noted, or not.
    """
    _noted.pop(folder, None)


def remove(folder: Path) -> None:
    """Remove a folder that was noted: a draft's with all it holds, any other if it is empty.

    Parameters
    ----------
    folder : Path
        One that was noted; others are left alone.
    """
    if _noted.get(folder) != os.getpid():
        return
    if folder.name.startswith(DRAFT):
        shutil.rmtree(folder, ignore_errors=True)
    else:
        with suppress(OSError):
            folder.rmdir()
    forget(folder)


@contextmanager
def folder_if_filled(folder: Path) -> Iterator[None]:
    """Make a folder with its parents; if the block fails, those still empty are gone again.

    Parameters
    ----------
    folder : Path
        One that may be there.

    Yields
    ------
    None
        Nothing; the folder exists.

    Raises
    ------
    OSError
        It cannot be made.
    """
    missing = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        for place in reversed(missing):
            try:
                make_folder(place)
            except FileExistsError:
                if not place.is_dir():  # made by another process since
                    raise
        yield
    except BaseException:
        for place in missing:
            remove(place)
        raise
    for place in missing:
        forget(place)


def remove_all() -> None:
    """Remove all folders that are still noted, inner ones first."""
    for folder in sorted(_noted, key=lambda path: len(path.parts), reverse=True):
        remove(folder)


atexit.register(remove_all)
