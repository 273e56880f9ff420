"""Finished runs on disk, one file each, so that an interrupted study goes on where it stopped."""

from __future__ import annotations

import zipfile
from collections.abc import Collection, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..atomic_file import whole_file
from ..errors import ScenarioError
from ..leftovers import folder_if_filled

__all__ = ["kept_folder", "load_part", "part_path", "save_part"]


def part_path(folder: Path, key: str, run: int) -> Path:
    """Return where a run is kept: below a folder named after the study's parameters.

    Parameters
    ----------
    folder : Path
        Of all studies.
    key : str
        `Study.key`.
    run : int
        Number of the run, from 0.

    Returns
    -------
    Path
        A file that may or may not be there.
    """
    return folder / key / f"run-{run:05d}.npz"


@contextmanager
def kept_folder(folder: Path) -> Iterator[None]:
    """Make a folder with its parents, if it is not there; it stays if anything comes into it.

    Parameters
    ----------
    folder : Path
        The folder wanted.

    Yields
    ------
    None
        Nothing; the folder exists.

    Raises
    ------
    ScenarioError
        It cannot be made.
    """
    with ExitStack() as stack:
        try:
            stack.enter_context(folder_if_filled(folder))
        except OSError as error:
            raise ScenarioError(
                f"{folder}: cannot be made ({error.strerror}); choose another folder"
            ) from error
        yield


def save_part(path: Path, arrays: dict[str, NDArray[np.generic]]) -> None:
    """Write the arrays of one run.

    Parameters
    ----------
    path : Path
        The file to write.
    arrays : dict of ndarray
        By name.

    Raises
    ------
    ScenarioError
        The folder cannot be made or written.
    """
    with kept_folder(path.parent), whole_file(path, synced=False) as draft:
        np.savez(draft, **arrays)  # type: ignore[arg-type]


def load_part(path: Path, names: Collection[str]) -> dict[str, NDArray[np.generic]] | None:
    """Read the arrays of one run, if they are there and whole.

    Parameters
    ----------
    path : Path
        What `save_part` wrote.
    names : collection of str
        Which arrays must be there, and no others.

    Returns
    -------
    dict of ndarray or None
        None if there is no such file, or it is damaged or of another version.
    """
    try:
        with path.open("rb") as handle, np.load(handle, allow_pickle=False) as stored:
            arrays = {name: stored[name] for name in stored.files}
            return arrays if set(arrays) == set(names) else None
    except FileNotFoundError:
        return None
    except (OSError, ValueError, EOFError, zipfile.BadZipFile):
        # Half a file, from a disk that was full, say: the run is done again.
        return None
