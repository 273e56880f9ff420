"""The table of towns: a file of compressed columns, read when a name is first looked for in it.

Made by `maps/build_towns.py` from GeoNames; `maps/README.md` says what of it is kept.
"""

from __future__ import annotations

import json
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...atomic_file import whole_file
from ...errors import NetworkError

__all__ = ["FILE", "TownTable", "bundled_towns"]

FILE = Path(__file__).parent / "towns.npz"
"""The table that comes with the package."""

STEPS = 10_000
"""Steps to a degree in which the file keeps positions: 11 m or less."""

TOWNS, NAMES = "\n", "\t"
"""What stands between the towns, and between the names of one, in the file's texts."""

NUMBERS = {"lon": "i4", "lat": "i4", "population": "u4", "country": "u1", "region": "u1"}
TEXTS = ("names", "further", "about")


class TownTable:
    """Towns in the order of their latitudes, t of them; the arrays are read-only.

    Parameters
    ----------
    columns : mapping of str to ndarray
        As the file has them: numbers, and texts as bytes in UTF-8.

    Attributes
    ----------
    lon, lat : ndarray of float, (t,)
        Degrees.
    population : ndarray of int, (t,)
        Inhabitants.
    country, region : ndarray of int, (t,)
        Position in `countries`, and in `regions`; region 0 is none.
    about : dict
        Where the table is from; with `countries`, a list of ISO codes of two and of three letters
        and a name, and `regions`, a list of code and name.
    """

    def __init__(self, columns: Mapping[str, NDArray[Any]]) -> None:
        self._columns = {name: columns[name] for name in (*NUMBERS, *TEXTS)}
        self.lon, self.lat = (self._columns[name] / STEPS for name in ("lon", "lat"))
        self.population, self.country, self.region = (
            self._columns[name] for name in ("population", "country", "region")
        )
        for values in (*self._columns.values(), self.lon, self.lat):
            values.flags.writeable = False
        self.about: dict[str, Any] = json.loads(self._text("about"))

    @classmethod
    def of(
        cls,
        *,
        lon: Sequence[float],
        lat: Sequence[float],
        population: Sequence[int],
        country: Sequence[int],
        region: Sequence[int],
        names: Sequence[str],
        further: Sequence[Sequence[str]],
        countries: Sequence[tuple[str, str, str]],
        regions: Sequence[tuple[str, str]],
        about: Mapping[str, str],
    ) -> TownTable:
        """Make a table of towns that are sorted by latitude.

        Parameters
        ----------
        lon, lat : sequence of float, (t,)
            Degrees.
        population : sequence of int, (t,)
            Inhabitants.
        country, region : sequence of int, (t,)
            Positions in `countries` and `regions`.
        names : sequence of str, (t,)
            What each is called first.
        further : sequence of sequence of str, (t, ...)
            What else each is called, as `fold` spells it.
        countries : sequence of (str, str, str)
            ISO codes of two and of three letters, and name.
        regions : sequence of (str, str)
            Code and name; the first is none.
        about : mapping of str to str
            Where the towns are from.

        Returns
        -------
        TownTable
            Of these.
        """
        numbers = {
            "lon": np.rint(np.multiply(lon, STEPS)), "lat": np.rint(np.multiply(lat, STEPS)),
            "population": population, "country": country, "region": region,
        }  # fmt: skip
        texts = {
            "names": TOWNS.join(names),
            "further": TOWNS.join(NAMES.join(row) for row in further),
            "about": json.dumps(
                {**about, "countries": countries, "regions": regions}, ensure_ascii=False
            ),
        }
        return cls(
            {name: np.asarray(values, NUMBERS[name]) for name, values in numbers.items()}
            | {name: np.frombuffer(text.encode(), np.uint8) for name, text in texts.items()}
        )

    @classmethod
    def read(cls, path: Path) -> TownTable:
        """Read a table.

        Parameters
        ----------
        path : Path
            A file that `write` wrote.

        Returns
        -------
        TownTable
            The table.

        Raises
        ------
        NetworkError
            The file is not there, or damaged.
        """
        try:
            with path.open("rb") as file, np.load(file, allow_pickle=False) as columns:
                table = cls(columns)
            sizes = {len(table._columns[name]) for name in NUMBERS}
            if sizes != {len(table.names())} or sizes != {len(table.further_names())}:
                raise ValueError
            if (np.diff(table.lat) < 0).any():
                raise ValueError
            table.country_name(int(table.country.max())), table.region_name(int(table.region.max()))
        except (OSError, ValueError, KeyError, IndexError, EOFError, TypeError, zlib.error,
                zipfile.BadZipFile) as error:  # fmt: skip
            raise NetworkError(
                f"{path.name}: the table of towns cannot be read; install platoon_osm again"
            ) from error
        return table

    def write(self, path: Path) -> None:
        """Write the table.

        Parameters
        ----------
        path : Path
            The file.
        """
        with whole_file(path) as draft:
            np.savez_compressed(draft, allow_pickle=False, **self._columns)

    def _text(self, name: str) -> str:
        text: str = self._columns[name].tobytes().decode()
        return text

    @cached_property
    def _names(self) -> list[str]:
        return self._text("names").split(TOWNS)

    @cached_property
    def _further(self) -> list[list[str]]:
        return [line.split(NAMES) if line else [] for line in self._text("further").split(TOWNS)]

    def names(self) -> list[str]:
        """Return what each town is called first.

        Returns
        -------
        list of str, (t,)
            Names.
        """
        return self._names

    def further_names(self) -> list[list[str]]:
        """Return what else each town is called.

        Returns
        -------
        list of list of str, (t, ...)
            As `fold` spells them.
        """
        return self._further

    def country_name(self, country: int) -> str:
        """Return the English name of a country.

        Parameters
        ----------
        country : int
            Position in the list.

        Returns
        -------
        str
            Its name.
        """
        name: str = self.about["countries"][country][2]
        return name

    def region_name(self, region: int) -> str:
        """Return the name of a region, which only states of the USA have here.

        Parameters
        ----------
        region : int
            Position in the list.

        Returns
        -------
        str
            Its name; empty for none.
        """
        name: str = self.about["regions"][region][1]
        return name

    def lies_in(self, town: int) -> set[str]:
        """Return what the country and region of a town are called.

        Parameters
        ----------
        town : int
            Position in the table.

        Returns
        -------
        set of str
            Codes and names.
        """
        own = (
            self.about["countries"][self.country[town]],
            self.about["regions"][self.region[town]],
        )
        return {text for row in own for text in row} - {""}


@cache
def bundled_towns() -> TownTable:
    """Return the table that comes with the package, read once.

    Returns
    -------
    TownTable
        The table.

    Raises
    ------
    NetworkError
        The file is not there, or damaged.
    """
    return TownTable.read(FILE)
