"""The examples under driving rules, in numbers that a person can add up."""

import re
from functools import cache

import pytest
from places import ROOT

SUM = re.compile(
    r"sum: +(\d+) min driving \+ +(\d+) min of breaks and rests \+ +(\d+) min of waiting"
    r" = +(\d+) min"
)


@pytest.fixture(scope="module")
def told(forks, tmp_path_factory):
    """What an example prints, each run once."""

    @cache
    def printed(name):
        done = forks.run(script=ROOT / "examples" / name, folder=tmp_path_factory.mktemp("legal"))
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout

    return printed


def test_milano_to_napoli_adds_up(told):
    text = told("legal_day.py")
    days = re.findall(r"^(\w+), leaves at [^\n]*\n(.*?)  (sum:[^\n]*)", text, re.S | re.M)
    blocks = {name: day for name, day, _ in days}
    found = {name: tuple(map(int, SUM.search(line).groups())) for name, _, line in days}
    # A1 from Milano to Napoli: 764.4 km at 80 km/h are 573 min, more than 2 x 270, so two breaks:
    # 573 + 45 + 45 = 663.
    assert found["Milano"] == (573, 45 + 45, 0, 573 + 90)
    # From Brescia 761.3 km and from Venezia 719.3 km: 571.6 and 540.1 min, and the same two breaks.
    assert found["Brescia"] == (572, 90, 0, 572 + 90)
    assert found["Venezia"] == (540, 90, 0, 540 + 90)
    # From Torino 919 km are 691 min, more than the 600 of a long day: 9 h = 540 min of reduced
    # rest on the way, after it the breaks of the others: 691 + 540 + 90 = 1321.
    assert found["Torino"] == (691, 540 + 90, 0, 691 + 630)
    assert "All in time." in text
    assert "Proved optimal for: master Milano on its own route" in text
    assert "Violations of 561/2006 in this plan: 0" in text
    # Within a day no spell is longer than 4 h 30 = 270 min, the parts of a break are 15 and 30.
    for day in blocks.values():
        spell = parts = 0
        for minutes, what in re.findall(r" +(\d+) min (driving|break|first|second|reduced)", day):
            if what == "driving":
                spell += int(minutes)
                assert spell <= 270
            elif what == "first":
                assert int(minutes) >= 15
                parts = 1
            else:
                assert int(minutes) >= {"break": 45, "second": 30, "reduced": 540}[what]
                assert parts or what != "second"
                spell = parts = 0
    # Each line begins when the one before ends, to the minute.
    for day in blocks.values():
        lines = re.findall(r"^  (\d\d):(\d\d)(?: \+1 d)? +(?:(\d+) min|arrives)", day, re.M)
        at = [int(hour) * 60 + int(minute) for hour, minute, _ in lines]
        for begin, (_, _, lasts), after in zip(at, lines, at[1:], strict=False):
            assert abs((begin + int(lasts) - after + 720) % 1440 - 720) <= 1


def test_what_a_change_of_law_is_worth(told):
    text = told("legal_day.py")
    rows = {
        (rules, relief): (int(rests), int(waits), float(hours))
        for rules, relief, rests, waits, hours in re.findall(
            r"^([\w-]+) +([\d.]+) +[\d.]+% +(\d+) min +(\d+) min +([\d.]+)   ", text, re.M
        )
    }
    # 573 + 691 + 540 + 572 = 2376 min of driving are 39.6 h.
    assert rows["none", "0.0"] == (0, 0, 39.6)
    # The paper's rest: 45 min for 9 h, so a twelfth more: 2376 x 13 / 12 = 2574 min are 42.9 h.
    assert rows["spread-rest", "0.0"][2] == 42.9
    # 2376 + 4 x 90 + 540 = 3276 min are 54.6 h.
    assert rows["eu561", "0.0"] == (4 * 90 + 540, 0, 54.6)
    # Where a follower's clock stands, only who leads needs breaks, and the others wait meanwhile;
    # Torino needs no night: 2376 + 4 x 90 = 2736 min are 45.6 h.
    assert rows["eu561", "1.0"] == (90, 3 * 90, 45.6)
    assert rows["eu561", "0.5"][2] == 45.6
    assert sum(rows["eu561", "0.5"][:2]) == 4 * 90


def test_los_angeles_to_sacramento_adds_up(told):
    text = told("los_angeles_sacramento.py")
    days = {
        name: (int(hours) * 60 + int(minutes), rest)
        for name, hours, minutes, rest in re.findall(
            r"^([\w ]+) drives (\d+) h (\d+) min until [\d:]+;? ?(.*)$", text, re.M
        )
    }
    # 2 h = 120 min before, 425 min to Sacramento: 545 > 480 min of driving, so 30 min off it; the
    # vehicle stands longer than that at its origin, which is a break already.
    driven, rest = days["Los Angeles"]
    assert driven == 7 * 60 + 5
    (begin, until) = (int(h) * 60 + int(m) for h, m in re.findall(r"(\d\d):(\d\d)", rest)[:2])
    assert until - begin >= 30
    assert rest.endswith("before it leaves; no break")
    # 813 km in 555 min > 480, so 30 min on the way.
    driven, rest = days["San Diego"]
    assert driven == 9 * 60 + 15
    (begin, until) = (int(h) * 60 + int(m) for h, m in re.findall(r"(\d\d):(\d\d)", rest)[:2])
    assert until - begin == 30
    assert rest.endswith("no parking known)")
    # 299 min < 480: no break.
    assert days["Bakersfield"] == (4 * 60 + 59, "no break")
    # 620 = 179 + 440 km and 813 = 372 + 440 km, less what is rounded.
    assert "Los Angeles merges with Bakersfield and San Diego at CA 99 exit 27" in text
    assert "(its km 179, " in text
    assert "(its km 372, " in text
    assert "3 of 3 masters tried" in text
    # The other law allows 270 min without a break.
    assert "By us395: 0 violations" in text
    assert "Bakersfield: 561/2006 Art. 7: 4 h 58 min 3" in text
