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


class NoLegalTripError(NoRouteError):
    """No drive between two places keeps the driving rules that were asked for."""


class ScenarioError(PlatoonError):
    """A scenario, trip or option is missing, misspelt or out of range."""


class SearchError(PlatoonError, ValueError):
    """A weight, node or other argument of a search is none that it can use."""


def brief(value: object, most: int = 60) -> str:
    """Return how a value looks, on one line, for a message.

    Parameters
    ----------
    value : object
        Anything; what it looks like may run over several lines, or be long.
    most : int
        Characters at most.

    Returns
    -------
    str
        The beginning of its `repr`, blanks and line ends as single spaces.
    """
    try:
        text = " ".join(repr(value).split())
    except Exception:  # somebody else's repr must not hide what is wrong
        text = f"a {type(value).__name__}"
    return text if len(text) <= most else text[: most - 1] + "\u2026"
