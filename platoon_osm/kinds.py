"""What kind of value somebody gave, asked by every check of an argument."""

from __future__ import annotations

from typing import TypeGuard

__all__ = ["is_number", "is_whole", "kind_of"]


def is_number(value: object) -> TypeGuard[float]:
    """Whether it is a number of Python's own; True and False are not meant as 1 and 0.

    Parameters
    ----------
    value : object
        Anything.

    Returns
    -------
    bool
        True for int and float, not finite ones among them.
    """
    return isinstance(value, int | float) and not isinstance(value, bool)


def is_whole(value: object) -> TypeGuard[int]:
    """Whether it is a whole number of Python's own; True and False are not meant as 1 and 0.

    Parameters
    ----------
    value : object
        Anything.

    Returns
    -------
    bool
        True for int.
    """
    return isinstance(value, int) and not isinstance(value, bool)


def kind_of(value: object) -> str:
    """Return what a value is called in a message: "list", or "class" where it is one itself.

    Parameters
    ----------
    value : object
        Anything.

    Returns
    -------
    str
        One word.
    """
    return "class" if isinstance(value, type) else type(value).__name__
