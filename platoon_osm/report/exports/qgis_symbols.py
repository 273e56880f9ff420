"""Symbols of QGIS as XML: lines, marks, and what of them follows from a feature's columns.

The form is that of QGIS 3.22 and later: a layer of a symbol is a map of options, each of which has
a default, so only those that matter are written. Lengths are millimetres; a pixel of the page,
of which there are 96 in an inch, is 0.26458 mm.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element, SubElement

__all__ = [
    "MM_PER_PX", "Part", "column", "generalised", "letter", "line", "mark", "millimetres",
    "picture", "quoted", "rgba", "symbol",
]  # fmt: skip

MM_PER_PX = 25.4 / 96

METRES_PER_DEGREE = 111_320
"""Along a meridian."""

SOME_SCALE = 2_000_000
"""Of a map that does not tell its own."""

ROUNDED = 3
"""How often corners are cut, so that what is left of bends is round."""

TOLERANCES_PX = (3, 4, 6, 9, 13, 18, 25, 35)
"""How far a line may leave the road, from the least on."""

SHORTENED = 0.1
"""Share of its length that a line may lose or gain beside another."""

RAISED = 0.12
"""Share of the size by which letters are lifted."""

CAPS = {"butt": "flat", "round": "round"}

NAMED = {"white": "#ffffff"}

Computed = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Part:
    """One layer of a symbol.

    Attributes
    ----------
    kind : str
        Its class in QGIS, such as "SimpleLine".
    options : mapping of str to str
        What it looks like.
    computed : mapping of str to str
        Properties that an expression gives for each feature, by QGIS's names of them.
    level : int
        When it is drawn: after all parts of all features with a lower one.
    inside : Part or None
        What draws the shape that this one makes.
    """

    kind: str
    options: Mapping[str, str]
    computed: Computed = field(default_factory=dict)
    level: int = 0
    inside: Part | None = None


def line(
    colour: str, width_px: float, dash: str = "", cap: str = "round", *, level: int = 0,
    computed: Computed | None = None,
) -> Part:  # fmt: skip
    """Return a line.

    Parameters
    ----------
    colour : str
        As in a page: #rgb, #rrggbb or a name.
    width_px : float
        As in a page.
    dash, cap : str
        SVG dash array and line cap, as in a page.
    level : int
        See `Part`.
    computed : mapping, optional
        See `Part`.

    Returns
    -------
    Part
        Of a symbol of lines.
    """
    dashes = ";".join(millimetres(float(length)) for length in dash.split())
    options = {
        "line_color": rgba(colour), "line_width": millimetres(width_px), "line_width_unit": "MM",
        "line_style": "solid", "capstyle": CAPS[cap], "joinstyle": "round", "offset_unit": "MM",
        "use_custom_dash": "1" if dashes else "0", "customdash": dashes or "5;2",
        "customdash_unit": "MM",
    }  # fmt: skip
    return Part("SimpleLine", options, computed or {}, level)


def mark(
    shape: str, colour: str, size_px: float, *, edge: str = "white", edge_px: float = 1.5,
    computed: Computed | None = None,
) -> Part:  # fmt: skip
    """Return a plain mark.

    Parameters
    ----------
    shape : {"circle", "square"}
        Its form.
    colour : str
        Of its body.
    size_px : float
        How wide it is.
    edge : str
        The colour of its outline.
    edge_px : float
        How wide that is.
    computed : mapping, optional
        See `Part`.

    Returns
    -------
    Part
        Of a symbol of points.
    """
    options = {
        "name": shape, "color": rgba(colour), "outline_color": rgba(edge),
        "outline_width": millimetres(edge_px), "outline_width_unit": "MM", "outline_style": "solid",
        "size": millimetres(size_px), "size_unit": "MM",
    }  # fmt: skip
    return Part("SimpleMarker", options, computed or {})


def letter(colour: str, size_px: float, computed: Computed) -> Part:
    """Return letters on a mark.

    Parameters
    ----------
    colour : str
        Of the type.
    size_px : float
        Of the type.
    computed : mapping
        With the expression for "char".

    Returns
    -------
    Part
        Of a symbol of points.
    """
    options = {
        "chr": "", "color": rgba(colour), "font": "Sans Serif", "font_style": "Bold",
        "size": millimetres(size_px), "size_unit": "MM", "outline_width": "0",
        # QGIS centres lines of type; capitals stand above the middle of theirs.
        "offset": f"0,-{millimetres(RAISED * size_px)}", "offset_unit": "MM",
    }  # fmt: skip
    return Part("FontMarker", options, computed)


def picture(svg: str, size_px: float) -> Part:
    """Return a picture that the style holds itself.

    Parameters
    ----------
    svg : str
        The whole of an SVG file.
    size_px : float
        How wide it is.

    Returns
    -------
    Part
        Of a symbol of points.
    """
    data = base64.b64encode(svg.encode()).decode()
    options = {
        "name": f"base64:{data}", "size": millimetres(size_px), "size_unit": "MM",
        "outline_width": "0",
    }  # fmt: skip
    return Part("SvgMarker", options)


def generalised(of: Part, widest_px: str, level: int, computed: Computed | None = None) -> Part:
    """Return lines drawn without bends that are tighter than what lies side by side there is wide.

    A line beside another has no place in such bends, and QGIS leaves out what it cannot draw. So
    the line is simplified, by as little as leaves it its length on both sides, and rounded.

    Parameters
    ----------
    of : Part
        How they are drawn.
    widest_px : str
        Expression for how far the outermost line lies from the middle, in pixels of the page.
    level : int
        See `Part`.
    computed : mapping, optional
        See `Part`.

    Returns
    -------
    Part
        Of a symbol of lines.
    """
    pixel = f"{MM_PER_PX / 1000 / METRES_PER_DEGREE:.4g} * coalesce(@map_scale, {SOME_SCALE})"

    def simpler(pixels: str) -> str:
        return f"smooth(simplify($geometry, {pixels} * @pixel), {ROUNDED})"

    fits = " AND ".join(
        f"abs(length(offset_curve(@line, {sign}@aside)) / length(@line) - 1) < {SHORTENED}"
        for sign in ("", "-")
    )
    enough = (
        f"array_filter(array({', '.join(map(str, TOLERANCES_PX))}), "
        f"with_variable('line', {simpler('@element')}, {fits}))"
    )
    shape = (
        f"with_variable('pixel', {pixel}, with_variable('aside', ({widest_px}) * @pixel, "
        f"with_variable('least', coalesce(array_first({enough}), {TOLERANCES_PX[-1]}), "
        f"{simpler('@least')})))"
    )
    options = {"SymbolType": "Line", "geometryModifier": shape}
    return Part("GeometryGenerator", options, computed or {}, level, of)


def symbol(parent: Element, name: str, kind: str, parts: Sequence[Part]) -> None:
    """Add a symbol to those of a renderer.

    Parameters
    ----------
    parent : Element
        The list of symbols.
    name : str
        By which rules and categories know it.
    kind : {"line", "marker"}
        What it draws.
    parts : sequence of Part
        From below.
    """
    made = SubElement(
        parent, "symbol", type=kind, name=name, alpha="1", clip_to_extent="1", force_rhr="0"
    )
    for number, part in enumerate(parts):
        layer = SubElement(
            made, "layer", {"class": part.kind, "pass": f"{part.level}", "enabled": "1",
                            "locked": "0"},
        )  # fmt: skip
        options = SubElement(layer, "Option", type="Map")
        for key, value in part.options.items():
            SubElement(options, "Option", type="QString", name=key, value=value)
        if part.computed:
            own = SubElement(layer, "data_defined_properties")
            _computed(SubElement(own, "Option", type="Map"), part.computed)
        if part.inside is not None:
            symbol(layer, f"@{name}@{number}", kind, [part.inside])


def _computed(options: Element, expressions: Computed) -> None:
    SubElement(options, "Option", type="QString", name="name", value="")
    properties = SubElement(options, "Option", type="Map", name="properties")
    for key, expression in expressions.items():
        one = SubElement(properties, "Option", type="Map", name=key)
        SubElement(one, "Option", type="bool", name="active", value="true")
        SubElement(one, "Option", type="QString", name="expression", value=expression)
        SubElement(one, "Option", type="int", name="type", value="3")
    SubElement(options, "Option", type="QString", name="type", value="collection")


def millimetres(pixels: float) -> str:
    """Return a length of the page as QGIS takes it.

    Parameters
    ----------
    pixels : float
        Of which there are 96 in an inch.

    Returns
    -------
    str
        In millimetres.
    """
    return f"{pixels * MM_PER_PX:.3f}"


def rgba(colour: str) -> str:
    """Return a colour as QGIS takes it.

    Parameters
    ----------
    colour : str
        #rgb, #rrggbb or a name in `NAMED`.

    Returns
    -------
    str
        Red, green, blue and how opaque it is, 0 to 255.
    """
    digits = NAMED.get(colour, colour).lstrip("#")
    if len(digits) == 3:
        digits = "".join(2 * digit for digit in digits)
    return ",".join(f"{int(digits[k : k + 2], 16)}" for k in (0, 2, 4)) + ",255"


def quoted(text: str) -> str:
    """Return a text as a constant of QGIS's expressions, whatever is in it.

    Parameters
    ----------
    text : str
        Anybody's.

    Returns
    -------
    str
        Between apostrophes.
    """
    return "'" + re.sub(r"(['\\])", r"\\\1", text) + "'"


def column(name: str) -> str:
    """Return a column in QGIS's expressions.

    Parameters
    ----------
    name : str
        Ours, of letters alone.

    Returns
    -------
    str
        Between quotes.
    """
    return f'"{name}"'
