"""What verbs have in common: kinds of values, options of roads and trucks, help in sections."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import click
from click.core import ParameterSource

from ..costs.presets import PRESETS
from ..driving.rules import RULES
from ..errors import ScenarioError
from ..registry import Named, Registry
from .outputs import output_kind

__all__ = [
    "FILE",
    "FOLDER",
    "LIMITER",
    "SectionOption",
    "Sections",
    "classes_of",
    "classes_option",
    "network_options",
    "objective_named",
    "output_option",
    "rules_named",
    "truck_options",
    "was_given",
]

Run = TypeVar("Run", bound=Callable[..., Any])
Item = TypeVar("Item", bound=Named)

FILE = click.Path(path_type=Path)
"""A path of any kind; whoever opens it says what is wrong with it."""
FOLDER = click.Path(file_okay=False, path_type=Path)
"""A folder, which may be there already."""
FOLDER.name = "folder"


LIMITER = ("--limiter-kmh", "--limiter", "limiter_kmh")
"""Names of one option; the longer is the key of scenarios."""


def classes_of(text: str) -> tuple[str, ...]:
    """Read a list of highway values.

    Parameters
    ----------
    text : str
        What was typed, with commas.

    Returns
    -------
    tuple of str
        The values.

    Raises
    ------
    ScenarioError
        There are none.
    """
    classes = tuple(part.strip() for part in text.split(",") if part.strip())
    if not classes:
        raise ScenarioError("--classes: empty; give highway values such as motorway,motorway_link")
    return classes


def rules_named(text: str) -> str:
    """Look driving rules up.

    Parameters
    ----------
    text : str
        What was typed.

    Returns
    -------
    str
        A name of `RULES`, to which other packages may have added some.

    Raises
    ------
    ScenarioError
        There are none of that name.
    """
    return _name_in(RULES, text, "--rules")


def objective_named(text: str) -> str:
    """Look an objective up.

    Parameters
    ----------
    text : str
        What was typed.

    Returns
    -------
    str
        A name of `PRESETS`, to which other packages may have added some.

    Raises
    ------
    ScenarioError
        There is none of that name.
    """
    return _name_in(PRESETS, text, "--objective")


def _name_in(known: Registry[Item], text: str, option: str) -> str:
    try:
        return known.find(text).name
    except ScenarioError as error:
        raise ScenarioError(f"{option}: {error}") from None


def output_option(
    help: str, suffixes: Sequence[str], *, is_text: bool = False
) -> Callable[[Run], Run]:
    """Return the option -o of a verb that writes one file.

    Parameters
    ----------
    help : str
        What is written.
    suffixes : sequence of str
        Those it has.
    is_text : bool
        Whether it may go to standard output.

    Returns
    -------
    callable
        Adds the option to a verb, which takes it as `output`.
    """
    kind = output_kind("-o", suffixes, is_text=is_text)
    return click.option("-o", "--output", type=kind, metavar="FILE", required=True, help=help)


classes_option = click.option(
    "--classes",
    type=classes_of,
    default="motorway,motorway_link",
    metavar="TEXT",
    help="Highway values to load, with commas.",
)
_country = click.option("--country", help="Whose truck speed limit applies: IT, de, US-CA, ...")
_limiter = click.option(
    *LIMITER,
    type=float,
    help="Speed limiter of the trucks [km/h]; without it, that of the country: 90 in Europe.",
)
_infer_links = click.option(
    "--infer-links",
    is_flag=True,
    help="Add likely connectors where the map lacks ramps; they are marked inferred.",
)


def was_given(ctx: click.Context, name: str) -> bool:
    """Return whether somebody typed an option, be it with its default value.

    Parameters
    ----------
    ctx : click.Context
        Of the verb.
    name : str
        What the verb takes it by.

    Returns
    -------
    bool
        False where the default stands.
    """
    return ctx.get_parameter_source(name) is not ParameterSource.DEFAULT


def truck_options(verb: Run) -> Run:
    """Add the options of `TruckRules` to a verb, which takes them by the names they have there.

    Parameters
    ----------
    verb : callable
        What the verb does.

    Returns
    -------
    callable
        The same, with the options.
    """
    return _country(_limiter(verb))


def network_options(verb: Run) -> Run:
    """Add the options of `load_network` to a verb, which takes them by the names they have there.

    Parameters
    ----------
    verb : callable
        What the verb does.

    Returns
    -------
    callable
        The same, with the options.
    """
    return classes_option(truck_options(_infer_links(verb)))


class SectionOption(click.Option):
    """An option of a `Sections` verb that stands under a heading of its own.

    Parameters
    ----------
    names : sequence of str
        What it is called, as for `click.Option`.
    section : str
        The heading.
    **more : Any
        Its type, default and help, as for `click.Option`.
    """

    def __init__(self, names: Sequence[str], section: str, **more: Any) -> None:
        super().__init__(names, **more)
        self.section = section


class Sections(click.Command):
    """A verb whose help shows options in sections."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options, those of one section together.

        Parameters
        ----------
        ctx : click.Context
            Of this verb.
        formatter : click.HelpFormatter
            Takes the text.
        """
        sections: dict[str, list[tuple[str, str]]] = {}
        for parameter in self.get_params(ctx):
            if isinstance(parameter, click.Option) and (row := parameter.get_help_record(ctx)):
                sections.setdefault(getattr(parameter, "section", "Options"), []).append(row)
        for title, rows in sections.items():
            with formatter.section(title):
                formatter.write_dl(rows)
