"""Exits by their numbers: how people write them, and which nodes carry them.

"A 1 exit 4", "A1 Ausfahrt 4", "exit 4 (A 1)", "exit 12A", "I 5 exit 519B, Sacramento" and, where
it can be nothing else, "12A" are read; so is everything that `place_name` prints. A text may be
read in several ways, and the first that fits a node of the network is meant.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from .road_network import RoadNetwork
from .spelling import bracket_apart, plain, road_keys

__all__ = ["ExitNumbers", "ExitReading", "exit_readings", "has_exit_word", "number_key"]

EXIT_WORDS = (
    "exit", "ausfahrt", "anschlussstelle", "as", "junction", "jct", "j", "sortie", "uscita",
    "svincolo", "salida", "saida", "afrit", "afslag", "avfart", "avkjorsel", "liittyma", "zjazd",
    "wezel", "sjezd", "exit no", "izlaz", "izvoz",
)  # fmt: skip
"""What signs and people call an exit, as `plain` spells it."""

SHORT_WORDS = ("as", "j")
"""These are exits only right before a digit: "J10", "AS 4"."""

NUMBER_SIGN = r"(?:(?:no|nr|n|num|number|nummer)(?:[.\u00b0]\s*|\s+)|[#\u00ba\u00b0]\s*)?"

WORD = re.compile(
    rf"(?<!\w)(?:{'|'.join(word for word in EXIT_WORDS if word not in SHORT_WORDS)})"
    rf"(?!\w)[.:]?\s*{NUMBER_SIGN}"
    rf"|(?<!\w)(?:{'|'.join(SHORT_WORDS)})\s*(?=\d)"
    rf"|(?<!\w)exit(?=\d)"
)
MOST_CUTS = 12
"""In so many places a text is cut to see what fits; nothing that people write has more."""


class ExitReading(NamedTuple):
    """One way to read a text as an exit.

    Attributes
    ----------
    number : str
        As it was written, in small letters.
    roads : str
        Road numbers before or behind it; empty if there are none.
    town : str
        What stands behind a comma or in brackets, a town perhaps; empty if nothing does.
    """

    number: str
    roads: str = ""
    town: str = ""


def number_key(number: str) -> str:
    """Return an exit number as numbers are compared: "12 A" and "12-a" are "12a".

    Parameters
    ----------
    number : str
        One number.

    Returns
    -------
    str
        Without blanks, hyphens before letters, and leading noughts.
    """
    key = "".join(plain(number).split())
    return re.sub(r"(?<=\d)[-_](?=[^\W\d])", "", re.sub(r"^0+(?=\d)", "", key))


def _number_keys(number: str) -> set[str]:
    return {number_key(part) for part in (number, *re.split("[;,]", number))} - {""}


def has_exit_word(text: str) -> bool:
    """Whether a text says that it names an exit.

    Parameters
    ----------
    text : str
        A place as somebody wrote it.

    Returns
    -------
    bool
        True for "A 1 exit 4", False for "4".
    """
    return WORD.search(plain(text)) is not None


def exit_readings(text: str) -> Iterator[ExitReading]:
    """Read a text as an exit, in all ways that there are.

    Parameters
    ----------
    text : str
        A place as somebody wrote it.

    Yields
    ------
    ExitReading
        The likeliest first.
    """
    own = plain(text)
    for word in islice(WORD.finditer(own), MOST_CUTS):
        left = own[: word.start()].strip(" ,-")
        for found in _numbers_in(own[word.end() :].strip()):
            if left and not found.roads:
                yield found._replace(roads=left)
            if not left or found.roads:
                yield found
            if left and not found.town:
                yield found._replace(town=left)
    yield from _numbers_in(own)


def _numbers_in(right: str) -> Iterator[ExitReading]:
    """Read what stands behind the word: a number, and perhaps a road or a town."""
    yield ExitReading(right)
    commas = islice(re.finditer(",", right), MOST_CUTS)
    cuts = [(right[: comma.start()], right[comma.end() :]) for comma in commas]
    cuts.append(bracket_apart(right))
    if " " in right:
        cuts.append((right.partition(" ")[0], right.partition(" ")[2]))
    for number, behind in cuts:
        number, behind = number.strip(), behind.strip()
        if not behind:
            continue
        inner, road = bracket_apart(number)
        if road:
            yield ExitReading(inner, road, behind)
        yield ExitReading(number, behind)
        yield ExitReading(number, "", behind)


class ExitNumbers:
    """Nodes of a network by the exit numbers they carry; kept with it by `net.attached`.

    Parameters
    ----------
    net : RoadNetwork
        Whose numbers.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self._nodes: dict[str, list[int]] = {}
        self._roads: dict[int, frozenset[str]] = {}
        for node in np.flatnonzero(net.node_ref).tolist():
            for key in _number_keys(net.exit_number(node)):
                self._nodes.setdefault(key, []).append(node)
            self._roads[node] = frozenset(road_keys(net.incident_refs(node)))
        # Blanks and signs may be added, but what is far longer is no number.
        self._longest = 20 + 4 * max(map(len, self._nodes), default=0)

    def roads(self, node: int) -> frozenset[str]:
        """Return the roads that meet at a numbered node.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        frozenset of str
            As `road_keys` spells them.
        """
        return self._roads[node]

    def carrying(self, number: str) -> list[int]:
        """Return the nodes that carry a number, on any road.

        Parameters
        ----------
        number : str
            "12A", or "12A;12B" for those that carry both.

        Returns
        -------
        list of int
            Ascending.
        """
        if len(number) > self._longest:
            return []
        if nodes := self._nodes.get(number_key(number)):
            return nodes
        found = [set(self._nodes.get(number_key(part), ())) for part in number.split(";")]
        return sorted(set.intersection(*found))
