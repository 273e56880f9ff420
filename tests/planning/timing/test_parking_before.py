"""Who stands on its way is told of the truck parking before that place."""

from dataclasses import replace
from datetime import datetime
from zoneinfo import ZoneInfo

import numpy as np
import pytest
from roads_with_hours import row_with_turn_offs

import platoon_osm as po
from platoon_osm.network.columns import POINT_KINDS
from platoon_osm.network.road_network import NamedPoints
from platoon_osm.network.texts import TextTable

HOURS = "no @ (07:00-19:00)"


def straight(stops):
    """Return the row with stops (km along it, kind, name, tags) a little to its south."""
    net = row_with_turn_offs("", HOURS)
    texts = [*net.texts]
    points = NamedPoints(
        np.array([0.75 * km / 60 for km, *_ in stops], float),
        np.full(len(stops), 44.9995),
        np.array([POINT_KINDS.index(kind) for _, kind, *_ in stops], np.uint8),
        np.array([len(texts) + 2 * k for k in range(len(stops))], np.int32),
        np.zeros(len(stops), np.int64),
        tags=np.array([len(texts) + 2 * k + 1 for k in range(len(stops))], np.int32),
    )
    texts += [text for *_, name, tags in stops for text in (name, tags)]
    return replace(net, texts=TextTable.from_strings(texts), points=points, _file=None)


def remark(stops):
    start = datetime(2026, 3, 3, 6, tzinfo=ZoneInfo("Europe/Rome"))
    trip = po.Trip("A", 0, 4, start, start)
    net = straight(stops)
    plan = po.plan_joint(net, po.paper_weights(net), [trip])
    (found,) = [one for one in plan.remarks if "keeps to" in one]
    return found.partition("more on its way")[2]


AREA = ("highway=rest_area", "highway=services")


@pytest.mark.parametrize(
    ("stops", "told"),
    [
        ([], ""),
        # It stands 120 km from its origin.
        ([(108, "services", "Near", AREA[1])], ", 12 km after the truck parking Near"),
        ([(80, "services", "Far", AREA[1]), (108, "rest_area", "Near", AREA[0])],
         ", 12 km after the truck parking Near"),
        ([(100, "parking", "", "amenity=parking hgv=yes")], ", 20 km after the truck parking"),
        ([(60.5, "services", "Back", AREA[1])], ""),
        ([(130, "services", "Ahead", AREA[1])], ""),
        # No truck may stop there, or none of this height.
        ([(108, "rest_area", "Cars", "hgv=no highway=rest_area")], ""),
        ([(108, "rest_area", "Low", "highway=rest_area maxheight=3")], ""),
        ([(108, "fuel", "Pump", "amenity=fuel hgv=yes")], ""),
    ],
)  # fmt: skip
def test_the_last_parking_before_is_told(stops, told):
    assert remark(stops) == told
