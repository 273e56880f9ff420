"""Records that are told in rows: as a table of pandas, and as a CSV file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from ..csv_tables import write_table
from ..errors import ScenarioError

if TYPE_CHECKING:
    import pandas

__all__ = ["Row", "RowTable"]

Row = dict[str, Any]

DIGITS = 9
"""Of numbers in the tables."""


class RowTable:
    """What has rows."""

    __slots__ = ()

    def rows(self) -> Iterator[Row]:
        """Yield the rows, all with the same columns.

        Yields
        ------
        dict
            Values by the names of columns.
        """
        raise NotImplementedError

    def to_frame(self) -> pandas.DataFrame:
        """Return the rows as a table of pandas.

        Returns
        -------
        pandas.DataFrame
            In the order of `rows`.
        """
        import pandas as pd

        return pd.DataFrame(list(self.rows()))

    def write_csv(self, path: str | os.PathLike[str]) -> None:
        """Write the rows as CSV.

        Parameters
        ----------
        path : path-like
            Of the file.

        Raises
        ------
        ScenarioError
            There are none, or the file cannot be written.
        """
        rows = list(self.rows())
        if not rows:
            raise ScenarioError("curve: it has no steps to write; ask for some")
        write_table(path, list(rows[0]), (list(row.values()) for row in rows), DIGITS)
