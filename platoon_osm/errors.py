"""The errors that users meet; each message names what, where and the remedy in one line."""


class PlatoonError(Exception):
    """Anything this package refuses to do, said in one line for the person who asked."""

    def __str__(self) -> str:
        # Names of files and places come from outside and may hold anything.
        return " ".join(super().__str__().splitlines())


class MapDataError(PlatoonError):
    """A map file, cache or saved network cannot be read or holds no usable road."""


class NetworkError(PlatoonError):
    """A network, or a place in it, does not fit what was asked of it."""


class NoRouteError(PlatoonError):
    """No drivable route exists between two places of the network."""


class ScenarioError(PlatoonError):
    """A scenario, trip or option is missing, misspelt or out of range."""


class SearchError(PlatoonError, ValueError):
    """A weight, node or other argument of a search is none that it can use."""
