"""An online map underneath a page: its address, and who is to be named."""

from __future__ import annotations

import re
from dataclasses import dataclass
from urllib.parse import urlsplit

from ...errors import ScenarioError, brief

__all__ = ["Tiles", "online_map"]


@dataclass(frozen=True, slots=True)
class Tiles:
    """An online map.

    Attributes
    ----------
    url : str
        With {z}, {x} and {y}.
    credit : str
        Whom to name.
    max_zoom : int
        How far one may zoom in.
    origin : str
        Where its images come from, for the page's policy.
    """

    url: str
    credit: str
    max_zoom: int
    origin: str


def online_map(tiles: str) -> Tiles:
    """Return an online map.

    Parameters
    ----------
    tiles : str
        Its name, or an https address with {z}, {x} and {y}.

    Returns
    -------
    Tiles
        What a page needs to know of it.

    Raises
    ------
    ScenarioError
        No map of that name, one that needs a key, or no plain host.
    """
    if not isinstance(tiles, str):
        raise ScenarioError(
            f'tiles {brief(tiles)}: is no text; try "OpenStreetMap", or None for no online map'
        )
    if tiles.startswith("https://") and "{z}" in tiles and "{x}" in tiles and "{y}" in tiles:
        url, credit, zoom = tiles, "", 19
    else:
        url, credit, zoom = _by_name(tiles)
    try:
        host, name = urlsplit(url).netloc, urlsplit(url).hostname
    except ValueError as error:
        raise ScenarioError(
            f"tiles {brief(tiles)}: is no address ({error}); give another"
        ) from None
    wanted = host.replace("{s}", "*")
    if not re.fullmatch(r"(\*\.)?[A-Za-z0-9.-]+(:\d+)?", wanted):
        raise ScenarioError(f"tiles {brief(tiles)}: host {host!r} is not a plain host name")
    return Tiles(url, credit or f"Background map: {name}", zoom, f"https://{wanted}")


def _by_name(tiles: str) -> tuple[str, str, int]:
    """Return address, credit and greatest zoom of a map that folium knows by name."""
    # folium brings it along; it has no type hints.
    import xyzservices.providers as online_maps  # type: ignore[import-untyped]  # it has no types

    try:
        # The plain name stands for the standard style, as in folium.
        plain = tiles.casefold() == "openstreetmap"
        provider = online_maps.query_name("OpenStreetMap.Mapnik" if plain else tiles)
    except ValueError:
        raise ScenarioError(
            f'tiles {brief(tiles)}: no online map of that name; try "OpenStreetMap" or an '
            "https address with {z}, {x} and {y}"
        ) from None
    if provider.requires_token():
        raise ScenarioError(
            f"tiles {brief(tiles)}: needs a key; give its https address with {{z}}, {{x}}, {{y}}"
        )
    url = provider.build_url(x="{x}", y="{y}", z="{z}", scale_factor="")
    credit = re.sub(r"^\(C\)", "\u00a9", provider["attribution"])
    return url, credit, int(provider.get("max_zoom", 19))
