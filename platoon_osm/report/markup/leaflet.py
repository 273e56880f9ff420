"""Leaflet 1.9.3, read from an installed package and checked, so that a page can carry it whole."""

from __future__ import annotations

import hashlib
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import ScenarioError, brief

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

__all__ = ["LEAFLET_VERSION", "Leaflet", "load_leaflet"]

LEAFLET_VERSION = "1.9.3"

SHA256 = {
    "leaflet.js": "5819285cec137b229c94e1ee5ad73e8b6b84345a4367d60f75fe477fe0fb7b03",
    "leaflet.css": "90b693d86392a4779c861b28cf307e7e59c3fb35328c4d8b95f58f814d38c722",
}


@dataclass(frozen=True, slots=True)
class Leaflet:
    """What a page carries of Leaflet.

    Attributes
    ----------
    script : str
        Its script.
    style : str
        Its style sheet, without the images.
    """

    script: str
    style: str


def load_leaflet(directory: str | os.PathLike[str] | None = None) -> Leaflet:
    """Read Leaflet from a directory, or from the installed package XStatic-Leaflet.

    Parameters
    ----------
    directory : path-like or None
        Holds leaflet.js and leaflet.css, as Leaflet's own archive does.

    Returns
    -------
    Leaflet
        What a page carries.

    Raises
    ------
    ScenarioError
        A file is missing, or is not that of Leaflet 1.9.3. A CDN is never asked instead.
    """
    root: Path | Traversable
    if directory is not None:
        if not isinstance(directory, str | os.PathLike):
            raise ScenarioError(
                f"Leaflet: leaflet_dir {brief(directory)} is no path; name a folder, or None"
            )
        root = Path(directory)
        remedy = f"unpack Leaflet {LEAFLET_VERSION} there"
    else:
        root = _installed()
        remedy = "reinstall it: pip install --force-reinstall XStatic-Leaflet==1.9.3.0"
    files = {name: _read(root, name, remedy) for name in SHA256}
    # Its images serve its own layer control and marker, which the page does not use.
    style = re.sub(r"url\(images/[\w.-]+\)", "none", files["leaflet.css"].decode())
    import rcssmin

    style = rcssmin.cssmin(style).strip() + "\n"
    # The map of the minified source is not carried along, so nothing must ask for it.
    script = re.sub(r"\n//# sourceMappingURL=.*", "", files["leaflet.js"].decode())
    return Leaflet(script=script.strip() + "\n", style=style)


def _installed() -> Traversable:
    from importlib.resources import files

    try:
        return files("xstatic.pkg.leaflet") / "data"
    except ModuleNotFoundError:
        raise ScenarioError(
            "Leaflet: package XStatic-Leaflet is not installed; run pip install "
            "XStatic-Leaflet==1.9.3.0 or name a copy of Leaflet with leaflet_dir"
        ) from None


def _read(root: Path | Traversable, name: str, remedy: str) -> bytes:
    place = root / name
    try:
        data = place.read_bytes()
    except OSError as error:
        raise ScenarioError(
            f"{place}: cannot read ({error.strerror or 'no such file'}); {remedy}"
        ) from None
    if hashlib.sha256(data).hexdigest() != SHA256[name]:
        raise ScenarioError(f"{place}: not the file of Leaflet {LEAFLET_VERSION}; {remedy}")
    return data
