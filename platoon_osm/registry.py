"""Lists that can grow: readers, exporters, cost presets and fuel tables, each found by its name.

What is registered here shows up wherever the list is used, in messages and in the command, so a
user adds one without touching the package:

    from platoon_osm.costs.fuel import FUEL_SAVINGS, FuelSaving
    FUEL_SAVINGS.add(FuelSaving("ours", 0.02, 0.06, 0.06, "measured by ourselves"))
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol, TypeVar

from .errors import ScenarioError, brief

__all__ = ["Named", "Registry", "looked_up"]


class Named(Protocol):
    """Anything with a name."""

    @property
    def name(self) -> str:
        """What it is called in files, options and messages."""
        ...


Item = TypeVar("Item", bound=Named)
Thing = TypeVar("Thing")

COMPARED = 60
"""Letters of an unknown name that are compared with others: longer texts take too long."""


def looked_up(kind: str, name: object, items: Mapping[str, Thing]) -> Thing:
    """Return the item of a name.

    Parameters
    ----------
    kind : str
        What one item is, for messages.
    name : object
        A name; anything else is refused in the same words.
    items : mapping of str to Thing
        All there are.

    Returns
    -------
    Thing
        The one that has it.

    Raises
    ------
    ScenarioError
        No item has it; the message names the nearest, and all there are.
    """
    if isinstance(name, str) and name in items:
        return items[name]
    near = []
    if isinstance(name, str):
        near = difflib.get_close_matches(name[:COMPARED], items, 1, 0.5)
    hint = f"did you mean {near[0]!r}? " if near else ""
    raise ScenarioError(f"{kind} {brief(name)} is unknown; {hint}use one of {', '.join(items)}")


class Registry(Mapping[str, Item]):
    """Items by name, in the order in which they were added.

    Parameters
    ----------
    kind : str
        What one item is, for messages: "fuel saving".
    items : iterable of Item
        Those that come with the package.
    """

    def __init__(self, kind: str, items: Iterable[Item] = ()) -> None:
        self.kind = kind
        self._items: dict[str, Item] = {}
        for item in items:
            self.add(item)

    def add(self, item: Item, *, replace: bool = False) -> Item:
        """Add an item and return it.

        Parameters
        ----------
        item : Item
            Its name is what it is found by.
        replace : bool
            Whether it may take the place of another of the same name.

        Returns
        -------
        Item
            The same item.

        Raises
        ------
        ScenarioError
            The name is empty, or taken by another.
        """
        name = item.name
        if not isinstance(name, str) or not name.strip():
            raise ScenarioError(f"{self.kind} {name!r}: its name must be a non-empty text")
        if not replace and self._items.get(name, item) is not item:
            raise ScenarioError(
                f"{self.kind} {name!r} is there already; choose another name or replace=True"
            )
        self._items[name] = item
        return item

    def remove(self, name: object) -> Item:
        """Take an item off the list and return it.

        Parameters
        ----------
        name : object
            Its name.

        Returns
        -------
        Item
            What had that name.

        Raises
        ------
        ScenarioError
            No item has it.
        """
        return self._items.pop(self.find(name).name)

    def find(self, name: object) -> Item:
        """Return the item of a name.

        Parameters
        ----------
        name : object
            A name; anything else is refused in the same words.

        Returns
        -------
        Item
            The one that has it.

        Raises
        ------
        ScenarioError
            No item has it; the message names the nearest, and all there are.
        """
        return looked_up(self.kind, name, self._items)

    def __getitem__(self, name: str) -> Item:
        return self._items[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)
