"""The most that platoons of one a trip save in a tiny fleet, by trying everything.

Every set of trucks is one platoon in every way there is: all paths, all whole ticks. Then all
choices of sets without a truck in common are tried.
"""

from __future__ import annotations

import functools
import itertools

from exhaustive import _schedules, _Search, _shared_choices

from platoon_osm.fleets.instance import Instance

__all__ = ["best_choice", "best_platoon", "is_one_platoon"]


def is_one_platoon(instance: Instance, schedules) -> bool:
    """Tell whether trucks join one platoon once each, which never stops and links them all."""
    linked = {0}
    for _ in schedules:
        for a, b in itertools.permutations(range(len(schedules)), 2):
            if a in linked and set(schedules[a]) & set(schedules[b]):
                linked.add(b)
    if len(linked) < len(schedules):
        return False
    for k, own in enumerate(schedules):
        others = {entry for j, other in enumerate(schedules) if j != k for entry in other}
        inside = [place for place, entry in enumerate(own) if entry in others]
        for a, b in itertools.pairwise(inside):
            (lane, at), (_, then) = own[a], own[b]
            if b != a + 1 or then != at + instance.drive[lane]:
                return False
    return True


class _OnePlatoon(_Search):
    """The same search, in which only plans of one platoon count."""

    instance: Instance

    def _step(self, i, cost):
        if i == len(self.order):
            if cost < self.cost - 0.5:
                own = {
                    k: self.thinned[j][choice][2]
                    for j, (k, choice) in enumerate(zip(self.order, self.chosen, strict=True))
                }
                if is_one_platoon(self.instance, [own[k] for k in sorted(own)]):
                    self.cost, self.found = cost, list(self.chosen)
            return
        super()._step(i, cost)


def best_platoon(instance: Instance, trucks, choices) -> int:
    """Return the most that trucks save as one platoon [grains]; 0 if that is nothing."""
    search = _shared_choices(instance, [choices[k] for k in trucks], _OnePlatoon)
    search.instance = instance
    search.cost = float(instance.alone_cost[list(trucks)].sum())
    search._step(0, 0.0)
    return round(float(instance.alone_cost[list(trucks)].sum()) - search.cost)


def best_choice(instance: Instance, apart=()) -> int:
    """Return the most that one platoon a trip saves [grains]."""
    span = range(int(instance.earliest.min()), int(instance.latest.max()) + 1)
    choices = [
        _schedules(instance, k, [set(span)] * instance.nodes, 10**6) for k in range(instance.trucks)
    ]
    most = instance.largest or instance.trucks

    @functools.cache
    def worth(trucks):
        if any(a in trucks and b in trucks for a, b in apart):
            return 0
        return best_platoon(instance, trucks, choices)

    def best(left):
        if len(left) < 2:
            return 0
        first, *rest = left
        found = best(tuple(rest))
        for size in range(1, min(most, len(left))):
            for others in itertools.combinations(rest, size):
                if saved := worth((first, *others)):
                    stay = tuple(k for k in rest if k not in others)
                    found = max(found, saved + best(stay))
        return found

    return best(tuple(range(instance.trucks)))
