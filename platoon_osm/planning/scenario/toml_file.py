"""TOML as people write it: what the parser says of a slip becomes the slip and its remedy."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from ...errors import ScenarioError, brief
from .text_file import read_text

__all__ = ["BACKSLASH", "read_toml"]

BACKSLASH = (
    "a backslash in double quotes begins an escape; write C:/maps/x.osm, or 'C:\\maps\\x.osm' in "
    "single quotes"
)

SEE = "see platoon-osm scenario --example"

IN_DOUBLE_QUOTES = re.compile(r'"[^"]*\\')
CURLY = "\u201c\u201d\u201e\u201f\u2018\u2019\u00ab\u00bb"
"""Quotation marks of word processors."""


def read_toml(file: Path) -> dict[str, Any]:
    """Read a TOML file.

    Parameters
    ----------
    file : Path
        The file.

    Returns
    -------
    dict
        What it holds.

    Raises
    ------
    ScenarioError
        It cannot be read or is no TOML, with the line.
    """
    text = read_text(file, "a TOML file")
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ScenarioError(f"{file}: not a TOML file: {_slip(text, str(error))}") from error
    except RecursionError:
        raise ScenarioError(f"{file}: not a TOML file: brackets nest too deeply; {SEE}") from None
    except ValueError as error:  # such as a number of thousands of digits
        raise ScenarioError(f"{file}: not a TOML file: {brief(str(error))}; {SEE}") from error


def _slip(text: str, said: str) -> str:
    """Return what is wrong with a line that the parser stumbles over, and the remedy."""
    lines = text.split("\n")
    found = re.search(r"\(at line (\d+)", said)
    last = max((k for k, line in enumerate(lines, 1) if line.strip()), default=1)
    number = min(int(found[1]), len(lines)) if found else last
    line = lines[number - 1]
    why = said.split(" (at ")[0]
    if IN_DOUBLE_QUOTES.search(line):
        remedy = BACKSLASH
    elif any(mark in line for mark in CURLY):
        remedy = "it has curly quotation marks; write straight ones"
    elif re.match(r"\s*[\w-]+\s*=\s*[^\W\d]", line):
        remedy = f"texts stand in double quotes ({why}); {SEE}"
    else:
        remedy = f"{why}; {SEE}"
    shown = f" ({brief(line.strip(), 40)})" if line.strip() else ""
    return f"line {number}{shown}: {remedy}"
