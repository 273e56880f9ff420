"""Fatigue, eq. 6 to 9, and why the heuristic made of it (eq. 10) is not admissible."""

import math
import warnings

import numpy as np
import pytest

from platoon_osm.costs.fatigue import (
    FatigueModel,
    driving_clock,
    fatigue_curve,
    fatigue_heuristic,
    period_of_day,
)
from platoon_osm.errors import ScenarioError

HOUR = 3600.0


def test_eq_6_morning_at_three_moments():
    # 60.83 exp(-(8834/4760)^2) = 60.83 * 0.0319 = 1.94 and so on.
    start, peak, end = fatigue_curve([0, 8834, 4.5 * HOUR], "morning")
    assert start == pytest.approx(1.9, abs=0.05)
    assert peak == pytest.approx(60.83)
    # 60.83 exp(-(7366/4760)^2) = 60.83 * 0.0912
    assert f"{end:.1f}" == "5.5"


def test_eq_6_has_one_peak():
    # 8834 s are 2.45 h.
    t = np.arange(0, 16201, 10.0)
    curve = fatigue_curve(t, "morning")
    assert t[np.argmax(curve)] == pytest.approx(8834, abs=10)


def test_eq_7_afternoon_at_its_two_centres():
    # At 9675 s: 22.1 + 92.1 exp(-(4145/6358)^2) = 22.1 + 92.1 * 0.6538 = 82.3.
    # At 13820 s: 92.1 + 22.1 exp(-(4145/6142)^2) = 92.1 + 22.1 * 0.6342 = 106.1.
    assert fatigue_curve([9675, 13820], "afternoon") == pytest.approx([82.3, 106.1], abs=0.1)


def test_eq_8_night_is_afternoon_and_one_more_bump():
    t = np.array([0.0, 5046.0, 9000.0])
    extra = fatigue_curve(t, "night") - fatigue_curve(t, "afternoon")
    # The bump is 2.599 high at 5046 s; at 9000 s it is 2.599 exp(-9.9), next to nothing.
    assert extra[1] == pytest.approx(2.599)
    assert extra[0] == pytest.approx(2.599 * math.exp(-((5046 / 1257) ** 2)))
    assert extra[2] < 2e-4


def test_eq_9_is_the_sum_of_the_three():
    t = [0.0, 3600.0, 9000.0]
    parts = sum(fatigue_curve(t, period) for period in ("morning", "afternoon", "night"))
    assert FatigueModel("as_printed").along(t) == pytest.approx(parts)


def test_by_period_takes_the_curve_of_the_hour():
    t = [3600.0] * 6
    hours = [6, 11.99, 12, 19.99, 20, 5.99]
    wanted = ["morning", "morning", "afternoon", "afternoon", "night", "night"]
    found = FatigueModel("by_period").along(t, hours)
    assert found == pytest.approx([float(fatigue_curve(3600, name)) for name in wanted])


def test_hours_run_round_the_clock():
    assert period_of_day([30, -1]).tolist() == [0, 2]  # 6 h of tomorrow, 23 h of yesterday


def test_by_period_needs_the_hours():
    with pytest.raises(ScenarioError, match="needs the hour of day"):
        FatigueModel("by_period").along([0.0])


def test_monotone_never_falls_though_the_printed_curve_does():
    t = np.arange(0, 16201, 60.0)
    printed, monotone = FatigueModel("as_printed").along(t), FatigueModel("monotone").along(t)
    assert np.diff(printed).min() < 0
    assert np.diff(monotone).min() >= 0
    assert (monotone >= printed).all()
    assert monotone[0] == pytest.approx(printed[0])
    rising = t < HOUR
    assert monotone[rising] == pytest.approx(printed[rising])


def test_monotone_does_not_depend_on_how_often_one_looks():
    often = FatigueModel("monotone").along(np.arange(0, 16201, 100.0))
    seldom = FatigueModel("monotone").along([0.0, 16200.0])
    # The peak lies between the two moments; a driver has been through it all the same.
    assert seldom[1] == pytest.approx(often[-1], rel=1e-4)
    assert seldom[1] > FatigueModel("as_printed").along([16200.0])[0] + 10


