"""What a trip may be made of."""

import numpy as np
import pytest

from platoon_osm.errors import ScenarioError
from platoon_osm.planning.trips import Trip


def test_node_positions_from_numpy_become_plain_numbers():
    trip = Trip("A", np.int64(3), np.int32(4))
    assert trip == Trip("A", 3, 4)
    assert type(trip.origin) is int


@pytest.mark.parametrize("name", ["", "  ", None, 7])
def test_a_vehicle_needs_a_name(name):
    with pytest.raises(ScenarioError, match="must be a non-empty text"):
        Trip(name, 0, 1)


@pytest.mark.parametrize("place", ["Torino", (7.7, 45.1), 1.0, None, True])
@pytest.mark.parametrize("end", ["origin", "destination"])
def test_a_place_must_be_located_first(end, place):
    ends = {"origin": 0, "destination": 1, end: place}
    with pytest.raises(ScenarioError, match=f"^trip 'A': {end} .* come from net.locate$"):
        Trip("A", **ends)
