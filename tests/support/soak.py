"""`make soak` tries every case there is; `make test` a selection that stands for them.

Tests that have more cases in `make soak` are marked with `soaked`, which is how it finds them.
"""

from __future__ import annotations

import os
from typing import TypeVar

import pytest

Cases = TypeVar("Cases")

SOAK = os.environ.get("HYPOTHESIS_PROFILE") == "soak"

soaked = pytest.mark.soak


def chosen(usual: Cases, every: Cases) -> Cases:
    """Return the cases to try: those for every day, or all of them."""
    return every if SOAK else usual
