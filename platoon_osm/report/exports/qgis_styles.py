"""How QGIS shows the layers of a GeoPackage: as the page does.

A GeoPackage keeps styles in a table of its own, `layer_styles`, as QGIS writes it; those marked as
default are taken when a layer is opened. Other programs see a table without shapes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, SubElement, tostring

from ..drawing.palette import (
    CASING,
    CROWD,
    INK,
    NETWORK,
    PAPER,
    PLATOON,
    PLATOON_CASING,
)
from ..drawing.vehicle_styles import VehicleStyle, letter_size
from .qgis_symbols import (
    MM_PER_PX,
    Part,
    column,
    generalised,
    letter,
    line,
    mark,
    picture,
    quoted,
    rgba,
    symbol,
)

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["MOST_VEHICLES", "STYLES", "style_rows"]

STYLES = "layer_styles"
"""The table's name."""

MOST_VEHICLES = 56
"""Looks of vehicles return after so many; with more, all have one look."""

BESIDE_PX = 6.0
"""From line to line in a platoon, as in a page."""

INFERRED = "#8a5a83"

MERGE = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="26" height="26" viewBox="-13 -13 26 26">'
    f'<circle r="11" fill="{INK}" stroke="#fff" stroke-width="1.5"/>'
    '<path d="M-5.4 -4.8L-0.8 0M-5.4 4.8L-0.8 0M-0.8 0H3.4" fill="none" stroke="#fff" '
    'stroke-width="2.1" stroke-linecap="round"/><path d="M2.8 -3.4L7.6 0L2.8 3.4Z" fill="#fff"/>'
    "</svg>"
)
SEPARATION = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="26" height="26" viewBox="-13 -13 26 26">'
    f'<path d="M0 -11.6L11.6 0L0 11.6L-11.6 0Z" fill="#fff" stroke="{INK}" stroke-width="1.8" '
    'stroke-linejoin="round"/><path d="M-6.6 0H-2M-2 0L2.2 -2.9M-2 0L2.2 2.9" fill="none" '
    f'stroke="{INK}" stroke-width="1.9" stroke-linecap="round"/>'
    f'<path d="M1.2 -4.6L5.2 -5L3.5 -1.4ZM1.2 4.6L5.2 5L3.5 1.4Z" fill="{INK}"/></svg>'
)
"""The page's own marks; `assets/map.svg.html` has the same."""


def _boxed(drawing: str) -> str:
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="26" height="26" viewBox="-13 -13 26 26">'
        f'<rect x="-10.5" y="-10.5" width="21" height="21" rx="5" fill="#fff" stroke="{INK}" '
        f'stroke-width="1.8"/>{drawing}</svg>'
    )


def _lines(path: str, width: float = 1.8) -> str:
    return (
        f'<path d="{path}" fill="none" stroke="{INK}" stroke-width="{width}" '
        'stroke-linecap="round" stroke-linejoin="round"/>'
    )


CUP = _boxed(
    _lines(
        "M-6.4 -2.4H3.2V3A3 3 0 0 1 .2 6H-3.4A3 3 0 0 1 -6.4 3ZM3.2 -1.2H4.6A2.2 2.2 0 0 1 4.6 3.2"
        "H3.2M-3.6 -5V-7.2M.4 -5V-7.2", 1.7,
    )
)  # fmt: skip
BED = _boxed(
    f'<circle cx="-3.6" cy="-1.6" r="1.9" fill="{INK}"/>'
    + _lines("M-7 -5.4V6M-7 3.2H7.2V6M7.2 3.2V-.6A1.8 1.8 0 0 0 5.4 -2.4H-.4V3.2")
)
CHANGE = _boxed(
    _lines("M-6 -3.2H5.4M2.4 -6.2L5.6 -3.2L2.4 -.2M6 3.4H-5.4M-2.4 .4L-5.6 3.4L-2.4 6.4")
)
WAIT = _boxed(_lines("M-2.7 -4.4V4.4M2.7 -4.4V4.4", 2.8))
NO_ENTRY = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="26" height="26" viewBox="-13 -13 26 26">'
    '<circle r="11" fill="#a3260a" stroke="#fff" stroke-width="1.5"/>'
    '<path d="M-6.4 0H6.4" stroke="#fff" stroke-width="3.6"/></svg>'
)

