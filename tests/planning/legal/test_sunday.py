"""A driving ban that lasts longer than a daily rest is sat out in company."""

from datetime import datetime
from zoneinfo import ZoneInfo

import pytest
from bundled import italy

import platoon_osm as po
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.star_in_time import closing_lengths

SATURDAY = datetime(2026, 3, 7, 18, tzinfo=ZoneInfo("Europe/Rome"))
H = 3600


def test_a_platoon_sits_out_sunday():
    net = italy()
    trips = [
        po.Trip(name, name, "Reggio Calabria", SATURDAY, flexibility_min=600)
        for name in ("Milano", "Brescia", "Verona")
    ]
    plan = po.plan_joint(net, po.paper_weights(net), trips, rules="eu561", patience_min=1800)
    assert not po.inspect_plan(plan)
    assert plan.proof.kind == "exact"
    assert plan.saving > 0.25
    for times in plan.timetable.vehicles:
        (rest,) = (pause for pause in times.pauses if pause.duration_s > 12 * H)
        clock = plan.timetable.clock
        # Heavy vehicles stand from 9 to 22; the driver has its daily rest meanwhile.
        assert (clock.moment(rest.end_s).hour, clock.moment(rest.end_s).minute) == (22, 0)
        assert clock.moment(rest.start_s).hour in (8, 9)
        assert "ban" in rest.purposes
        assert rest.purposes[0] == "daily_rest"
        assert rest.place.has_parking


@pytest.mark.parametrize(
    ("closed_h", "tried"),
    [
        # Rests of the law, 11 h, outlast what is short; of the rest the longest counts.
        ([], ()), ([(2, 9)], ()), ([(2, 15)], (13 * H, 13 * H + 1800)),
        ([(2, 15), (20, 34)], (14 * H, 14 * H + 1800)),
        # Long before or long after the window it is of no interest.
        ([(-40, -20)], ()), ([(300, 330)], ()),
    ],
)  # fmt: skip
def test_how_long_a_master_may_have_to_stand(closed_h, tried):
    road = road_of(
        [H, H], [NO_LIMIT] * 3, forbidden=[[(a * H, b * H) for a, b in closed_h], []]
    )  # fmt: skip
    assert closing_lengths(_Star(road)) == tried


class _Star:
    """What of a star is asked for."""

    def __init__(self, road):
        from platoon_osm.driving.eu561 import EU561
        from platoon_osm.driving.state import RESTED
        from platoon_osm.planning.legal.platoon.star_times import Span, VehicleRules

        self.road, self.window = road, Span(0, 10 * H, 60 * H)
        self.rules = VehicleRules(EU561, RESTED, 0)
