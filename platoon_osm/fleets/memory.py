"""The most memory that this process has held."""

from __future__ import annotations

import sys
from typing import Any

__all__ = ["peak_mb"]


def peak_mb() -> float:
    """Return the most memory this process has held.

    Returns
    -------
    float
        Megabytes [MB]; 0 where the system does not tell.
    """
    try:
        import resource
    except ImportError:  # not on Windows
        return 0.0
    peak: Any = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(peak) / (1e6 if sys.platform == "darwin" else 1e3)
