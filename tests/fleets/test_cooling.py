"""Heat falls from 1 to 0, in each phase of a small plan, once in a large one; phases end early."""

import itertools
from types import SimpleNamespace

import numpy as np
import pytest

from platoon_osm.fleets.cooling import heat_at
from platoon_osm.fleets.phases import phases_of
from platoon_osm.fleets.run import FleetRun

SMALL, LARGE, CROWD = 1000, 5000, 20_000


def heats(trucks, late=0.0):
    """Return shares and heats of each phase of the plan, that begins so much late."""
    phases, begin, found = phases_of(trucks), 0.0, []
    for number, (who, until) in enumerate(phases):
        if who == "plan":
            begun = begin + late
            shares = np.linspace(begun, until, 50)
            found.append((shares, [heat_at(phases, number, begun, s, trucks) for s in shares]))
        begin = until
    return found


@pytest.mark.parametrize("late", [0.0, 0.05])
@pytest.mark.parametrize("trucks", [SMALL, LARGE, CROWD])
def test_it_falls_within_a_phase_and_nothing_dearer_is_taken_at_the_end(trucks, late):
    for _, found in heats(trucks, late):
        assert all(1 >= one >= other >= 0 for one, other in itertools.pairwise(found))
        assert found[0] > found[-1]
    assert found[-1] == 0 == found[-5]


@pytest.mark.parametrize("trucks", [LARGE, CROWD])
def test_a_large_fleet_goes_on_as_cold_as_it_was(trucks):
    (_, first), (_, second) = heats(trucks)
    assert first[0] == pytest.approx(1)
    assert second[0] == pytest.approx(first[-1])
    assert 0 < first[-1] < 0.5


def test_a_small_fleet_is_hot_again():
    for _, found in heats(SMALL):
        assert (found[0], found[-1]) == (pytest.approx(1), 0)


def test_a_bound_that_stalls_goes_on_by_fine_steps_and_then_leaves_time_to_the_plan():
    run = SimpleNamespace(cost=1000.0, _fine=False)
    rising = [900.0, 905.0, 905.2, 905.4, 905.6, 905.8]
    assert not FleetRun._stalled(run, rising[:4])
    assert not FleetRun._stalled(run, rising[:5])
    assert FleetRun._stalled(run, rising)
    run.cost = 910.0
    assert not FleetRun._stalled(run, rising)
    run.cost, run._fine = 1000.0, True
    assert not FleetRun._stalled(run, rising)
    assert FleetRun._stalled(run, [*rising, 905.82, 905.84])


def test_fine_steps_leave_the_shares_that_guide_the_search_alone():
    asked = []

    def improve(target, steps, stop, fine):
        asked.append(fine)
        bound.shares, bound.guide = f"shares {len(asked)}", f"guide {len(asked)}"

    bound = SimpleNamespace(improve=improve)
    run = SimpleNamespace(bound=bound, cost=1000, _fine=False, _guiding=None)
    for fine, guiding in ((False, 1), (False, 2), (True, 2), (True, 2)):
        run._fine = fine
        FleetRun._raise(run, lambda: False)
        assert run._guiding == (f"shares {guiding}", f"guide {guiding}")
    assert asked == [False, False, True, True]
