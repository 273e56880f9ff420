"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .errors import PlatoonError, ScenarioError, brief

__all__ = ["whole_file"]


@contextmanager
def whole_file(
    path: str | os.PathLike[str],
    refusal: type[PlatoonError] = ScenarioError,
    *,
    suffix: str | None = None,
) -> Iterator[Path]:
    """Give a place to write a file, and move it to `path` once the block ends without error.

    The draft lies in a folder of its own beside `path`, as some writers keep a journal beside
    their file; both are gone afterwards.

    Parameters
    ----------
    path : path-like
        The file to be.
    refusal : type of PlatoonError
        The error to raise if the file cannot be written.
    suffix : str, optional
        Of the draft, which some writers look at; by default that of `path`.

    Yields
    ------
    Path
        Where to write.

    Raises
    ------
    PlatoonError
        Of the class `refusal`: the folder is missing, or the file cannot be written.
    """
    try:
        target = Path(path)
    except TypeError:
        raise refusal(f"{brief(path)}: is no path; name a file to write") from None
    try:
        folder = tempfile.TemporaryDirectory(dir=target.parent, prefix=".draft-")
    except OSError as error:
        raise refusal(
            f"{target}: cannot be written ({error.strerror}); name a file in a folder that exists"
        ) from None
    with folder as name:
        draft = Path(name) / f"draft{target.suffix if suffix is None else suffix}"
        try:
            yield draft
            draft.replace(target)
        except OSError as error:
            raise refusal(
                f"{target}: cannot be written ({error.strerror or error}); free it or name "
                "another file"
            ) from error
