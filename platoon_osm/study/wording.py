"""Numbers of a study, and what its readings are called, in the language that is spoken."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce

from ..report.language.speech import number, say, spoken

__all__ = ["called", "figure", "joined", "kilometres", "mixed", "percent", "summed", "whose"]

CALLED = {
    "dijkstra": "study.dijkstra",
    "astar": "study.astar",
    "astar-closed-once": "study.astar-once",
}
MIXED = {"printed": "study.as-printed", "gain": "study.as-gains"}
TERMS = {"distance": "study.distance", "time": "study.time", "fuel": "study.fuel"}
WHOSE = {
    "members": "study.members",
    "system": "study.with-master",
    "joined": "study.joined",
    "merges and separates": "study.merges",
    "inside the master's route": "study.inside",
}


def figure(value: float, digits: int | None = None) -> str:
    """Return a number, never "-0.0".

    Parameters
    ----------
    value : float
        Any.
    digits : int or None
        Behind the decimal sign; None for as many as it needs, six figures at most.

    Returns
    -------
    str
        In the form of the language; in English as the paper prints them, with no sign between
        thousands.
    """
    if isinstance(value, int):
        digits = 0
    if digits is None:
        text = f"{value:g}"
        if "e" in text:
            return text
        digits = len(text.partition(".")[2])
    text = number(round(value, digits) + 0.0, digits)
    return text.replace(",", "") if spoken().code[:2] == "en" else text


def percent(value: float, digits: int | None = None) -> str:
    """Return a percentage with its sign.

    Parameters
    ----------
    value : float
        In percent.
    digits : int or None
        As of `figure`.

    Returns
    -------
    str
        Such as "8 %".
    """
    return say("study.percent", value=figure(value, digits))


def kilometres(metres: float) -> str:
    """Return a length without its unit.

    Parameters
    ----------
    metres : float
        In metres.

    Returns
    -------
    str
        In kilometres.
    """
    return figure(metres / 1000)


def joined(key: str, texts: Iterable[str]) -> str:
    """Return texts as one.

    Parameters
    ----------
    key : str
        Of a text that puts {one} and {other} together.
    texts : iterable of str
        One or more.

    Returns
    -------
    str
        From left to right.
    """
    return reduce(lambda one, other: say(key, one=one, other=other), texts)


def called(method: str) -> str:
    """Return what a way to find routes is called.

    Parameters
    ----------
    method : {"dijkstra", "astar", "astar-closed-once"}
        The way.

    Returns
    -------
    str
        Such as "A*, each node once".
    """
    return say(CALLED[method])


def mixed(mixing: str) -> str:
    """Return how tau and xi are read.

    Parameters
    ----------
    mixing : {"printed", "gain"}
        The reading.

    Returns
    -------
    str
        Such as "as printed".
    """
    return say(MIXED[mixing])


def summed(terms: str, plus: str = "study.plus") -> str:
    """Return which terms are added up.

    Parameters
    ----------
    terms : str
        Such as "distance+time".
    plus : str
        Key of the text that adds one to another.

    Returns
    -------
    str
        Such as "distance + time".
    """
    return joined(plus, (say(TERMS[term]) for term in terms.split("+")))


def whose(name: str) -> str:
    """Return whose cost is counted, or who counts as taking part.

    Parameters
    ----------
    name : str
        Of `TOTALS` or `INVOLVEMENTS`.

    Returns
    -------
    str
        Heads a column.
    """
    return say(WHOSE[name])
