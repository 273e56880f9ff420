"""What is shown while a command works: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress, ProgressColumn

__all__ = ["counted", "searched", "steps"]


@contextmanager
def steps(total: int) -> Iterator[Callable[[str], None]]:
    """Show the steps of some work, each by its name.

    Parameters
    ----------
    total : int
        How many steps there are.

    Yields
    ------
    callable
        Begins the next step; takes its name.
    """
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

    with _bar(TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()) as bar:
        task = bar.add_task("", total=total)
        begun = False

        def begin(what: str) -> None:
            nonlocal begun
            bar.update(task, description=what, advance=1 if begun else 0)
            begun = True

        yield begin


@contextmanager
def counted(what: str, total: int) -> Iterator[Callable[[int], None]]:
    """Show how many things are done and how long the rest will take.

    Parameters
    ----------
    what : str
        What is counted: "networks".
    total : int
        How many there are.

    Yields
    ------
    callable
        Counts; takes how many more are done.
    """
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

    left = TextColumn("time left"), TimeRemainingColumn()
    with _bar(TextColumn(what), BarColumn(), MofNCompleteColumn(), *left) as bar:
        task = bar.add_task("", total=total)
        yield lambda count: bar.update(task, advance=count)


@contextmanager
def searched(what: str) -> Iterator[Callable[[float, str], None]]:
    """Show how far a search is, and what it has found.

    Parameters
    ----------
    what : str
        What is searched for.

    Yields
    ------
    callable
        Takes which share of its time or rounds it has used, and a text.
    """
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

    said = TextColumn("{task.fields[said]}")
    with _bar(TextColumn(what), BarColumn(), TimeElapsedColumn(), said) as bar:
        task = bar.add_task("", total=1.0, said="")
        yield lambda share, text: bar.update(task, completed=share, said=text)


def _bar(*columns: ProgressColumn) -> Progress:
    from rich.console import Console
    from rich.progress import Progress

    console = Console(stderr=True)
    return Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
