"""What rules of sharing a gain are called."""

from __future__ import annotations

from typing import Literal

__all__ = ["SharingRule"]

SharingRule = Literal["equal", "shapley", "least-core"]
"""Equal parts of the leader's loss, the Shapley value, or the least core."""
