"""Finished runs on disk, one file each, so that an interrupted study goes on where it stopped."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError

__all__ = ["load_part", "part_path", "save_part", "whole_file"]


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Give a name to write to beside `path`, and rename it to `path` at the end of the block.

    Raises
    ------
    ScenarioError
        The folder cannot be made or written.
    """
    draft = path.with_name(f".{path.stem}.{os.getpid()}.draft{path.suffix}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            yield draft
            draft.replace(path)
        finally:
            draft.unlink(missing_ok=True)
    except OSError as error:
        raise ScenarioError(
            f"{path}: cannot write ({error.strerror or error}); choose another folder"
        ) from error


def part_path(folder: Path, key: str, run: int) -> Path:
    """Return where a run is kept: below a folder named after the study's parameters."""
    return folder / key / f"run-{run:05d}.npz"


def save_part(path: Path, arrays: dict[str, NDArray[np.generic]]) -> None:
    """Write the arrays of one run."""
    with whole_file(path) as draft:
        np.savez(draft, **arrays)  # type: ignore[arg-type]


def load_part(path: Path, names: Collection[str]) -> dict[str, NDArray[np.generic]] | None:
    """Read the arrays of one run; None if there is no such file or it is damaged."""
    try:
        with path.open("rb") as handle, np.load(handle, allow_pickle=False) as stored:
            arrays = {name: stored[name] for name in stored.files}
            return arrays if set(arrays) == set(names) else None
    except FileNotFoundError:
        return None
    except (OSError, ValueError, EOFError, zipfile.BadZipFile):
        # Half a file, from a disk that was full, say: the run is done again.
        return None
