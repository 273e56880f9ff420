"""What a trip may be made of."""

from datetime import UTC, date, datetime, time

import numpy as np
import pandas
import pytest

from platoon_osm.errors import ScenarioError
from platoon_osm.plans.trip import Trip


def test_node_positions_from_numpy_become_plain_numbers():
    trip = Trip("A", np.int64(3), np.int32(4))
    assert trip == Trip("A", 3, 4)
    assert type(trip.origin) is int


@pytest.mark.parametrize("name", ["", "  ", None, 7])
def test_a_vehicle_needs_a_name(name):
    with pytest.raises(ScenarioError, match="must be a non-empty text"):
        Trip(name, 0, 1)


def test_places_stay_as_they_are_written():
    trip = Trip("A", "Torino", np.array([7.7, 45.1]))
    assert (trip.origin, trip.destination) == ("Torino", (7.7, 45.1))


@pytest.mark.parametrize(
    "place", ["", "  ", (7.7,), (7.7, 45.1, 0), ("7.7", "45.1"), b"Torino", 1.0, None, True, {}]
)
@pytest.mark.parametrize("end", ["origin", "destination"])
def test_anything_else_is_no_place(end, place):
    ends = {"origin": 0, "destination": 1, end: place}
    with pytest.raises(ScenarioError, match=f"^trip 'A': {end} .* come from net.locate$"):
        Trip("A", **ends)


SIX, SEVEN = datetime(2026, 3, 2, 6), datetime(2026, 3, 2, 7)


def test_times_by_name():
    assert Trip("A", 0, 1).times == {}
    trip = Trip("A", 0, 1, SIX, latest_arrival=SEVEN)
    assert trip.times == {"earliest_departure": SIX, "latest_arrival": SEVEN}


def test_a_departure_may_be_fixed():
    assert Trip("A", 0, 1, SIX, SIX).latest_departure == SIX


def test_no_moment_is_no_time():
    with pytest.raises(ScenarioError, match=r"^trip 'A': latest_arrival is NaT"):
        Trip("A", 0, 1, latest_arrival=pandas.NaT)
    with pytest.raises(ScenarioError, match="must be a day and a time"):
        Trip("A", 0, 1, latest_arrival=np.datetime64("NaT"))


@pytest.mark.parametrize("value", ["06:00", 6, date(2026, 3, 2), time(6), 0.0, ""])
@pytest.mark.parametrize("name", ["earliest_departure", "latest_departure", "latest_arrival"])
def test_a_time_is_a_day_and_a_time(name, value):
    with pytest.raises(ScenarioError, match=f"^trip 'A': {name} .* must be a day and a time"):
        Trip("A", 0, 1, **{name: value})


@pytest.mark.parametrize(
    ("times", "said"),
    [
        ({"earliest_departure": SEVEN, "latest_departure": SIX}, "latest_departure 2026-03-02T06"),
        ({"earliest_departure": SEVEN, "latest_arrival": SIX}, "latest_arrival 2026-03-02T06"),
        ({"earliest_departure": SIX, "latest_arrival": SIX}, "give a later latest_arrival$"),
        ({"earliest_departure": SIX.replace(year=9999)}, "is in the year 9999; give one from 1900"),
        ({"earliest_departure": SIX, "latest_arrival": SEVEN.replace(tzinfo=UTC)}, "time zone"),
    ],
)
def test_times_that_contradict_each_other(times, said):
    with pytest.raises(ScenarioError, match=said) as error:
        Trip("A", 0, 1, **times)
    assert "'A'" in str(error.value)
    assert "\n" not in str(error.value)
