"""What a page may do, and data that cannot leave its element."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Sequence

from ...shown_text import well_formed

__all__ = ["json_for_html", "policy"]


def json_for_html(data: object) -> str:
    """Return JSON that cannot end the script element it stands in, nor a line of JavaScript.

    Parameters
    ----------
    data : dict, list, str, float, int, bool or None
        Plain JSON types.

    Returns
    -------
    str
        The same as text.
    """
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return re.sub(
        "[<>&\u2028\u2029]", lambda found: f"\\u{ord(found.group()):04x}", well_formed(text)
    )


def policy(scripts: Sequence[str], styles: Sequence[str], images: str = "") -> str:
    """Return the content security policy that allows these scripts and styles, and no others.

    Parameters
    ----------
    scripts, styles : sequence of str
        All that stand in the page.
    images : str
        An origin that images may come from, besides the page itself.

    Returns
    -------
    str
        The policy.
    """
    return "; ".join(
        [
            "default-src 'none'",
            "script-src " + (" ".join(_source_hash(text) for text in scripts) or "'none'"),
            "style-src " + " ".join(_source_hash(text) for text in styles),
            f"img-src data: {images}".rstrip(),
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )


def _source_hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
