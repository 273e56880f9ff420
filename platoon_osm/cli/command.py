"""The command itself: it finds a verb, hands it its options, and ends with a status."""

from __future__ import annotations

import difflib
import logging
import sys
from collections.abc import Sequence
from importlib import import_module
from io import TextIOWrapper
from typing import Any

import click

from .._version import __version__
from .exit_status import NAME, status_of
from .plug_ins import added_verbs, load_extensions, load_verb
from .verbs import VERBS

__all__ = ["main"]

EPILOG = """\b
Examples:
  platoon-osm demo -o out                     plan a corridor in Italy and draw it
  platoon-osm download "Oberfranken, Germany" -o oberfranken.graphml
  platoon-osm prepare germany.osm.pbf --country DE -o germany.platoon
  platoon-osm plan corridor.toml --html plan.html --gpkg plan.gpkg
  platoon-osm compare corridor.toml --cases A,B,C -o compare.html
  platoon-osm what-if corridor.toml --objective eu --price 1.4:2.2:0.1
  platoon-osm study --runs 100 --seed 0 -o out/study
"""


class _Verbs(click.Group):
    """Our verbs and those that other packages add, each loaded when it is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 (click's)
        return [*VERBS, *(name for name in added_verbs() if name not in VERBS)]

    def get_command(
        self,
        ctx: click.Context,  # noqa: ARG002 (click's)
        cmd_name: str,
    ) -> click.Command | None:
        if cmd_name in VERBS:
            load_extensions()  # a verb's options may be made from lists that they add to
            verb: click.Command = import_module(
                f".verbs.{cmd_name.replace('-', '_')}", __package__
            ).verb
            return verb
        added = added_verbs().get(cmd_name)
        return load_verb(added) if added else None

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        known = self.list_commands(ctx)
        if args[0] not in known:
            near = difflib.get_close_matches(args[0], known, 1, 0.5)
            hint = f"did you mean {near[0]!r}? " if near else ""
            ctx.fail(f"VERB: invalid choice {args[0]!r}; {hint}use one of {', '.join(known)}")
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except click.UsageError as error:
            # Not every error of the parser knows whose options it read.
            if error.ctx is None and ctx.invoked_subcommand:
                error.ctx = click.Context(self, info_name=f"{NAME} {ctx.invoked_subcommand}")
            raise

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        rows = [(name, self._about(ctx, name)) for name in self.list_commands(ctx)]
        with formatter.section("Verbs"):
            formatter.write_dl(rows)

    def _about(self, ctx: click.Context, name: str) -> str:
        # What others add may be heavy or broken, so it is not loaded for a list.
        if name not in VERBS:
            entry = added_verbs()[name]
            return f"added by {entry.dist.name}" if entry.dist else f"added by {entry.module}"
        verb = self.get_command(ctx, name)
        return verb.get_short_help_str(limit=80) if verb else ""


@click.command(
    cls=_Verbs,
    invoke_without_command=True,
    subcommand_metavar="VERB ...",
    context_settings={"help_option_names": ["-h", "--help"], "show_default": True},
    epilog=EPILOG,
)
@click.version_option(__version__, message=f"{NAME} %(version)s")
@click.pass_context
def _command(ctx: click.Context) -> None:
    """Plan joint routes for truck platoons on OpenStreetMap motorway networks."""
    if ctx.invoked_subcommand is None:
        ctx.fail("a VERB is required, such as demo or plan")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command.

    Parameters
    ----------
    arguments : sequence of str, optional
        What stands behind the command's name; by default, what was typed.

    Returns
    -------
    int
        The exit status: 0, or 2 when the input is wrong.
    """
    logging.basicConfig(format="%(levelname)s %(name)s: %(message)s", level=logging.WARNING)
    _print_what_can_be_printed()
    given = list(sys.argv[1:] if arguments is None else arguments)

    def run() -> None:
        with _command.make_context(NAME, given) as context:
            _command.invoke(context)

    return status_of(run)


def _print_what_can_be_printed() -> None:
    """Let a question mark stand for what standard output has no bytes for.

    Whoever asked for something else by PYTHONIOENCODING has it.
    """
    if isinstance(sys.stdout, TextIOWrapper) and sys.stdout.errors in ("strict", "surrogateescape"):
        sys.stdout.reconfigure(errors="replace")
