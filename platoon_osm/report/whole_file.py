"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..errors import ScenarioError

__all__ = ["draft_of"]


@contextmanager
def draft_of(path: str | os.PathLike[str], suffix: str = "") -> Iterator[Path]:
    """Give a place to write a file, and move it to `path` once the block ends without error.

    The draft lies in a folder of its own beside `path`, as some writers keep a journal beside
    their file; both are gone afterwards. Its name ends in `suffix`, which some writers look at.

    Raises
    ------
    ScenarioError
        The folder of `path` does not exist or cannot be written, or the file cannot be replaced.
    """
    target = Path(path)
    try:
        folder = tempfile.TemporaryDirectory(dir=target.parent, prefix=".draft-")
    except OSError as error:
        raise ScenarioError(
            f"{target}: cannot write here ({error.strerror}); name a file in a folder that exists"
        ) from None
    with folder as name:
        draft = Path(name) / f"draft{suffix}"
        try:
            yield draft
            draft.replace(target)
        except OSError as error:
            raise ScenarioError(
                f"{target}: cannot write ({error.strerror or error}); free it or name another file"
            ) from error
