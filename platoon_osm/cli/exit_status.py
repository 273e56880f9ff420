"""How a command ends: with 0, or with 2 and one line that says what is wrong."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click

from ..errors import PlatoonError

__all__ = ["NAME", "status_of", "tell"]

NAME = "platoon-osm"


def status_of(run: Callable[[], None]) -> int:
    """Run something and return the status to end with; say in one line why it failed.

    Parameters
    ----------
    run : callable
        What the command does.

    Returns
    -------
    int
        0, or 2 when the input is wrong or somebody interrupted it.
    """
    try:
        with _ended_as_interrupted():
            run()
            sys.stdout.flush()
    except click.exceptions.Exit as asked:  # after --help and --version
        return asked.exit_code
    except click.UsageError as error:
        return _refuse(_usage(error), error.ctx.command_path if error.ctx else NAME)
    except click.ClickException as error:
        return _refuse(error.format_message())
    except PlatoonError as error:
        return _refuse(str(error))
    except BrokenPipeError:
        # The reader of a pipe, such as head, has seen enough; the rest goes nowhere, in silence.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return _refuse(f"{where}{error.strerror or error}; check the path and its rights")
    except (KeyboardInterrupt, click.Abort):
        return _refuse("interrupted; nothing was left half written")
    return 0


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


@contextmanager
def _ended_as_interrupted() -> Iterator[None]:
    """Treat a request to end, as `timeout` and schedulers send it, like Ctrl-C: clean up first."""
    if threading.current_thread() is not threading.main_thread():
        yield  # only there may a handler be set
        return
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