PAUSES = (
    ("break", "break", CUP),
    ("first_part", "first part of a break", CUP),
    ("second_part", "second part of a break", CUP),
    ("daily_rest", "daily rest", BED),
    ("reduced_daily_rest", "reduced daily rest", BED),
    ("weekly_rest", "weekly rest", BED),
    ("reduced_weekly_rest", "reduced weekly rest", BED),
    ("change", "change of drivers", CHANGE),
    ("ban", "driving ban", NO_ENTRY),
    ("company", "wait for others", WAIT),
)
"""Purpose, what the legend calls it, and its mark."""

EVENT_PX = 26.0
END_PX = 20.0

# A vehicle's place among those of its platoon, from the left by name: QGIS knows a leg's company
# by names alone.
COMPANY = 'array_sort(array_append(string_to_array("partners", \', \'), "vehicle"))'
ASIDE = (
    f'{BESIDE_PX * MM_PER_PX:.3f} * (array_find({COMPANY}, "vehicle") '
    f"- (array_length({COMPANY}) - 1) / 2.0)"
)
ALONE = "\"role\" <> 'platoon'"


def style_rows(
    names: Sequence[str],
    styles: Sequence[VehicleStyle],
    moment: datetime,
    *,
    pauses: bool = False,
) -> pd.DataFrame:
    """Return the table of styles, a row for each layer with shapes.

    Parameters
    ----------
    names : sequence of str
        Of the vehicles, as the layers have them.
    styles : sequence of VehicleStyle
        How each looks.
    moment : datetime
        When the styles were last changed, as the file tells it.
    pauses : bool
        Whether there is a layer of pauses.

    Returns
    -------
    DataFrame
        With the columns that QGIS looks for.
    """
    import pandas as pd

    known = list(zip(names, styles, strict=True)) if len(names) <= MOST_VEHICLES else []
    made = {
        "routes": _routes(known),
        "platoons": _document(_platoons),
        "points": _points(known),
        **({"pauses": _document(_pauses)} if pauses else {}),
        "network": _document(_network),
    }
    return pd.DataFrame(
        {
            "f_table_catalog": "",
            "f_table_schema": "",
            "f_table_name": list(made),
            "f_geometry_column": "geom",
            "styleName": list(made),
            "styleQML": list(made.values()),
            "styleSLD": "",
            "useAsDefault": True,
            "description": "as in the report",
            "owner": "",
            "ui": "",
            "update_time": pd.Series([moment] * len(made)).astype("datetime64[ms, UTC]"),
        }
    )


def _document(fill: Callable[[Element], None]) -> str:
    root = Element("qgis", version="3.22.0", styleCategories="Symbology|Labeling")
    fill(root)
    head = "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
    return head + tostring(root, encoding="unicode")


def _renderer(root: Element, kind: str, **attributes: str) -> Element:
    told = {"type": kind, "forceraster": "0", "enableorderby": "0", **attributes}
    return SubElement(root, "renderer-v2", told)


Category = tuple[str, str, list[Part]]


def _categories(
    root: Element, kind: str, expression: str, found: Sequence[Category], *, levels: bool = False
) -> None:
    """Add a renderer that tells features apart by a value; each category is value, label, parts."""
    renderer = _renderer(
        root, "categorizedSymbol", attr=expression, symbollevels="1" if levels else "0"
    )
    listed = SubElement(renderer, "categories")
    symbols = SubElement(renderer, "symbols")
    for number, (value, label, parts) in enumerate(found):
        SubElement(
            listed, "category", type="string", value=value, label=label, symbol=f"{number}",
            render="true",
        )  # fmt: skip
        symbol(symbols, f"{number}", kind, parts)


def _routes(known: Sequence[tuple[str, VehicleStyle]]) -> str:
    def own(colour: str, dash: str, cap: str) -> list[Part]:
        # White casings of all lie below the lines of all, or one would cut through another.
        access = f"if(\"role\" = 'access', {2 * MM_PER_PX:.3f}, {4 * MM_PER_PX:.3f})"
        return [
            line(CASING, 8, cap="butt", level=0, computed={"enabled": ALONE}),
            line(
                colour, 4, dash, cap, level=1, computed={"enabled": ALONE, "outlineWidth": access}
            ),
            generalised(
                line(colour, 4, dash, cap, computed={"offset": ASIDE}),
                f"{BESIDE_PX / 2} * (array_length({COMPANY}) - 1)",
                1,
                {"enabled": f"NOT ({ALONE})"},
            ),
        ]

    def fill(root: Element) -> None:
        if known:
            _categories(
                root, "line", "vehicle",
                [(name, _called(name, style), own(style.colour, style.dash, style.cap))
                 for name, style in known],
                levels=True,
            )  # fmt: skip
            return
        renderer = _renderer(root, "singleSymbol", symbollevels="1")
        symbol(SubElement(renderer, "symbols"), "0", "line", own(CROWD, "", "butt"))

    return _document(fill)


