"""Which vehicles of a plan belong together, and who is the master of each group."""

from __future__ import annotations

from collections.abc import Sequence

from ...plans.records import Platoon
from ...plans.stretches import Run, linked

__all__ = ["platoons_of"]


def platoons_of(runs: Sequence[Sequence[Run]], master: int | None, case: str) -> list[Platoon]:
    """Return the platoons of a plan.

    Parameters
    ----------
    runs : sequence of sequence of Run, (N, ...)
        Who drives what with whom.
    master : int or None
        The vehicle whose route the others join; None in case D.
    case : str
        The case that was planned.

    Returns
    -------
    list of Platoon
        That of the master first, be it alone; then groups that never meet it, each with the
        vehicle that leads most edges of it as its master.
    """
    led = [0] * len(runs)
    companies = {run.company for own in runs for run in own if len(run.company) > 1}
    for index, own in enumerate(runs):
        led[index] = sum(len(run.edges) for run in own if run.company[0] == index)
    groups = [one for one in linked(sorted(companies), len(runs)) if len(one) > 1]
    if master is None:
        return [Platoon(group, None, case) for group in groups]
    own_group = next((group for group in groups if master in group), (master,))
    others = [group for group in groups if group != own_group]
    return [
        Platoon(own_group, master, case),
        *(Platoon(group, max(group, key=lambda k: (led[k], -k)), case) for group in others),
    ]
