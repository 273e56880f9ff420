"""Names kept once, as UTF-8 bytes with offsets: a saved network opens without reading them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import SupportsIndex, overload

import numpy as np
from numpy.typing import NDArray

from ..shown_text import well_formed

__all__ = ["TextTable", "encode_texts"]


class TextTable(Sequence[str]):
    """An immutable list of strings; entry 0 is always the empty string.

    Parameters
    ----------
    offsets : (k + 1,) int64
        Where each string starts in `blob`.
    blob : (bytes,) uint8
        All strings in UTF-8, end to end.
    """

    __slots__ = ("blob", "offsets")

    def __init__(self, offsets: NDArray[np.int64], blob: NDArray[np.uint8]) -> None:
        self.offsets = offsets
        self.blob = blob
        offsets.flags.writeable = blob.flags.writeable = False

    def __reduce__(self) -> tuple[type[TextTable], tuple[NDArray[np.int64], NDArray[np.uint8]]]:
        # Made anew, so that the arrays come back read-only.
        return TextTable, (self.offsets, self.blob)

    @classmethod
    def from_strings(cls, strings: Iterable[str]) -> TextTable:
        """Build a table from strings, in their order.

        Parameters
        ----------
        strings : iterable of str
            Texts in their order; the first must be empty.

        Returns
        -------
        TextTable
            With a code for each, its position.
        """
        encoded = [_utf8(text) for text in strings]
        offsets = np.zeros(len(encoded) + 1, np.int64)
        np.cumsum([len(part) for part in encoded], out=offsets[1:])
        return cls(offsets, np.frombuffer(b"".join(encoded), np.uint8))

    def __len__(self) -> int:
        return len(self.offsets) - 1

    @overload
    def __getitem__(self, code: SupportsIndex) -> str: ...

    @overload
    def __getitem__(self, code: slice) -> list[str]: ...

    def __getitem__(self, code: SupportsIndex | slice) -> str | list[str]:
        if isinstance(code, slice):
            return [self[i] for i in range(*code.indices(len(self)))]
        code = code.__index__()
        if not -len(self) <= code < len(self):
            raise IndexError(code)
        code %= len(self)
        start, stop = self.offsets[code], self.offsets[code + 1]
        text: str = self.blob[start:stop].tobytes().decode("utf-8", "replace")
        return text

    def __iter__(self) -> Iterator[str]:
        return (self[code] for code in range(len(self)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TextTable):
            return NotImplemented
        same = np.array_equal(self.blob, other.blob) and np.array_equal(self.offsets, other.offsets)
        return same or list(self) == list(other)

    def __hash__(self) -> int:
        return hash(self.blob.tobytes())


def _utf8(text: str) -> bytes:
    try:
        return text.encode()
    except UnicodeEncodeError:  # half a character (broken input) must not stop a load
        return well_formed(text).encode()


def encode_texts(*columns: Sequence[str]) -> tuple[TextTable, list[NDArray[np.int32]]]:
    """Give each distinct string one code, shared by all columns; the empty string is code 0.

    Parameters
    ----------
    *columns : sequence of str
        Lists of texts.

    Returns
    -------
    tuple[TextTable, list[NDArray[np.int32]]]
        The table, and the codes of each column.
    """
    codes: dict[str, int] = {"": 0}
    encoded = [
        np.fromiter((codes.setdefault(text, len(codes)) for text in column), np.int32, len(column))
        for column in columns
    ]
    return TextTable.from_strings(codes), encoded
