"""The `[network]` of a scenario: which map, and how it is read."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...errors import PlatoonError, ScenarioError, brief
from ...sources.truck import TruckRules
from .keys import known, text_of
from .toml_file import BACKSLASH

__all__ = ["NETWORK_KEYS", "beside", "network_of"]

NETWORK_KEYS = ("source", "classes", "country", "limiter_kmh", "infer_links")


def network_of(folder: Path, value: Any) -> dict[str, Any]:
    """Return what a scenario says of its network, as keyword arguments of `load_network`.

    Parameters
    ----------
    folder : Path
        Where the scenario lies.
    value : Any
        A map's name or path, or a table with `NETWORK_KEYS`.

    Returns
    -------
    dict
        With source.

    Raises
    ------
    ScenarioError
        No source, an unknown key, or a value that is none.
    """
    network = {"source": value} if isinstance(value, str) else value
    if not isinstance(network, Mapping) or "source" not in network:
        raise ScenarioError(
            'network is missing; write network = "italy-motorways" or a path to a map'
        )
    known("[network]", network, NETWORK_KEYS)
    classes = network.get("classes", ["motorway"])
    proper = isinstance(classes, list | tuple) and all(isinstance(item, str) for item in classes)
    if not (proper and classes):
        raise ScenarioError(
            f"[network] classes = {brief(classes)} must be a list of highway values, as "
            '["motorway", "trunk"]'
        )
    infer = network.get("infer_links", False)
    if not isinstance(infer, bool):
        raise ScenarioError(f"[network] infer_links = {brief(infer)} must be true or false")
    try:
        rules: dict[str, Any] = {
            key: network[key] for key in ("country", "limiter_kmh") if key in network
        }
        if "country" in rules:
            text_of("country", rules["country"])
        TruckRules(**rules)
    except PlatoonError as error:
        raise ScenarioError(f"[network] {error}") from error
    return {**network, "source": beside(folder, "network source", network["source"])}


def beside(folder: Path, key: str, value: Any) -> str:
    r"""Return a path as seen from the scenario, unless it is a name or found as it stands.

    Parameters
    ----------
    folder : Path
        Where the scenario lies.
    key : str
        What the path is, for messages.
    value : Any
        What TOML holds.

    Returns
    -------
    str
        The path; written with \ on Windows it is found elsewhere too.

    Raises
    ------
    ScenarioError
        It is no text, or holds what a backslash made of it.
    """
    text = text_of(key, value)
    if not text.isprintable():
        raise ScenarioError(f"{key} = {brief(text)}: {BACKSLASH}")
    for name in (text, text.replace("\\", "/")):
        for path in (Path(name), folder / name):
            if _is_file(path):
                return text if path == Path(text) else str(path)
    return text


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name too long for any file
        return False
