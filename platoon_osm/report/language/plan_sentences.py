"""Sentences that plans carry in English, told in the language that is spoken.

A plan is a file that anybody may read, so its reasons, conditions and remarks are written in it, in
English. The catalogue's table [plan] has each of these sentences with {fields} for what changes; a
sentence that fits one is told in the words of another language, any other as it stands.
"""

from __future__ import annotations

import functools
import re
from string import Formatter

from .languages import language_of
from .speech import DEFAULT, number, say, spoken

__all__ = ["in_language"]

PLAN = "plan."

UNDER_A_MINUTE = "less than a minute"
"""What `plans.clock.late_by` says of a small lateness."""

# A name may hold commas and "and"; a time ends what is told of it.
_LATE_BY = re.compile(
    r"(.+?) by (?:(\d+ h \d\d min|\d+ min)|less than a minute)(?:, | and |$)", re.DOTALL
)
_MORE = re.compile(r" and ([\d,]+) more$")
_SHARE = re.compile(r"(-?\d+\.\d+)%")


def in_language(sentence: str) -> str:
    """Return a sentence of a plan in the language that is spoken.

    Parameters
    ----------
    sentence : str
        As the planner wrote it.

    Returns
    -------
    str
        The same in other words; as it is if the catalogue does not know it.
    """
    if spoken().texts is language_of(DEFAULT).texts:
        return sentence
    for key, pattern in _patterns():
        if found := pattern.fullmatch(sentence):
            fields = found.groupdict().items()
            return say(key, **{name: _field(name, text) for name, text in fields})
    return sentence


def _field(name: str, text: str) -> str:
    if name == "late":
        return _late(text)
    if name == "why":
        return in_language(text)
    if name == "time" and text == UNDER_A_MINUTE:
        return say("clock.under-a-minute")
    return _figures(text)


def _late(text: str) -> str:
    """Return who is late by how much, one after another, as the language lists them."""
    told = [
        say("schedule.late-by", vehicle=who, time=time or say("clock.under-a-minute"))
        for who, time in _LATE_BY.findall(text)
    ]
    if not told:
        return text
    if more := _MORE.search(text):
        count = int(more[1].replace(",", ""))
        return say("list.more", n=count, who=", ".join(told))
    *before, last = told
    return say("list.and", before=", ".join(before), last=last) if before else last


def _figures(text: str) -> str:
    """Return a field with its decimals as the language writes them."""
    if found := _SHARE.fullmatch(text):
        decimals = len(found[1].partition(".")[2])
        return say("form.percent", number=number(float(found[1]), decimals))
    if re.fullmatch(r"\d+\.\d+", text):
        return number(float(text), len(text.partition(".")[2]))
    return text


@functools.cache
def _patterns() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Return what each sentence looks like, those with most words of their own first."""
    found = []
    for key, text in language_of(DEFAULT).texts.items():
        if key.startswith(PLAN) and isinstance(text, str):
            parts = list(Formatter().parse(text))
            source = "".join(
                re.escape(before) + (f"(?P<{name}>.+?)" if name else "")
                for before, name, _, _ in parts
            )
            own = sum(len(before) for before, _, _, _ in parts)
            found.append((-own, key, re.compile(source, re.DOTALL)))
    return tuple((key, pattern) for _, key, pattern in sorted(found, key=lambda one: one[:2]))
