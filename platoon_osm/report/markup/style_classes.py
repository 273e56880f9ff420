"""What drawings say of themselves again and again, said once: a class in place of attributes.

A drawing says how each of its elements looks in attributes of its own, so that it is whole wherever
it is put. In a page of a hundred drawings the same few sets of them are a good part of its weight.
Here each set that is frequent becomes a rule, and its elements name it. Rules stand within
`:where()` before all others, and so give way to every rule that an attribute gave way to; and a
rule for all that have a colour (assets/theme.css) is one for those whose class has it, too. Numbers
lose zeros behind the point and their quotes, and what moves nothing is left out.
"""

from __future__ import annotations

import re
from collections import Counter

from .fragments import Markup

__all__ = ["with_style_classes"]

STYLED = (
    "text-anchor", "font-size", "font-weight", "stroke-width", "stroke-dasharray", "stroke-linecap",
    "stroke-linejoin", "stroke-opacity", "fill-opacity", "unicode-bidi",
)  # fmt: skip
"""Attributes that mean in a rule what they mean by themselves."""

COLOURS = ("fill", "stroke")

PLACED = (
    "x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "r", "width", "height", "points", "d",
    "transform",
)  # fmt: skip
"""Attributes that are numbers, or made of numbers."""

RULE_BYTES = 14
"""What a rule weighs besides its declarations: `:where(._a){}` and more."""

_ELEMENT = re.compile(
    r"<(text|line|path|rect|circle|polyline|polygon|g|use)((?: [\w-]+=\"[^\"<>]*\")+)(/?>)"
)
_ATTRIBUTE = re.compile(r' ([\w-]+)="([^"]*)"')
_BARE = re.compile(r'="([-\w.]+)" ')
_HARMLESS = re.compile(r"[-\w. ]+")
_ZEROS = re.compile(r"(?<=\d)(\.\d*?)0+(?!\d)")
_STILL = re.compile(r"translate\(-?0 -?0\)|scale\(1\)")
_COLOUR = re.compile(r"none|#[\da-f]+")
_OF_COLOUR = re.compile(r'\[(fill|stroke)="(#[\da-f]+)"\]')
_DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"


def with_style_classes(markup: Markup, style: str) -> tuple[Markup, str]:
    """Return markup whose drawings name rules, and the style with these rules.

    Parameters
    ----------
    markup : Markup
        HTML; all texts in it are escaped.
    style : str
        The style sheet of the page.

    Returns
    -------
    markup : Markup
        Looks the same under the style that is returned.
    style : str
        The same style sheet, with more rules.
    """
    counts = Counter(_look(found[2]) for found in _ELEMENT.finditer(markup))
    # Of two as frequent the first to appear comes first: the same page gets the same bytes.
    worth = [look for look, count in counts.most_common() if _saves(look, count)]
    names = {look: f"_{_short(number)}" for number, look in enumerate(worth)}

    def named(found: re.Match[str]) -> str:
        element, attributes, end = found.groups()
        name = names.get(_look(attributes))
        told = _ATTRIBUTE.findall(attributes)
        if name is not None:
            told = [one for one in told if not _is_look(*one)]
            known = next((value for key, value in told if key == "class"), "")
            told = [one for one in told if one[0] != "class"]
            told.insert(0, ("class", f"{known} {name}".strip()))
        kept = "".join(_attribute(*one) for one in told)
        # The last value keeps its quotes, for a slash behind it would be a part of it.
        return f"<{element}" + _BARE.sub(r"=\1 ", f"{kept}{end}")

    def coloured(found: re.Match[str]) -> str:
        same = [f".{name}" for look, name in names.items() if f' {found[1]}="{found[2]}"' in look]
        return f":is({','.join([found[0], *same])})" if same else found[0]

    rules = "".join(f":where(.{name}){{{_declared(look)}}}" for look, name in names.items())
    return Markup(_ELEMENT.sub(named, markup)), rules + _OF_COLOUR.sub(coloured, style)


def _saves(look: str, count: int) -> bool:
    """Return whether a class is less to write than what it stands for."""
    return count * (len(look) - len(" class=_aa")) > len(look) + RULE_BYTES


def _is_look(name: str, value: str) -> bool:
    if name in COLOURS:
        return _COLOUR.fullmatch(value) is not None
    return name in STYLED and _HARMLESS.fullmatch(value) is not None


def _look(attributes: str) -> str:
    """Return what an element says of its look, in its own order."""
    return "".join(
        f' {name}="{value}"'
        for name, value in _ATTRIBUTE.findall(attributes)
        if _is_look(name, value)
    )


def _attribute(name: str, value: str) -> str:
    if name in PLACED:
        value = _ZEROS.sub(lambda found: found[1].rstrip("."), value)
    if name == "transform":
        value = _STILL.sub("", value).strip()
        if not value:
            return ""
    return f' {name}="{value}"'


def _declared(look: str) -> str:
    return ";".join(
        f"{name}:{value}px" if name == "font-size" else f"{name}:{value}"
        for name, value in _ATTRIBUTE.findall(look)
    )


def _short(number: int) -> str:
    text = ""
    while True:
        number, digit = divmod(number, len(_DIGITS))
        text = _DIGITS[digit] + text
        if not number:
            return text
