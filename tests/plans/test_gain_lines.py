"""Shares of the gain in words."""

from dataclasses import replace

import pytest
from plan_kinds import plan_kind

from platoon_osm.plans.gain import GainShare, GainSharing
from platoon_osm.plans.gain_lines import gain_lines

ROADS = "on the planned roads"


def told(shares, *more):
    plan, _ = plan_kind("three vehicles")
    names = [trip.vehicle for trip in plan.trips]
    gain = GainSharing("equal", "EUR", tuple(GainShare(*one) for one in shares), *more)
    return names, gain_lines(replace(plan, gain=gain))


def test_who_has_what_and_pays_what():
    (a, b, c), lines = told([(783, 657), (264, 390), (0, 0)], 6, -206.0, ROADS)
    assert lines == [
        f"Of the gain have, by equal parts of the leader's loss: {a} 6.57 EUR (pays 1.26), "
        f"{b} 3.90 EUR (receives 1.26), {c} 0.00 EUR.",
        "Nobody is worse off than alone, and none of 6 groups could gain a cent by itself "
        "(on the planned roads).",
    ]


@pytest.mark.parametrize(
    ("more", "line"),
    [
        ((14, 0.4, "planned anew"), "and none of 14 groups could gain a cent by itself (planned"),
        ((14, 34.2, ROADS), "and none of 14 groups could gain more than 0.35 EUR by itself"),
        ((0, 0.0, ROADS), "Nobody is worse off than alone, and no group could gain a cent by"),
        ((0, None, ROADS, "not asked"), "Nobody is worse off than alone."),
    ],
)
def test_what_groups_could_gain(more, line):
    _, lines = told([(1, 1), (2, 2), (0, 0)], *more)
    assert line in lines[1]
    assert lines[2:] == (["Of the shares: not asked."] if len(more) > 3 else [])


def test_who_is_worse_off_is_not_hidden():
    _, lines = told([(5, -5), (-15, -5), (0, 0)], 2, 5.0, ROADS)
    assert lines[1].startswith("Somebody is worse off than alone; none of 2 groups could gain more")


def test_where_nothing_is_shared_nothing_is_told():
    assert told([(0, 0)] * 3)[1] == []
    plan, _ = plan_kind("three vehicles")
    assert gain_lines(plan) == []
