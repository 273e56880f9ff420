"""Lists of values as they are typed: 1.4:2.2:0.1, its ends included, or 0,0.5,1, or names."""

from __future__ import annotations

import math

from ..errors import ScenarioError, brief

__all__ = ["MOST_VALUES", "values_of"]

MOST_VALUES = 200
"""Of more values nobody reads the table."""

NEAR = 1e-9
"""A step ends at the end of its range if it comes so near, as a share of the step."""

DIGITS = 12
"""Of values in a range: 1.4 + 0.1 is 1.5."""


def values_of(option: str, text: str, *, names: bool = False) -> list[float | str]:
    """Return what was typed as a list of values.

    Parameters
    ----------
    option : str
        The option, as "--price".
    text : str
        Ranges FROM:TO:STEP and values, with commas between them.
    names : bool
        Whether names may stand for numbers.

    Returns
    -------
    list of float or str
        Each once, in the order typed.

    Raises
    ------
    ScenarioError
        None, too many, a range that never ends, or what is no number.
    """
    found: dict[float | str, None] = {}
    for word in (part.strip() for part in text.split(",")):
        if not word:
            continue
        values = _range(option, word) if ":" in word else [_value(option, word, names)]
        found |= dict.fromkeys(values)
        if len(found) > MOST_VALUES:
            raise _too_many(option, text)
    if not found:
        raise ScenarioError(f"{option}: empty; give values such as 1.4:2.2:0.1 or 0,0.5,1")
    return list(found)


def _too_many(option: str, text: str) -> ScenarioError:
    return ScenarioError(f"{option} {brief(text)}: more than {MOST_VALUES} values; give fewer")


def _value(option: str, word: str, names: bool) -> float | str:
    try:
        value = float(word)
    except ValueError:
        if names:
            return word
        raise ScenarioError(f"{option} {brief(word)}: is no number; give one, or a range") from None
    if not math.isfinite(value):
        raise ScenarioError(f"{option} {brief(word)}: is no finite number; give one")
    return value


def _range(option: str, word: str) -> list[float]:
    parts = word.split(":")
    if len(parts) != 3:
        raise ScenarioError(f"{option} {brief(word)}: write a range as FROM:TO:STEP, 1.4:2.2:0.1")
    first, last, step = (float(_value(option, part.strip(), False)) for part in parts)
    if step <= 0:
        raise ScenarioError(
            f"{option} {brief(word)}: a step of {step:g} never ends; give one above 0"
        )
    if last < first:
        raise ScenarioError(
            f"{option} {brief(word)}: ends before it begins; give FROM:TO:STEP with FROM below TO"
        )
    steps = (last - first) / step
    if not steps < MOST_VALUES:
        raise _too_many(option, word)
    return [round(first + k * step, DIGITS) for k in range(int(steps + NEAR) + 1)]
