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
    # 573 + 45 + 45 = 663, from 6:00 to 17:03.
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
        (rules, relief): (int(rests), int(waits), float(hours), there)
        for rules, relief, rests, waits, hours, there in re.findall(
            r"^([\w-]+) +([\d.]+) +[\d.]+% +(\d+) min +(\d+) min +([\d.]+)   (.*)$", text, re.M
        )
    }
    # 573 + 691 + 540 + 572 = 2376 min of driving are 39.6 h.
    assert rows["none", "0.0"] == (0, 0, 39.6, "04 March 15:33")
    # The paper's rest: 45 min for 9 h, so a twelfth more: 2376 x 13 / 12 = 2574 min are 42.9 h.
    assert rows["spread-rest", "0.0"][2] == 42.9
    # 2376 + 4 x 90 + 540 = 3276 min are 54.6 h.
    assert rows["eu561", "0.0"] == (4 * 90 + 540, 0, 54.6, "04 March 17:03")
    # Where a follower's clock stands, only who leads needs breaks, and the others wait meanwhile;
    # Torino needs no night: 2376 + 4 x 90 = 2736 min are 45.6 h.
    assert rows["eu561", "1.0"] == (90, 3 * 90, 45.6, "04 March 17:03")
    assert rows["eu561", "0.5"][2] == 45.6
    assert sum(rows["eu561", "0.5"][:2]) == 4 * 90


def test_los_angeles_to_sacramento_adds_up(told):
    text = told("los_angeles_sacramento.py")
    # 2 h = 120 min before, 425 min to Sacramento: 545 > 480 min of driving, so 30 min off it. The
    # vehicle stands 41 min at its origin, which is a break already: 6:00 + 0:41 + 7:05 = 13:45.
    assert "Los Angeles drives 7 h 05 min until 13:45; at rest 06:00 to 06:41" in text
    # 813 km in 555 min > 480, so 30 min: 4:00 + 9:15 + 0:30 = 13:45.
    assert re.search(r"San Diego drives 9 h 15 min until 13:45; break .* no parking known\)", text)
    # 299 min < 480: no break. 8:46 + 4:59 = 13:45, less the seconds that are rounded.
    assert "Bakersfield drives 4 h 59 min until 13:44; no break" in text
    # 179 km and 372 km before, 440 km together.
    assert "its km 179, 08:46" in text
    assert "its km 372, 08:46" in text
    assert "3 of 3 masters tried" in text
    # The other law allows 270 min without a break, and asks for 45.
    assert "By us395: 0 violations" in text
    assert "Bakersfield: 561/2006 Art. 7: 4 h 58 min 36 s driven without a break" in text
