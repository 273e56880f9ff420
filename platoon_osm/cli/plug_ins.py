"""What packages of your own add: verbs, and modules that add to the lists of this package.

Both are entry points, which a package names in its own pyproject.toml:

    [project.entry-points."platoon_osm.verbs"]
    depots = "our_package.depots:verb"       # a click.Command: platoon-osm depots

    [project.entry-points."platoon_osm.extensions"]
    ours = "our_package.formats"             # a module, imported before any verb is

Importing the module is all that is done with it, so it adds when it is imported: an exporter, and
`platoon-osm plan` has an option of its name; a reader, and every verb opens such files; a fuel
table, and scenarios may name it.

    from platoon_osm.costs.fuel import FUEL_SAVINGS, FuelSaving
    FUEL_SAVINGS.add(FuelSaving("ours", 0.02, 0.06, 0.06, "measured by ourselves"))

    from platoon_osm.report.exporters import EXPORTERS, Exporter
    EXPORTERS.add(Exporter("kml", "routes for a globe to write", ".kml", write_kml))

    from platoon_osm.sources.readers import READERS, Reader
    READERS.add(Reader("links", (".links",), "list of links, one a line", read_links))

Such a module should import what is heavy only where it is used: it is loaded for `--help` too.
What cannot be loaded is told in one line, and the rest works on.
"""

from __future__ import annotations

from functools import cache
from importlib.metadata import EntryPoint, entry_points

import click

from ..errors import PlatoonError
from .exit_status import tell

__all__ = ["added_verbs", "load_extensions", "load_verb"]


def added_verbs() -> dict[str, EntryPoint]:
    """Find the verbs that other packages add, without loading any.

    Returns
    -------
    dict of str to EntryPoint
        By name, in the order of the alphabet.
    """
    found = sorted(entry_points(group="platoon_osm.verbs"), key=lambda entry: entry.name)
    return {entry.name: entry for entry in found}


def load_verb(entry: EntryPoint) -> click.Command:
    """Load a verb that another package adds.

    Parameters
    ----------
    entry : EntryPoint
        One of `added_verbs`.

    Returns
    -------
    click.Command
        The verb.

    Raises
    ------
    PlatoonError
        It cannot be loaded, or is no click command.
    """
    try:
        verb = entry.load()
    except Exception as error:  # whatever is wrong with somebody else's code
        raise PlatoonError(_broken("verb", entry, error)) from error
    if not isinstance(verb, click.Command):
        raise PlatoonError(_broken("verb", entry, TypeError(f"{entry.value} is no click.Command")))
    return verb


@cache
def load_extensions() -> None:
    """Import, once, every module that other packages name as an extension; tell of broken ones."""
    for entry in entry_points(group="platoon_osm.extensions"):
        try:
            entry.load()
        except Exception as error:  # as above; the others are still wanted
            tell(_broken("extension", entry, error))


def _broken(kind: str, entry: EntryPoint, error: Exception) -> str:
    package = entry.dist.name if entry.dist else entry.module
    return (
        f"{kind} {entry.name!r} of {package} cannot be loaded "
        f"({type(error).__name__}: {error}); mend or uninstall {package}"
    )
