"""Languages that pages are written in: a file of texts each, numbers and dates in their form.

Another language is one more file in `texts/`, with the keys of en.toml. Numbers, dates and plural
forms follow the Unicode locale data that Babel carries.
"""

from __future__ import annotations

import functools
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from importlib.resources import files
from typing import TYPE_CHECKING

from ...errors import ScenarioError, brief

if TYPE_CHECKING:
    from babel import Locale

__all__ = ["CLOCKS", "Language", "Text", "language_of", "languages"]

CLOCKS = (24, 12)
"""Hours on the face of a clock."""

Text = str | Mapping[str, str]
"""A text with its {fields}; or one for each plural form."""

SCRIPT = "script."
"""What the texts begin with that the script of a page uses."""


@dataclass(frozen=True, slots=True, eq=False)
class Language:
    """A language as pages speak it.

    Attributes
    ----------
    code : str
        BCP 47, such as "de" or "en-US".
    clock : int
        24 or 12 hours.
    texts : mapping of str to Text
        By key, "table.key" of the catalogue.
    locale : Locale
        Of Babel.
    """

    code: str
    clock: int
    texts: Mapping[str, Text]
    locale: Locale

    @property
    def own_name(self) -> str:
        """What its speakers call it, with the region if one was asked for."""
        name = self.locale.languages[self.locale.language].capitalize()
        region = self.locale.territories.get(self.locale.territory)
        return f"{name} ({region})" if region and "-" in self.code else name

    def say(self, key: str, /, **fields: object) -> str:
        """Return a text with its fields filled in.

        Parameters
        ----------
        key : str
            Of the catalogue.
        **fields : object
            By name; a whole number `n` chooses among plural forms and is printed in the form of
            the language.

        Returns
        -------
        str
            In this language.

        Raises
        ------
        KeyError
            A key or a field that is not there: a fault of ours.
        """
        text = self.texts[key]
        number = fields.get("n")
        if isinstance(number, int):
            fields["n"] = self.number(number)
        if not isinstance(text, str):
            form = self.locale.plural_form(number) if isinstance(number, int) else "other"
            text = text.get(form, text["other"])
        return text.format_map(fields)

    def number(self, value: float, decimals: int = 0) -> str:
        """Return a number as the language writes it.

        Parameters
        ----------
        value : float
            Any.
        decimals : int
            Behind the decimal sign.

        Returns
        -------
        str
            With signs between thousands; below 0 with a hyphen.
        """
        return f"{value:,.{decimals}f}".translate(_signs(self.locale))

    def date(self, moment: datetime) -> str:
        """Return a day of the calendar.

        Parameters
        ----------
        moment : datetime
            Of the day.

        Returns
        -------
        str
            With weekday, month in letters and year.
        """
        from babel.dates import format_skeleton

        return format_skeleton("yMMMEd", moment.replace(tzinfo=None), locale=self.locale)

    @property
    def currency_first(self) -> bool:
        """Whether the sign of a currency stands before an amount."""
        pattern: str = self.locale.currency_formats["standard"].pattern
        return pattern.startswith("\u00a4")

    @property
    def of_script(self) -> dict[str, Text]:
        """The texts that the script of a page uses, by the rest of their keys."""
        return {
            key.removeprefix(SCRIPT): text
            for key, text in self.texts.items()
            if key.startswith(SCRIPT)
        }


@functools.cache
def _signs(locale: Locale) -> dict[int, str]:
    from babel.numbers import get_decimal_symbol, get_group_symbol

    return {ord(","): get_group_symbol(locale), ord("."): get_decimal_symbol(locale)}


@functools.cache
def languages() -> tuple[str, ...]:
    """Return the codes of all languages that have a file of texts.

    Returns
    -------
    tuple of str
        In order.
    """
    folder = files(__package__) / "texts"
    names = (entry.name for entry in folder.iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in names if name.endswith(".toml")))


@functools.cache
def language_of(code: str, clock: int | None = None) -> Language:
    """Return a language by its code.

    Parameters
    ----------
    code : str
        Such as "de"; with a region ("en-US", "de_AT") numbers, dates and clock are those of the
        region.
    clock : int or None
        24 or 12 hours; by default as the region has it.

    Returns
    -------
    Language
        One object for each choice.

    Raises
    ------
    ScenarioError
        A language without a file of texts, or another clock.
    """
    from babel import Locale, UnknownLocaleError

    tag = code.replace("_", "-") if isinstance(code, str) else ""
    main = tag.split("-")[0].lower()
    if main not in languages():
        raise ScenarioError(
            f"language {brief(code)} has no texts; give one of {', '.join(languages())}, "
            "with a region if you like (en-US)"
        )
    if clock is not None and clock not in CLOCKS:
        raise ScenarioError(f"clock {brief(clock)} must be 24 or 12")
    # English without a region writes days as most of the world does.
    name = "en-GB" if tag.lower() == "en" else tag
    try:
        locale = Locale.parse(name, sep="-")
    except (UnknownLocaleError, ValueError):
        raise ScenarioError(f"language {brief(code)} is not known; give {main} alone") from None
    if clock is None:
        clock = 12 if "a" in locale.time_formats["short"].pattern else 24
    return Language(tag, clock, _texts(main), locale)


@functools.cache
def _texts(code: str) -> Mapping[str, Text]:
    source = (files(__package__) / "texts" / f"{code}.toml").read_text("utf-8")
    tables = tomllib.loads(source)
    return {
        f"{table}.{key}": text for table, texts in tables.items() for key, text in texts.items()
    }
