"""What upper rooms offer to lower ones: methods that people look for on a network or a plan.

`net.locate("Torino")` and `plan.explore(net)` are what people type, but a network knows nothing of
finding names, nor a plan of drawing. The front door of the package knows all rooms, and says here
where each such function stands; it is loaded when somebody calls it.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

__all__ = ["offer", "offered"]

_offers: dict[str, str] = {}


def offer(name: str, module: str) -> None:
    """Offer a function of a module, which is loaded when it is first asked for.

    Parameters
    ----------
    name : str
        What people call it by.
    module : str
        Dotted name of the module in which it stands under that name.
    """
    _offers[name] = module


def offered(name: str) -> Callable[..., Any]:
    """Return a function that somebody offers.

    Parameters
    ----------
    name : str
        What it was offered as.

    Returns
    -------
    callable
        The function itself; its module is loaded now.

    Raises
    ------
    LookupError
        Nobody offers it.
    """
    if name not in _offers:
        raise LookupError(f"nobody offers {name!r}; import platoon_osm first")
    found: Callable[..., Any] = getattr(import_module(_offers[name]), name)
    return found
