"""Leaflet 1.9.3, read from an installed package and checked, so that a page can carry it whole."""

from __future__ import annotations

import base64
import hashlib
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import ScenarioError

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

__all__ = ["LEAFLET_VERSION", "Leaflet", "load_leaflet"]

LEAFLET_VERSION = "1.9.3"

SHA256 = {
    "leaflet.js": "5819285cec137b229c94e1ee5ad73e8b6b84345a4367d60f75fe477fe0fb7b03",
    "leaflet.css": "90b693d86392a4779c861b28cf307e7e59c3fb35328c4d8b95f58f814d38c722",
    "images/layers.png": "1dbbe9d028e292f36fcba8f8b3a28d5e8932754fc2215b9ac69e4cdecf5107c6",
    "images/layers-2x.png": "066daca850d8ffbef007af00b06eac0015728dee279c51f3cb6c716df7c42edf",
    "images/marker-icon.png": "574c3a5cca85f4114085b6841596d62f00d7c892c7b03f28cbfa301deb1dc437",
}


@dataclass(frozen=True, slots=True)
class Leaflet:
    """Leaflet's script, and its style sheet with the images inside."""

    script: str
    style: str


def load_leaflet(directory: str | os.PathLike[str] | None = None) -> Leaflet:
    """Read Leaflet from a directory, or from the installed package XStatic-Leaflet.

    Parameters
    ----------
    directory : holds leaflet.js, leaflet.css and images/, as in Leaflet's own archive.

    Raises
    ------
    ScenarioError
        A file is missing, or is not that of Leaflet 1.9.3. A CDN is never asked instead.
    """
    root: Path | Traversable
    if directory is not None:
        root = Path(directory)
        remedy = f"unpack Leaflet {LEAFLET_VERSION} there"
    else:
        root = _installed()
        remedy = "reinstall it: pip install --force-reinstall XStatic-Leaflet==1.9.3.0"
    files = {name: _read(root, name, remedy) for name in SHA256}
    style = files["leaflet.css"].decode()
    for name in SHA256:
        if name.endswith(".png"):
            data = base64.b64encode(files[name]).decode()
            style = style.replace(f"url({name})", f"url(data:image/png;base64,{data})")
    # The map of the minified source is not carried along, so nothing must ask for it.
    script = re.sub(r"\n//# sourceMappingURL=.*", "", files["leaflet.js"].decode())
    return Leaflet(script=script.strip() + "\n", style=style.replace("\r\n", "\n"))


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
    place = root
    for part in name.split("/"):
        place = place / part
    try:
        data = place.read_bytes()
    except OSError as error:
        raise ScenarioError(
            f"{place}: cannot read ({error.strerror or 'no such file'}); {remedy}"
        ) from None
    if hashlib.sha256(data).hexdigest() != SHA256[name]:
        raise ScenarioError(f"{place}: not the file of Leaflet {LEAFLET_VERSION}; {remedy}")
    return data