def _called(name: str, style: VehicleStyle) -> str:
    return name if name == style.letter else f"{style.letter}: {name}"


def _platoons(root: Element) -> None:
    widest = f"{BESIDE_PX / 2} * ({column('size')} - 1)"
    width = f"{BESIDE_PX * MM_PER_PX:.4f} * (1 + {column('size')})"
    renderer = _renderer(root, "singleSymbol", symbollevels="1")
    symbol(
        SubElement(renderer, "symbols"), "0", "line",
        [
            generalised(
                line(PLATOON_CASING, 20,
                     computed={"outlineWidth": f"{width} + {2 * MM_PER_PX:.4f}"}),
                widest, 0,
            ),
            generalised(line(PLATOON, 18, computed={"outlineWidth": width}), widest, 1),
        ],
    )  # fmt: skip


def _points(known: Sequence[tuple[str, VehicleStyle]]) -> str:
    def of_vehicle(part: Callable[[VehicleStyle], str], otherwise: str) -> str:
        pairs = ", ".join(f"{quoted(name)}, {quoted(part(style))}" for name, style in known)
        found = f"map_get(map({pairs}), {column('vehicles')})"
        return f"coalesce({found}, {quoted(otherwise)})" if known else quoted(otherwise)

    def end(shape: str) -> list[Part]:
        colour = of_vehicle(lambda style: style.colour, CROWD)
        body = mark(shape, CROWD, END_PX, computed={"fillColor": colour})
        sizes = of_vehicle(lambda style: f"{letter_size(style.letter) * MM_PER_PX:.3f}", "0")
        drawn = {"char": of_vehicle(lambda style: style.letter, ""), "size": f"to_real({sizes})"}
        return [body, letter(PAPER, 11, drawn)] if known else [body]

    def fill(root: Element) -> None:
        _categories(
            root, "marker", "kind",
            [
                ("start", "start", end("circle")),
                ("destination", "destination", end("square")),
                ("merge", "merging point", [picture(MERGE, EVENT_PX)]),
                ("separation", "separation point", [picture(SEPARATION, EVENT_PX)]),
            ],
        )  # fmt: skip
        _labels(root, column("name"))

    return _document(fill)


def _pauses(root: Element) -> None:
    _categories(
        root, "marker", "purpose",
        [(purpose, label, [picture(drawn, EVENT_PX)]) for purpose, label, drawn in PAUSES],
    )  # fmt: skip
    _labels(root, f"trim({column('place')} || ' ' || round({column('minutes')}) || ' min')")


def _labels(root: Element, expression: str) -> None:
    root.set("labelsEnabled", "1")
    settings = SubElement(SubElement(root, "labeling", type="simple"), "settings")
    text = SubElement(
        settings, "text-style", fieldName=expression, isExpression="1", fontFamily="Sans Serif",
        fontSize="9", fontSizeUnit="Point", textColor=rgba(INK), textOpacity="1",
    )  # fmt: skip
    SubElement(
        text, "text-buffer", bufferDraw="1", bufferSize="0.8", bufferSizeUnits="MM",
        bufferColor=rgba(PAPER), bufferOpacity="0.9",
    )  # fmt: skip
    # 6 is QGIS's "cartographic" placement: beside a mark, where it covers least.
    SubElement(settings, "placement", placement="6", dist="0.5", distUnits="MM")
    SubElement(settings, "rendering", obstacle="1", displayAll="0")


def _network(root: Element) -> None:
    _categories(
        root, "line", f"if({column('inferred')}, 'inferred', 'known')",
        [
            ("known", "motorway", [line(NETWORK, 1.6)]),
            ("inferred", "inferred link", [line(INFERRED, 1.8, "5 4", "butt")]),
        ],
    )  # fmt: skip
