"""What a stop offers depends on who comes."""

from collections import Counter

import pytest

from platoon_osm.network.restrictions import encode
from platoon_osm.network.road_stop import RoadStop
from platoon_osm.network.stop_tags import offers_of
from platoon_osm.sources.stops.features import read_stop
from platoon_osm.vehicles.profile import VEHICLES
from platoon_osm.vehicles.stop_offers import offers_to

TRUCK, VAN = VEHICLES["eu-40t"], VEHICLES["van-3.5t"]


def stop(*parts):
    layers = [read_stop(tags, Counter()).tags for tags in parts]
    return RoadStop("", "services", 0.0, 0.0, offers_of(layers), None, (), None, None, None, (),
                    encode(layers))  # fmt: skip


PUMP = {"amenity": "fuel", "hgv": "yes"}


@pytest.mark.parametrize(
    ("parts", "truck", "van"),
    [
        ([{"highway": "services"}], ("parking",), ("parking",)),
        ([{"highway": "services", "hgv": "no"}], (), ("parking",)),
        (
            [{"highway": "services"}, {**PUMP, "maxheight": "3.8"}],
            ("parking",),
            ("parking", "fuel"),
        ),
        ([{"highway": "services"}, {**PUMP, "maxheight": "4.2"}], ("parking", "fuel"), None),
        ([{"amenity": "parking", "hgv": "only", "access": "no"}], ("parking",), ()),
        ([{"amenity": "parking", "access": "hgv"}], ("parking",), ()),
        ([{"amenity": "parking", "truck": "yes"}], ("parking",), ("parking",)),
        ([{"amenity": "parking", "capacity:hgv": "9", "maxlength": "12"}], (), ("parking",)),
        ([{"amenity": "charging_station", "hgv": "designated"}], ("charging",), None),
    ],
)
def test_each_part_is_judged_by_its_own_tags(parts, truck, van):
    place = stop(*parts)
    assert offers_to(place, TRUCK) == truck
    assert van is None or offers_to(place, VAN) == van


def test_a_stop_of_a_network_without_tags_offers_what_its_kind_does():
    place = RoadStop("", "fuel", 0.0, 0.0, ("fuel",), None, (), None, None, None, (), "")
    assert offers_to(place, TRUCK) == ("fuel",)
