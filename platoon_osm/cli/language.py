"""The options that say which language pages are written in."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

import click

from .options import SectionOption

__all__ = ["language_option", "language_options"]

Run = TypeVar("Run", bound=Callable[..., Any])

WRITTEN = "How pages are written"


def language_options(verb: Run) -> Run:
    """Add --language and --clock to a verb; whatever it writes is in that language.

    Parameters
    ----------
    verb : callable
        What the verb does; it does not take the options itself.

    Returns
    -------
    callable
        The same, with the options.
    """
    hours = click.option(
        "--clock", cls=_Written, type=click.Choice(["24", "12"]), help="Hours of the clock."
    )
    return _language(hours(_speaking(verb)))


def language_option(verb: Run) -> Run:
    """Add --language alone to a verb that tells no times of day.

    Parameters
    ----------
    verb : callable
        As of `language_options`.

    Returns
    -------
    callable
        The same, with the option.
    """
    return _language(_speaking(verb))


def _language(verb: Run) -> Run:
    asked = click.option(
        "--language",
        cls=_Written,
        metavar="TEXT",
        help="en, de or it, with a region if you like (en-US); else English.",
    )
    return asked(verb)


def _speaking(verb: Run) -> Run:
    @functools.wraps(verb)
    def run(*, language: str | None, clock: str | None = None, **given: Any) -> Any:
        from ..report.language.speech import speaking

        # Before any work, so that a language that is not there is told at once.
        with speaking(language, None if clock is None else int(clock)):
            return verb(**given)

    return run  # type: ignore[return-value]  # `wraps` keeps the signature of the verb


class _Written(SectionOption):
    def __init__(self, names: list[str], **more: Any) -> None:
        super().__init__(names, WRITTEN, **more)
