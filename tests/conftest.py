"""How the property tests draw their examples, and which files run first.

`make test` draws the same ones each time, so that a change is judged by what it changed.
`make soak` draws new ones, round after round, and prints how to repeat a failure.
"""

import os
import signal

import pytest
from forked_command import Mother
from hypothesis import settings
from inspected_plans import inspect_every_plan
from places import ROOT

LONG = (
    "test_cli_interrupts.py", "test_cli_no_room.py", "test_examples.py", "test_docs.py",
    "test_italy_map.py", "test_report_boxes.py", "test_figure_layout.py", "test_report_firefox.py",
    "test_report_security.py", "test_report_many.py", "test_report_groups.py",
    "test_report_schedule.py", "test_report_page.py", "test_report_theme.py", "test_command.py",
)  # fmt: skip
"""Files of few and long tests, or of very many: begun last, one of them would keep all but one
processor idle."""

settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("soak", print_blob=True, deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "same"))


def pytest_sessionstart():
    """Have every plan checked that a test makes, whatever it is made for."""
    inspect_every_plan()
    # Shells start what runs behind them with interrupts ignored, and children would inherit that.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items):
    """Begin with what takes long; the rest stays as it is."""
    items.sort(key=lambda item: item.path.name not in LONG)


@pytest.fixture(scope="session")
def forks():
    """What runs the command in processes of its own that need not start from nothing."""
    if not hasattr(os, "fork"):
        pytest.skip("processes fork on POSIX only")
    mother = Mother(ROOT)
    yield mother
    mother.end()
