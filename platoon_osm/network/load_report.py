"""What a loader kept, dropped, capped and defaulted, so that nothing is guessed in silence."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

__all__ = ["LoadReport", "Source"]


@dataclass(frozen=True, slots=True)
class Source:
    """Where a network came from.

    Attributes
    ----------
    name : str
        File name, or what made the network.
    sha256 : str
        Hex digest of the file's bytes; empty for a network made in memory.
    extracted : str
        When the data was cut from the map, ISO 8601, as the file says; else empty.
    licence, attribution : str
        To be shown with everything made from the data.
    """

    name: str = "in memory"
    sha256: str = ""
    extracted: str = ""
    licence: str = ""
    attribution: str = ""

    def to_dict(self) -> dict[str, str]:
        """Plain JSON form."""
        return {name: getattr(self, name) for name in self.__slots__}


@dataclass(frozen=True, slots=True)
class LoadReport:
    """Counts of a load, in the order they were made, and remarks for the user.

    Attributes
    ----------
    counts : mapping of str to int
        Name of a count -> number.
    remarks : tuple of str
        One sentence each; what a user should know before trusting the network.
    """

    counts: Mapping[str, int] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> int:
        return self.counts.get(name, 0)

    # Without these Python would ask for report[0], report[1] and so on, and never come to an end.

    def __contains__(self, name: object) -> bool:
        return name in self.counts

    def __iter__(self) -> Iterator[str]:
        return iter(self.counts)

    def __str__(self) -> str:
        width = max((len(f"{number:,}") for number in self.counts.values()), default=1)
        lines = [f"{number:>{width},}  {name}" for name, number in self.counts.items()]
        return "\n".join([*lines, *(f"note: {remark}" for remark in self.remarks)])

    def extended(self, counts: Mapping[str, int], *remarks: str) -> LoadReport:
        """Return a report with more counts (same names add up) and remarks.

        Parameters
        ----------
        counts : mapping of str to int
            Numbers by name.
        *remarks : str
            Sentences for the user.

        Returns
        -------
        LoadReport
            Another report.
        """
        merged = dict(self.counts)
        for name, number in counts.items():
            merged[name] = merged.get(name, 0) + int(number)
        return LoadReport(merged, self.remarks + remarks)

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON form."""
        return {"counts": dict(self.counts), "remarks": list(self.remarks)}
