"""Finished runs on disk, one file each, so that an interrupted study goes on where it stopped."""

from __future__ import annotations

import zipfile
from collections.abc import Collection
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..atomic_file import whole_file
from ..errors import ScenarioError

__all__ = ["load_part", "make_folder", "part_path", "save_part"]


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


def make_folder(folder: Path) -> None:
    """Make a folder with its parents, if it is not there.

    Parameters
    ----------
    folder : Path
        The folder wanted.

    Raises
    ------
    ScenarioError
        It cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ScenarioError(
            f"{folder}: cannot be made ({error.strerror}); choose another folder"
        ) from error


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
    make_folder(path.parent)
    with whole_file(path, synced=False) as draft:
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
