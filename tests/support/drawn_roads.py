"""Small roads that are drawn: hops in whole steps, places, appointments, closings, reliefs."""

from platoon_osm.planning.legal.driver.road import FREE, NO_LIMIT, road_of

__all__ = ["drawn_road"]


def drawn_road(
    rng, step, begins, bans, appointments, relief, *, hops=(3, 4, 5), drives=(1, 1, 2, 2, 3),
    places=0.7,
):  # fmt: skip
    """Return a road of some hops, of which a share of the points is a place to stand."""
    n = rng.choice(hops)
    drive = [rng.choice(drives) for _ in range(n)]
    leave = [FREE] * (n + 1)
    for _ in range(appointments):
        point = rng.randint(1, n - 1)
        leave[point] = begins + (sum(drive[:point]) + rng.randint(0, 7)) * step
    closed = [[] for _ in range(n)]
    for _ in range(bans):
        at = begins + rng.randint(-2, sum(drive) + 4) * step
        closed[rng.randint(0, n - 1)].append((at, at + rng.randint(1, 5) * step))
    clock = [rng.randint(0, one) if relief and rng.random() < 0.5 else one for one in drive]
    return road_of(
        [one * step for one in drive],
        [NO_LIMIT if rng.random() < places else 0 for _ in range(n + 1)],
        clock_s=[one * step for one in clock],
        leave_s=leave,
        forbidden=[_apart(own) for own in closed],
    )


def _apart(closed):
    """Return intervals without those that overlap the one before."""
    found = []
    for begin, end in sorted(closed):
        if not found or begin >= found[-1][1]:
            found.append((begin, end))
    return found
