"""What a certificate is refused for."""

from __future__ import annotations

from ...errors import PlatoonError

__all__ = ["FaultError"]


class FaultError(PlatoonError):
    """Something that a certificate says is not so."""
