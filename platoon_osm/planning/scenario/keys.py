"""Keys and values of scenarios: which there are, and what each must be."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ...errors import PlatoonError, ScenarioError, brief
from ...plans.trip import TIMES

__all__ = [
    "CARRIER", "DRIVER", "FLEXIBILITY", "PLACES", "PROFILE", "SPREAD", "TRIP_KEYS", "hint", "known",
    "text_of", "told",
]  # fmt: skip

PLACES = ("origin", "destination")
FLEXIBILITY = "flexibility_min"
PROFILE = "profile"
DRIVER = "driver"
SPREAD = "delay_spread_min"
CARRIER = "carrier"
"""A column of tables for whole fleets alone."""
TRIP_KEYS = ("vehicle", *PLACES, *TIMES, FLEXIBILITY, PROFILE, DRIVER, SPREAD)
"""What a trip may say, in TOML as in tables; vehicle, origin and destination it must say."""


def known(where: str, given: Iterable[str], allowed: Sequence[str]) -> None:
    """Check that all keys of a table are known.

    Parameters
    ----------
    where : str
        The table, for messages: "[costs]".
    given : iterable of str
        Its keys.
    allowed : sequence of str
        Those there are.

    Raises
    ------
    ScenarioError
        One is unknown; with the nearest.
    """
    for key in given:
        if key not in allowed:
            raise ScenarioError(f"{where} has no key {brief(key)}; {hint(key, allowed)}")


def hint(key: str, allowed: Sequence[str], shown: Sequence[str] | None = None) -> str:
    """Say which word was meant, or which there are.

    Parameters
    ----------
    key : str
        A word that is none of them.
    allowed : sequence of str
        Those there are.
    shown : sequence of str, optional
        Those to list if none is near; all of them if not given.

    Returns
    -------
    str
        For the end of a message.
    """
    near = difflib.get_close_matches(str(key)[:60], allowed, 1, 0.5)
    return f"did you mean {near[0]!r}?" if near else f"known are {', '.join(shown or allowed)}"


def text_of(where: str, value: Any) -> str:
    """Return a value that must be a text.

    Parameters
    ----------
    where : str
        Whose it is, for messages.
    value : Any
        What TOML holds.

    Returns
    -------
    str
        The same.

    Raises
    ------
    ScenarioError
        It is none, or blank.
    """
    if not isinstance(value, str) or not value.strip():
        raise ScenarioError(f"{where} = {brief(value)} must be a text in quotes")
    return value


@contextmanager
def told(file: Path, kinds: type[PlatoonError] = ScenarioError) -> Iterator[None]:
    """Put a file's name before what goes wrong inside.

    Parameters
    ----------
    file : Path
        The file.
    kinds : type of PlatoonError
        Which errors; they become a `ScenarioError`.

    Yields
    ------
    None
        Nothing.

    Raises
    ------
    ScenarioError
        What went wrong, with the file.
    """
    try:
        yield
    except kinds as error:
        said = str(error)
        raise ScenarioError(said if said.startswith(f"{file}: ") else f"{file}: {said}") from error
