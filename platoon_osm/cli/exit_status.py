"""How a command ends: with 0; with 1 if there is no plan as asked; with 2 if the input is wrong.

Whatever went wrong is said in one line. There is no plan as asked where a trip has no route, must
be late even alone, or cannot be driven within the rules asked for; where there is a route, what was
planned is written all the same.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

import click

from ..errors import NoRouteError, PlatoonError
from ..interrupts import ended_by_signals
from ..leftovers import remove_all

if TYPE_CHECKING:
    from ..plans.plan import Plan

__all__ = ["NAME", "UNMET", "end_if_unmet", "status_of", "tell"]

NAME = "platoon-osm"

UNMET = 1
"""Status where the question is right, and what it asks for cannot be."""


def status_of(run: Callable[[], None]) -> int:
    """Run something and return the status to end with; say in one line why it failed.

    Parameters
    ----------
    run : callable
        What the command does.

    Returns
    -------
    int
        0; 1 when a trip has no route, must be late or cannot be within the law; 2 when the input
        is wrong or somebody interrupted it.
    """
    try:
        with ended_by_signals():
            run()
            sys.stdout.flush()
    except click.exceptions.Exit as asked:  # after --help and --version
        return asked.exit_code
    except click.UsageError as error:
        return _refuse(_usage(error), error.ctx.command_path if error.ctx else NAME)
    except click.ClickException as error:
        return _refuse(error.format_message())
    except NoRouteError as error:
        tell(str(error))
        return UNMET
    except PlatoonError as error:
        return _refuse(str(error))
    except BrokenPipeError:
        # The reader of a pipe, such as head, has seen enough; the rest goes nowhere, in silence.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return _refuse(f"{where}{error.strerror or error}; check the path and its rights")
    except (KeyboardInterrupt, click.Abort) as interrupt:
        return _refuse(f"interrupted; {_kept(interrupt)}")
    finally:
        remove_all()
    return 0


def end_if_unmet(plans: Iterable[Plan]) -> None:
    """Say who is late or not within the law and end with `UNMET`, once all is written.

    Parameters
    ----------
    plans : iterable of Plan
        What was planned.

    Raises
    ------
    Exit
        Somebody must be late, or cannot keep to the driving rules.
    """
    from ..plans.lateness import NOT_FEASIBLE

    unmet = [remark for plan in plans for remark in plan.remarks if remark.startswith(NOT_FEASIBLE)]
    for remark in dict.fromkeys(unmet):
        tell(remark)
    if unmet:
        raise click.exceptions.Exit(UNMET)


def tell(message: str, who: str = NAME) -> None:
    """Write one line to standard error.

    Parameters
    ----------
    message : str
        What to say; characters that do not print become blanks.
    who : str
        Whose message it is.
    """
    # Names from maps reach messages; control characters in them must not reach the terminal.
    line = "".join(c if c.isprintable() else " " for c in f"{who}: {message}")
    sys.stderr.write(line + "\n")


def _refuse(message: str, who: str = NAME) -> int:
    tell(message, who)
    return 2


def _kept(interrupt: BaseException) -> str:
    """Return what an interrupt leaves, as whoever was interrupted says it."""
    return str(interrupt) or "nothing was left half written"


def _usage(error: click.UsageError) -> str:
    """Say what is wrong with what was typed, and where help is."""
    where = error.ctx.command_path if error.ctx else NAME
    if isinstance(error, click.NoSuchOption):
        said = f"unrecognized option {error.option_name}"
        near = sorted(error.possibilities or ())
        said += f"; did you mean {' or '.join(near)}?" if near else ""
    elif isinstance(error, click.MissingParameter) and error.param is not None:
        said = f"{error.param.get_error_hint(error.ctx)} is required"
    else:
        text = error.format_message()
        said = text[:1].lower() + text[1:].rstrip(".") if text[1:2].islower() else text
    return f"{said}; see {where} --help"
