"""A sheet of a workbook, with dates as spreadsheets keep them: days since an epoch."""

from __future__ import annotations

import io
import warnings
import zipfile
from collections.abc import Iterator
from datetime import datetime, timedelta
from itertools import zip_longest
from pathlib import Path
from typing import Any

from ...errors import ScenarioError, brief
from ...plans.trip import TIMES
from .cells import column_named, is_blank
from .rows import Row, rows_under
from .text_file import MOST_BYTES, beginning_of

__all__ = ["read_xlsx"]

MOST_UNPACKED_BYTES = 1 << 30
"""What the parts of a workbook may measure: a small archive can unpack to more than memory."""

FIRST_DAY, LAST_DAY = 1, 2_500_000
"""Numbers of days that fall into the calendar, up to the year 8744."""


def read_xlsx(file: Path, sheet: str | None, content: bytes | None) -> list[Row]:
    """Read a sheet of a workbook.

    Parameters
    ----------
    file : Path
        The workbook.
    sheet : str or None
        Name of the sheet; by default the first.
    content : bytes or None
        What it holds, if that was read before.

    Returns
    -------
    list of Row
        Its rows; moments are such, rounded to the second.

    Raises
    ------
    ScenarioError
        No workbook, no such sheet, an error or a formula without its value; or openpyxl, which
        reads workbooks, is not installed.
    """
    try:
        import openpyxl
    except ImportError:
        raise ScenarioError(
            f"{file}: workbooks are read with openpyxl; install it (pip install openpyxl), or save "
            "the sheet as CSV UTF-8"
        ) from None
    # Else openpyxl would go by the name.
    data = beginning_of(file, MOST_BYTES) if content is None else content
    _check_size(file, data)
    with warnings.catch_warnings():
        # Of parts of workbooks that it does not know, none of which is a cell.
        warnings.simplefilter("ignore")
        try:
            values, formulas = (
                openpyxl.load_workbook(io.BytesIO(data), read_only=True, data_only=data_only)
                for data_only in (True, False)
            )
            try:
                return _rows(file, values, formulas, sheet)
            finally:
                values.close()
                formulas.close()
        except ScenarioError:
            raise
        except Exception as error:  # openpyxl raises whatever its parts do on damaged files
            raise ScenarioError(
                f"{file}: not a workbook that can be read ({brief(str(error) or error)}); save it "
                "again as .xlsx, or as CSV UTF-8"
            ) from error


def _check_size(file: Path, data: bytes) -> None:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            size = sum(part.file_size for part in archive.infolist())
            names = set(archive.namelist())
    except Exception as error:  # zipfile raises half a dozen kinds on damaged files
        raise ScenarioError(
            f"{file}: not a workbook, or damaged ({brief(str(error))}); save it again as .xlsx"
        ) from error
    if "[Content_Types].xml" not in names:
        raise ScenarioError(f"{file}: is a zip archive, no workbook; give the table itself")
    if size > MOST_UNPACKED_BYTES:
        raise ScenarioError(f"{file}: unpacks to {size / 2**30:.1f} GB; split it")


def _rows(file: Path, values: Any, formulas: Any, sheet: str | None) -> list[Row]:
    names = [item.title for item in values.worksheets]
    if not names:
        raise ScenarioError(f"{file}: has no sheet of cells; add one")
    name = names[0] if sheet is None else sheet
    if name not in names:
        raise ScenarioError(f"{file}: has no sheet {brief(sheet)}; sheets are {', '.join(names)}")
    lines = _lines(file, values[name], formulas[name])
    first = next((line for line in lines if not all(is_blank(cell) for cell in line[1])), None)
    if first is None:
        others = ", ".join(other for other in names if other != name)
        more = f"; name another sheet: {others}" if others else ""
        raise ScenarioError(f"{file}: sheet {brief(name)} has no rows under its header{more}")
    where, header = first
    moments = [column_named(title) in TIMES for title in header]
    rest = (
        (
            row,
            [
                _moment(row, cell, values.epoch) if at else cell
                for cell, at in _with(cells, moments)
            ],
        )
        for row, cells in lines
    )
    return rows_under(header, rest, where)


def _with(cells: list[Any], moments: list[bool]) -> Iterator[tuple[Any, bool]]:
    return zip_longest(cells, moments[: len(cells)], fillvalue=False)


def _lines(file: Path, values: Any, formulas: Any) -> Iterator[tuple[str, list[Any]]]:
    """Yield rows with what their cells hold; dates as such, without the time if none is shown."""
    from openpyxl.utils.cell import get_column_letter

    for sheet in (values, formulas):
        sheet.reset_dimensions()  # some programs write them wrongly
    pairs = zip(values.iter_rows(), formulas.iter_rows(), strict=False)
    for number, (cells, written) in enumerate(pairs, 1):
        yield (
            f"{file.name} row {number}",
            [
                _read(f"{file.name} cell {get_column_letter(k)}{number}", cell, formula)
                for k, (cell, formula) in enumerate(zip_longest(cells, written), 1)
                if cell is not None
            ],
        )


def _read(place: str, cell: Any, formula: Any) -> Any:
    """Return what a cell holds; an error if it cannot be read."""
    if cell.value is None and formula is not None and formula.value is not None:
        return ScenarioError(
            f"{place}: is a formula without its value; open the workbook in a spreadsheet "
            "program and save it, or write the value"
        )
    if getattr(cell, "data_type", "") == "e":
        return ScenarioError(f"{place}: is the error {cell.value}; correct its formula")
    return _plain(cell)


def _plain(cell: Any) -> Any:
    from openpyxl.styles.numbers import is_datetime

    value = cell.value
    if isinstance(value, datetime):
        value = _rounded(value)
        # A day alone would be read as its midnight.
        if is_datetime(cell.number_format) == "date" and value.time() == datetime.min.time():
            return value.date()
    return value


def _moment(where: str, cell: Any, epoch: datetime) -> Any:
    """Return a number in a column of times as the moment that it is; an error if it is none."""
    if isinstance(cell, bool) or not isinstance(cell, int | float):
        return cell
    from openpyxl.utils.datetime import from_excel

    if not FIRST_DAY <= cell <= LAST_DAY:
        return ScenarioError(f"{where}: {cell} is no day of a spreadsheet; write 2026-03-02 06:00")
    moment = from_excel(cell, epoch)
    return _rounded(moment) if isinstance(moment, datetime) else cell


def _rounded(moment: datetime) -> datetime:
    """Return a moment to the second: a day's share in binary is never quite 06:10."""
    return (moment + timedelta(microseconds=500_000)).replace(microsecond=0)
