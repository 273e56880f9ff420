"""The report of a study: figures, parameters and comparison in one file that asks for nothing."""

from __future__ import annotations

import base64
import hashlib
import html
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .._version import __version__
from ..atomic_file import whole_file
from ..shown_text import well_formed
from .shown_tables import ShownTable

__all__ = ["write_page"]

STYLE = (
    "body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;"
    "color:#1a1a1a;background:#fff}"
    "h1{font-size:1.6rem}h2{font-size:1.2rem;margin-top:2.5rem}"
    "figure{margin:1.5rem 0}img{min-width:70%;max-width:100%;height:auto}"
    "figcaption,caption{color:#444;"
    "text-align:left;padding:.4rem 0}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.85rem;margin:1rem 0}"
    "th,td{padding:.25rem .6rem;border-bottom:1px solid #ddd;text-align:left;"
    "font-variant-numeric:tabular-nums;vertical-align:top}th{font-weight:600}"
    "pre{background:#f5f5f5;padding:1rem;overflow-x:auto;font-size:.8rem}"
)


def write_page(
    path: Path,
    figures: Sequence[tuple[Path, str]],
    tables: Sequence[ShownTable],
    paragraph: str,
    parameters: dict[str, Any],
    command: str,
) -> None:
    """Write the report.

    Parameters
    ----------
    path : Path
        The file to write.
    figures : sequence of (Path, str)
        SVG files and their captions, put into the page itself.
    tables : sequence of ShownTable
        The comparison.
    paragraph : str
        What it comes to.
    parameters : dict
        Of the study, in plain JSON types.
    command : str
        What to type to get the same.
    """
    digest = base64.b64encode(hashlib.sha256(STYLE.encode()).digest()).decode()
    policy = f"default-src 'none'; img-src data:; style-src 'sha256-{digest}'"
    text = html.escape
    parts = [
        "<!doctype html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{text(policy)}">',
        '<meta name="viewport" content="width=device-width,initial-scale=1">',
        "<title>Platoon study</title>", f"<style>{STYLE}</style>", "</head>", "<body>", "<main>",
        "<h1>The paper’s experiment, and ours beside it</h1>",
        f"<p>{text(paragraph)}</p>",
        f"<p>Made by platoon_osm {text(__version__)} with <code>{text(command)}</code>. Brackets "
        "hold 95 % bootstrap intervals over networks.</p>",
        "<h2>Figures</h2>",
    ]  # fmt: skip
    for picture, caption in figures:
        data = base64.b64encode(picture.read_bytes()).decode()
        parts.append(
            f'<figure><img src="data:image/svg+xml;base64,{data}" alt="{text(caption)}">'
            f"<figcaption>{text(caption)}</figcaption></figure>"
        )
    parts.append("<h2>Comparison</h2>")
    for table in tables:
        parts.append(f'<div class="wide"><table><caption>{text(table.caption)}</caption>')
        head = "".join(f'<th scope="col">{text(cell)}</th>' for cell in table.header)
        parts.append(f"<thead><tr>{head}</tr></thead><tbody>")
        parts += [
            "<tr>" + "".join(f"<td>{text(cell)}</td>" for cell in row) + "</tr>"
            for row in table.rows
        ]
        parts.append("</tbody></table></div>")
    shown = json.dumps(parameters, indent=1, sort_keys=True, ensure_ascii=False)
    parts += ["<h2>Parameters</h2>", f"<pre>{text(shown)}</pre>", "</main>", "</body>", "</html>"]
    with whole_file(path) as draft:
        draft.write_text(well_formed("\n".join(parts)) + "\n", encoding="utf-8")
