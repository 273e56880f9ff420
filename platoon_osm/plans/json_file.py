"""Plain JSON types as a file in UTF-8, whole or not at all."""

from __future__ import annotations

import json
import os
from typing import Any

from ..atomic_file import whole_file
from ..shown_text import well_formed

__all__ = ["write_json_file"]


def write_json_file(data: Any, path: str | os.PathLike[str], *, compact: bool = False) -> None:
    """Write plain JSON types.

    Halves of characters in texts, which UTF-8 has no bytes for, become U+FFFD.

    Parameters
    ----------
    data : object
        What is written.
    path : str or path
        Of the file; missing folders are made.
    compact : bool
        Whether it is one line, for programs.

    Raises
    ------
    ScenarioError
        The file cannot be written.
    """
    form: dict[str, Any] = {"separators": (",", ":")} if compact else {"indent": 1}
    text = well_formed(json.dumps(data, ensure_ascii=False, **form)) + "\n"
    with whole_file(path, suffixes=(".json",)) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")
