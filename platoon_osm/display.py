"""How plans come to be shown: who can draw them offers it here, for plans cannot draw themselves.

Planning knows nothing of reports, so that plans can be made where nothing is drawn. The front door
of the package knows both, and offers what reports can do when it is first imported.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["offer", "offered"]

_offers: dict[str, Callable[[], Callable[..., Any]]] = {}


def offer(name: str, load: Callable[[], Callable[..., Any]]) -> None:
    """Offer a way to show a plan; `load` brings it when it is first asked for."""
    _offers[name] = load


def offered(name: str) -> Callable[..., Any]:
    """Return a way to show a plan.

    Raises
    ------
    LookupError
        Nobody offers it.
    """
    if name not in _offers:
        raise LookupError(f"nobody offers {name!r}; import platoon_osm first")
    return _offers[name]()