def test_monotone_keeps_its_level_while_the_clock_stands():
    values = FatigueModel("monotone").along([0.0, 3600.0, 3600.0, 3600.0])
    assert values[1] == values[2] == values[3]


@pytest.mark.parametrize("clock", [[16201.0], [-1.0, 0.0]])
@pytest.mark.parametrize("form", ["as_printed", "monotone"])
def test_warning_outside_the_fitted_range(form, clock):
    with pytest.warns(UserWarning, match=r"curves hold up to 4\.5 h"):
        FatigueModel(form).along(clock)


def test_no_warning_inside():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        FatigueModel().along([0.0, 16200.0])
        assert FatigueModel().along([]).shape == (0,)


def test_a_clock_that_is_not_finite():
    with pytest.raises(ScenarioError, match="not finite"):
        FatigueModel().along([0.0, math.nan])


LEGS = [("solo", 3600.0), ("platoon", 7200.0), ("solo", 1800.0)]


@pytest.mark.parametrize(
    ("relief", "after_platoon", "end"),
    [(1, 3600, 5400), (0, 10800, 12600), (0.5, 7200, 9000)],
)
def test_driving_clock_slows_in_the_platoon(relief, after_platoon, end):
    time, clock = driving_clock(LEGS, relief)
    assert time[0] == clock[0] == 0
    assert time[-1] == pytest.approx(12600)
    assert clock[-1] == pytest.approx(end)
    assert np.interp(10800, time, clock) == pytest.approx(after_platoon)
    assert np.diff(clock).min() >= 0


def test_driving_clock_steps():
    time, _ = driving_clock([("solo", 1000.0)], 1, step_s=300)
    assert time == pytest.approx([0, 250, 500, 750, 1000])
    assert driving_clock([], 1)[0].tolist() == [0]


@pytest.mark.parametrize(
    ("legs", "relief", "step", "message"),
    [
        ([("solo", -1.0)], 1, 300, "finite and 0 or more"),
        ([("solo", math.nan)], 1, 300, "finite and 0 or more"),
        ([("leader", 1.0)], 1, 300, "role 'leader' is unknown"),
        ([], 1.5, 300, "task_relief = 1.5"),
        ([], 1, 0, "step_s = 0"),
    ],
)
def test_driving_clock_of_nonsense(legs, relief, step, message):
    with pytest.raises(ScenarioError, match=message):
        driving_clock(legs, relief, step)


@pytest.mark.parametrize("form", ["Monotone", "", None])
def test_unknown_form(form):
    with pytest.raises(ScenarioError, match=r"fatigue form .* is unknown"):
        FatigueModel(form)


@pytest.mark.parametrize("relief", [-0.1, 1.1, math.nan, "1", None, True])
def test_task_relief_out_of_range(relief):
    with pytest.raises(ScenarioError, match=r"task_relief = .* in \[0, 1\]$"):
        FatigueModel(task_relief=relief)


def test_unknown_period():
    with pytest.raises(ScenarioError, match="period 'noon' is unknown; use morning"):
        fatigue_curve(0, "noon")


def test_eq_10_by_hand():
    # A kilometre from the goal at 110 km/h is 32.7 s; F there is the sum of the three curves.
    seconds = 1000 * 3.6 / 110
    fatigue = sum(float(fatigue_curve(seconds, p)) for p in ("morning", "afternoon", "night"))
    found = fatigue_heuristic(1000.0, 5000.0, 110 / 3.6)
    assert float(found) == pytest.approx(96.06 * 5000 * fatigue)


def test_the_heuristic_is_not_admissible():
    # An admissible heuristic never exceeds the cost that remains; at the goal that is 0.
    at_goal = float(fatigue_heuristic(0.0, 1000.0, 110 / 3.6))
    assert at_goal > 0
    # A straight 100 km road costs 37/12 of its length alone; the estimate is far above it.
    road = 100_000 * 37 / 12
    assert float(fatigue_heuristic(100_000.0, road, 110 / 3.6)) > 1000 * road
