"""When what is best so far is written."""

from types import SimpleNamespace

from platoon_osm.fleets.phases import CROWD
from platoon_osm.fleets.writing import Writing


def test_only_what_is_cheaper_is_written_and_only_while_that_takes_little_of_the_time():
    course = SimpleNamespace(seconds=10.0, closing_s=0.0)
    writing = Writing(course, alone=100, trucks=1, wanted=True)
    assert course.closing_s == 11.0
    assert writing.is_due(100, 10.0)
    assert not writing.is_due(101, 10.0)
    course.seconds = 30.0
    writing.done(90, 10.0)
    assert course.closing_s == 20.0
    assert not writing.is_due(90, 1000.0)
    assert not writing.is_due(80, 399.0)
    assert writing.is_due(80, 400.0)


def test_a_crowd_waits_before_it_is_written_first_and_nothing_is_where_nobody_asked():
    course = SimpleNamespace(seconds=10.0, closing_s=0.0)
    writing = Writing(course, alone=100, trucks=CROWD, wanted=True)
    assert not writing.is_due(50, 43.0)
    assert writing.is_due(50, 45.0)
    nothing = Writing(course, alone=100, trucks=1, wanted=False)
    assert course.closing_s == 7.0
    assert not nothing.is_due(0, 1e9)


def test_telling_many_trucks_takes_time_however_quickly_they_were_modelled():
    course = SimpleNamespace(seconds=0.1, closing_s=0.0)
    Writing(course, alone=100, trucks=20_000, wanted=False)
    assert course.closing_s > 10
