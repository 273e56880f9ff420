"""Days and weeks written by hand, each with the verdict that a person can add up.

A verdict names article, moment and minutes: "Art. 7 Mon 10:30 +1" is one minute beyond 4 h 30 of
driving. The second week is told as "2Tue". An empty one is a day that is allowed.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from platoon_osm.inspection.activities import DAY, HOUR, MINUTE, WEEK, Record
from platoon_osm.inspection.day_text import DAYS, day_of
from platoon_osm.inspection.driver_start import RESTED, DriverStart
from platoon_osm.inspection.violation import Violation

__all__ = ["EU_DAYS", "US_DAYS", "Written", "told"]


@dataclass(frozen=True)
class Written:
    """A day, what the driver has behind it, and what is wrong with it."""

    day: str
    wrong: tuple[str, ...] = ()
    start: str = "Mon 06:00"
    state: DriverStart = RESTED
    options: dict[str, Any] = field(default_factory=dict)

    @cached_property
    def record(self) -> Record:
        return day_of(self.day, self.start)


def told(violation: Violation) -> str:
    """Return a violation as the tables tell it."""
    week, rest = divmod(int(violation.at_s), WEEK)
    day, rest = divmod(rest, DAY)
    hour, rest = divmod(rest, HOUR)
    minute, second = divmod(rest, MINUTE)
    article = violation.article.removeprefix("561/2006 ").removeprefix("49 CFR 395.3")
    moment = f"{week + 1 if week else ''}{DAYS[day]} {hour:02d}:{minute:02d}"
    moment += f":{second:02d}" if second else ""
    return f"{article} {moment} +{violation.minutes_over:g}"


def day(text: str, *wrong: str, at: str = "Mon 06:00", **state: Any) -> Written:
    """Return a row; hours of the state are given as `today_h`, say."""
    names = {
        "since_break_h": "driven_since_break_s", "today_h": "driven_today_s", "duty_h": "duty_s",
        "week_h": "driven_this_week_s", "last_week_h": "driven_last_week_s",
        "since_weekly_h": "since_weekly_rest_s",
    }  # fmt: skip
    options = {key: state.pop(key) for key in ("days", "clock_s") if key in state}
    given = {
        names.get(key, key): round(value * HOUR) if key in names else value
        for key, value in state.items()
    }
    return Written(text, wrong, at, replace(RESTED, **given), options)


USED = {"reduced_rests_used": 3}
LONG_USED = {"long_days_used": 2}

NINE = "4h30 drive, 45m rest, 4h30 drive"
TEN = f"{NINE}, 45m rest, 1h drive"
LIGHT = "1h drive, 12h available, 11h rest"

BREAKS = [
    day("4h30 drive"),
    day("4h31 drive", "Art. 7 Mon 10:30 +1"),
    day("4h30 drive, 45m rest, 4h30 drive"),
    day("4h30 drive, 44m rest, 1m drive", "Art. 7 Mon 11:14 +1"),
    # 15 and then 30
    day("2h drive, 15m rest, 2h30 drive, 30m rest, 4h30 drive"),
    day("2h drive, 15m rest, 2h30 drive, 29m rest, 1h drive", "Art. 7 Mon 11:14 +60"),
    day("2h drive, 14m rest, 2h30 drive, 30m rest, 1h drive", "Art. 7 Mon 11:14 +60"),
    # the wrong order
    day("2h drive, 30m rest, 2h30 drive, 15m rest, 4h30 drive", "Art. 7 Mon 11:15 +270"),
    # 30 is more than 15
    day("2h drive, 30m rest, 2h30 drive, 30m rest, 4h30 drive"),
    # one more pause harms nobody
    day("2h drive, 30m rest, 2h drive, 30m rest, 4h30 drive"),
    day("1h drive, 15m rest, 1h drive, 30m rest, 2h drive, 30m rest, 4h30 drive"),
    day("2h drive, 15m rest, 1h drive, 15m rest, 1h30 drive, 30m rest, 4h30 drive"),
    day("3 x (1h30 drive, 15m rest), 10m drive", "Art. 7 Mon 11:15 +10"),
    # too late for both parts
    day("4h drive, 15m rest, 31m drive, 30m rest, 1h drive", "Art. 7 Mon 10:45 +1"),
    # neither work nor waiting for work is a break, nor is one that work interrupts
    day("4h30 drive, 45m work, 1m drive", "Art. 7 Mon 11:15 +1"),
    day("4h30 drive, 45m available, 1m drive", "Art. 7 Mon 11:15 +1"),
    day("4h30 drive, 30m rest, 1m work, 15m rest, 1m drive", "Art. 7 Mon 11:16 +1"),
    # a break begins everything anew, and cannot be the first part of the next
    day("1h drive, 45m rest, 4h30 drive, 45m rest, 3h30 drive"),
    day("4h30 drive, 1h rest, 4h drive, 30m rest, 1h drive", "Art. 7 Mon 16:30 +30"),
    day("5h drive, 45m rest, 5h drive", "Art. 7 Mon 10:30 +30", "Art. 7 Mon 16:15 +30"),
    # a pause before any driving is no part of a break
    day("1h rest, 4h30 drive, 30m rest, 1h drive", "Art. 7 Mon 12:00 +60"),
    day("1h drive, 45m rest, 10m work, 15m rest, 4h30 drive, 30m rest, 30m drive",
        "Art. 7 Mon 13:10 +30"),
    # the first part of the second break is taken after the first
    day("3h drive, 15m rest, 1h30 drive, 30m rest, 15m drive, 30m rest, 4h30 drive",
        "Art. 7 Mon 16:15 +15"),
    # what was driven before
    day("2h30 drive, 30m rest, 4h30 drive", since_break_h=2, today_h=2, duty_h=3,
        first_part_taken=True),
    day("2h30 drive, 30m rest, 4h30 drive", "Art. 7 Mon 09:00 +270", since_break_h=2, today_h=2,
        duty_h=3),
    day("31m drive", "Art. 7 Mon 06:30 +1", since_break_h=4, today_h=4, duty_h=4),
    day("45m rest, 4h30 drive", since_break_h=4, today_h=4, duty_h=4),
    day("1h drive", "Art. 7 Mon 06:00 +90", since_break_h=5, today_h=5, duty_h=5),
    # relieved of half the task, or of all of it
    day("9h drive/50"),
    day("9h2m drive/50", "Art. 7 Mon 15:00 +1"),
    day("4h drive, 1h drive/100, 30m drive"),
]  # fmt: skip

TWO_DRIVERS = [
    day("4h30 drive, 45m passenger, 4h30 drive", drivers=2),
    day("4h30 drive, 44m passenger, 1m drive", "Art. 7 Mon 11:14 +1", drivers=2),
    day("10m drive, 45m passenger, 10m work, 15m rest, 4h20 drive, 30m rest, 4h30 drive",
        drivers=2),
    day("4h30 drive, 20m rest, 25m passenger, 4h30 drive", drivers=2),
    day("2h drive, 15m passenger, 2h30 drive, 30m rest, 1m drive", "Art. 7 Mon 11:15 +1",
        drivers=2),
    day("2h drive, 15m rest, 2h30 drive, 30m passenger, 1m drive", "Art. 7 Mon 11:15 +1",
        drivers=2),
    day("2h drive, 10m rest, 5m passenger, 10m rest, 2h30 drive, 30m rest, 1m drive",
        "Art. 7 Mon 11:25 +1", drivers=2),
    day("2h drive, 10m rest, 5m passenger, 15m rest, 2h30 drive, 30m rest, 4h30 drive", drivers=2),
    # 9 h within 30 h
    day("4h30 drive, 4h30 passenger, 4h30 drive, 7h30 passenger, 9h rest, 1m drive", drivers=2),
    day("4h30 drive, 4h30 passenger, 4h30 drive, 7h31 passenger, 9h rest, 1m drive",
        "Art. 8(5) Tue 03:00 +1", drivers=2),
    day("4h30 drive, 4h30 passenger, 4h30 drive, 7h30 passenger, 9h rest, 1m drive",
        "Art. 8(2) Mon 21:00 +360"),
    # which uses up no reduced rest
    day("4 x (4h30 drive, 4h30 passenger, 4h30 drive, 7h30 passenger, 9h rest), 1m drive",
        drivers=2),
    day("21h available, 9h rest, 1m drive", drivers=2, **USED),
]  # fmt: skip

DAILY_DRIVING = [
    day(TEN),
    day(f"{NINE}, 45m rest, 1h1m drive", "Art. 6(1) Mon 17:30 +1"),
    day(f"{NINE}, 45m rest, 1h drive", "Art. 6(1) Mon 16:30 +60", **LONG_USED),
    day(f"2 x ({TEN}, 12h30 rest), {TEN}", "Art. 6(1) Wed 16:30 +60"),
    day(f"2 x ({TEN}, 12h30 rest), {NINE}"),
    # two in each calendar week, wherever the days lie
    day(f"2 x ({TEN}, 12h30 rest), {TEN}", at="Sat 06:00"),
    day(f"4 x ({TEN}, 12h30 rest), 1m drive", at="Sat 06:00"),
    day(f"5 x ({TEN}, 12h30 rest), 1m drive", "Art. 6(1) 2Wed 16:30 +60", at="Sat 06:00"),
    # a day across Sunday midnight counts in either week, not in both
    day(TEN, at="Sun 18:00", **LONG_USED),
    day(TEN, "Art. 6(1) Sun 23:00 +60", at="Sun 12:30", **LONG_USED),
    day(TEN, at="Sun 12:31", **LONG_USED),
    day(f"2 x ({TEN}, 12h30 rest), {TEN}", "Art. 6(1) 2Wed 04:30 +60", at="Sun 18:00", **LONG_USED),
    day(f"2 x ({TEN}, 12h30 rest), {TEN}", at="Sun 18:00", long_days_used=1),
    day(TEN, duty_h=1, at="Mon 00:30", long_days_used=1),
    day(TEN, "Art. 6(1) Mon 11:00 +60", duty_h=1, at="Mon 00:30", **LONG_USED),
    day(TEN, "Art. 6(1) 2Mon 11:00 +60", duty_h=1, at="2Mon 00:30", **LONG_USED),
    day(f"{NINE}, 45m rest, 59m1s drive", at="Sun 12:31", **LONG_USED),
    day(f"1h drive, 336h rest, 3 x ({TEN}, 12h30 rest)", "Art. 6(1) 3Wed 17:30 +60"),
    # from the end of one rest to the end of the next, whatever the calendar
    day("4h30 drive, 9h rest, 4h30 drive, 45m rest, 1h1m drive"),
    day("4h30 drive, 8h59 rest, 4h30 drive, 45m rest, 1h1m drive",
        "Art. 8(2) Mon 21:00 +285", "Art. 6(1) Tue 01:44 +1"),
    day("2h1m drive", "Art. 6(1) Mon 08:00 +1", today_h=8, duty_h=9),
    day("1h drive", today_h=8, duty_h=9, **LONG_USED),
    day("1h1m drive", "Art. 6(1) Mon 07:00 +1", today_h=8, duty_h=9, **LONG_USED),
    day("30m drive", "Art. 6(1) Mon 06:00 +90", today_h=11, duty_h=12),
    # too much before the record begins, and a rest at once
    day("11h rest, 30m drive", today_h=11, duty_h=12),
    day("11h rest, 30m drive", today_h=9.5, duty_h=12, **LONG_USED),
    day("1m drive, 11h rest, 30m drive", "Art. 6(1) Mon 06:00 +61", today_h=11, duty_h=12),
    day("20h drive/50", "Art. 7 Mon 15:00 +330", "Art. 8(2) Mon 21:00 +300",
        "2002/15 Art. 5(1) Mon 18:00 +240", "2002/15 Art. 5(1) Tue 00:00 +45"),
    day("18h2m drive/50", "Art. 7 Mon 15:00 +271", "Art. 6(1) Tue 00:00 +1",
        "Art. 8(2) Mon 21:00 +182", "2002/15 Art. 5(1) Mon 18:00 +181",
        "2002/15 Art. 5(1) Tue 00:00 +45", **LONG_USED),
]  # fmt: skip

DAILY_REST = [
    day("13h available, 11h rest, 1m drive", **USED),
    day("13h1m available, 11h rest, 1m drive", "Art. 8(4) Mon 19:00 +1", **USED),
    day("13h available, 10h59 rest, 1m drive", "Art. 8(4) Mon 19:00 +1", **USED),
    day("13h1m available, 11h rest, 1m drive"),
    day("15h available, 9h rest, 1m drive"),
    day("15h1m available, 9h rest, 1m drive", "Art. 8(2) Mon 21:00 +1"),
    day("15h available, 8h59 rest, 1m drive", "Art. 8(2) Mon 21:00 +540"),
    day("30h available, 11h rest, 1m drive", "Art. 8(2) Mon 21:00 +900"),
    # of a rest only what lies within the 24 h counts
    day("15h available, 12h rest, 1m drive", "Art. 8(4) Mon 19:00 +120", **USED),
    # three reduced between two weekly rests
    day("3 x (15h available, 9h rest), 1m drive"),
    day("4 x (15h available, 9h rest), 1m drive", "Art. 8(4) Thu 19:00 +120"),
    day("13h available, 24h rest, 4 x (15h available, 9h rest), 1m drive",
        "Art. 8(4) Sat 08:00 +120", **USED),
    # a weekly rest before the record's first work gives all three back, and no more
    day("24h rest, 3 x (15h available, 9h rest), 1m drive", **USED),
    day("24h rest, 4 x (15h available, 9h rest), 1m drive", "Art. 8(4) Fri 19:00 +120", **USED),
    day("23h59 rest, 15h available, 9h rest, 1m drive", "Art. 8(4) Tue 18:59 +120", **USED),
    day("5 x (15h available, 9h rest), 1m drive", "Art. 8(4) Thu 19:00 +120",
        "Art. 8(4) Fri 19:00 +120"),
    day("15h available, 9h rest, 1m drive", reduced_rests_used=2),
    day("3 x (15h available, 9h rest), 13h available, 24h rest, 3 x (15h available, 9h rest), "
        "1m drive"),
    day("3 x (15h available, 9h rest), 13h available, 23h59 rest, 15h available, 9h rest, 1m drive",
        "Art. 8(4) Sat 07:59 +120"),
    # a rest of 9 h need not be a daily rest
    day("2h drive, 9h rest, 2h drive, 11h rest, 1m drive", **USED),
    # 3 and then 9
    day("4h drive, 3h rest, 4h drive, 45m rest, 3h15 available, 9h rest, 1m drive", **USED),
    day("4h drive, 2h59 rest, 4h drive, 45m rest, 3h16 available, 9h rest, 1m drive",
        "Art. 8(4) Mon 19:00 +120", **USED),
    day("4h drive, 3h rest, 4h drive, 45m rest, 3h15 available, 8h59 rest, 1m drive",
        "Art. 8(2) Mon 21:00 +540", **USED),
    day("4h drive, 3h rest, 4h drive, 45m rest, 3h16 available, 9h rest, 1m drive",
        "Art. 8(2) Mon 21:00 +1", **USED),
    # and not 9 and then 3
    day("4h drive, 9h rest, 4h drive, 4h available, 3h rest, 1m drive",
        "Art. 8(4) Mon 19:00 +120", **USED),
    # a first part serves one day
    day("4h drive, 3h rest, 8h available, 9h rest, 15h available, 9h rest, 1m drive",
        "Art. 8(4) Tue 19:00 +120", **USED),
    # rest before leaving, and rest that is not over yet
    day("24h rest, 15h available, 9h rest, 1m drive", **USED),
    day("23h59 rest, 15h available, 9h rest, 1m drive", "Art. 8(4) Tue 18:59 +120", **USED),
    day("5h rest, 13h available, 11h rest, 1m drive", **USED),
    day("5h rest, 13h available, 11h rest, 1m drive", "Art. 8(2) Mon 20:00 +240", duty_h=1, **USED),
    day("11h rest, 13h available, 11h rest, 1m drive", duty_h=13, **USED),
    day("3h available, 11h rest, 1m drive", duty_h=10, **USED),
    day("3h1m available, 11h rest, 1m drive", "Art. 8(4) Mon 09:00 +1", duty_h=10, **USED),
    day("15h available"),
    day("15h1m available", "Art. 8(2) Mon 21:00 +1"),
    day("13h1m available", "Art. 8(4) Mon 19:00 +1", **USED),
    day("24h rest"),
]  # fmt: skip

FERRIES = [
    # the four worked days: figures 1, 2, 7 and 8 of the Addendum
    day(f"{NINE}, 2h rest, 30m drive, 8h ferry, 30m drive, 2h rest, 4h30 drive", **LONG_USED,
        **USED),
    day("4h work, 1h rest, 20m drive, 2h ferry, 6h work, 7h ferry, 20m drive, 3h rest, 1m drive",
        **USED),
    day("4h30 work, 1h rest, 10m drive, 1h rest, 10m drive, 1h rest, 10m drive, 9h ferry, 1m drive",
        **USED),
    day("3h work, 1h rest, 10m drive, 2h ferry, 6h work, 2h rest, 10m drive, 7h ferry, 1m drive",
        **USED),
    # driving between the rests of a crossing is not driving of the day; other driving is
    day("4h30 drive, 1h rest, 20m drive, 2h ferry, 4h30 drive, 7h ferry, 20m drive, 3h rest, "
        "1m drive", **LONG_USED, **USED),
    day("4h30 drive, 1h rest, 20m drive, 2h ferry, 1m drive, 45m rest, 4h30 drive, 7h ferry, "
        "20m drive, 3h rest, 1m drive", "Art. 6(1) Mon 19:05 +1", **LONG_USED, **USED),
    day(f"{NINE}, 1h rest, 10m drive, 1h rest, 10m drive, 1h rest, 10m drive, 9h ferry, 1m drive",
        "Art. 6(1) Mon 16:45 +10", **LONG_USED),
    # more than an hour, more than twice, no ferry, less than 11 h
    day("4h work, 2h rest, 31m drive, 8h ferry, 30m drive, 2h rest, 2h drive",
        "Art. 8(2) Mon 21:00 +241"),
    day("4h work, 2h rest, 30m drive, 8h ferry, 30m drive, 2h rest, 2h drive"),
    day("4h work, 2h rest, 30m drive, 1h rest, 7h ferry, 30m drive, 2h rest, 2h drive"),
    day("4h work, 2h rest, 30m drive, 7h ferry, 1h rest, 30m drive, 2h rest, 2h drive"),
    day("4h work, 2h rest, 30m1s drive, 7h59m59s ferry, 30m drive, 2h rest, 2h drive",
        "Art. 8(2) Mon 21:00 +240"),
    day("4h work, 2h rest, 30m drive, 8h rest, 30m drive, 2h rest, 1m drive",
        "Art. 8(2) Mon 21:00 +121"),
    day("4h work, 1h rest, 10m drive, 1h rest, 10m drive, 8h ferry, 10m drive, 1h rest, 2h drive",
        "Art. 8(2) Mon 21:00 +150"),
    day("13h available, 1h rest, 10m drive, 8h ferry, 2h drive", "Art. 8(2) Mon 21:00 +550"),
    day("13h available, 1h rest, 10m drive, 8h ferry, 1m drive", "Art. 8(2) Mon 19:00 +11"),
    day("12h available, 1h rest, 10m drive, 9h59 ferry, 1m drive", **USED),
    # both parts of a split rest share the two interruptions and the hour
    day("4h work, 1h rest, 31m drive, 2h ferry, 6h work, 6h ferry, 30m drive, 3h rest, 2h drive",
        "Art. 8(2) Mon 21:00 +601", **USED),
    day("4h work, 1h rest, 30m drive, 2h ferry, 6h work, 6h ferry, 30m drive, 3h rest, 1m drive",
        **USED),
    day("4h work, 1h rest, 10m drive, 1h rest, 10m drive, 1h ferry, 6h work, 6h ferry, 10m drive, "
        "3h rest, 2h drive", "Art. 8(2) Mon 21:00 +570", **USED),
    # it counts in the week, and a late one is none
    day("1h drive, 2h rest, 30m drive, 8h ferry, 30m drive, 2h rest", "Art. 6(2) Mon 09:00 +60",
        week_h=55),
    day("14h available, 2h rest, 20m drive, 9h ferry, 1m drive", "Art. 8(2) Mon 19:00 +80"),
    # two drivers may be interrupted too
    day("12h available, 2h rest, 30m drive, 9h ferry, 1m drive", drivers=2),
    # a reduced weekly rest on a ferry
    day("1h drive, 12h rest, 30m drive, 12h ferry, 1m drive", since_weekly_h=143),
    day("1h drive, 6h rest, 10m drive, 6h rest, 10m drive, 6h ferry, 10m drive, 6h rest, 2h drive",
        "Art. 8(6) Mon 07:00 +1590", since_weekly_h=143),
    day("1h drive, 12h rest, 30m drive, 11h59 ferry, 2h drive", "Art. 8(6) Mon 07:00 +1589",
        since_weekly_h=143),
]  # fmt: skip

WEEKS = [
    day(NINE, week_h=47),
    day(f"{NINE}, 45m rest, 1m drive", "Art. 6(2) Mon 16:30 +1", week_h=47),
    day("1h drive", "Art. 6(2) Mon 06:00 +120", week_h=57),
    day(f"4 x ({NINE}, 14h15 rest), 2 x ({TEN}, 12h30 rest)"),
    # to Sunday 24:00 UTC
    day("4h drive", week_h=54, at="Sun 22:00"),
    day("4h drive", "Art. 6(2) Sun 23:59 +1", week_h=54 + 1 / 60, at="Sun 22:00"),
    day("2h drive, 45m rest, 2h drive", "Art. 6(2) Sun 23:59 +1", week_h=54 + 1 / 60,
        at="Sun 22:00"),
    day("4h drive/50", week_h=55, at="Sun 22:00"),
    day("4h drive/50", "Art. 6(2) Sun 23:58 +1", week_h=55 + 1 / 60, at="Sun 22:00"),
    # two weeks
    day(NINE, week_h=36, last_week_h=45),
    day(f"{NINE}, 45m rest, 1m drive", "Art. 6(3) Mon 16:30 +1", week_h=36, last_week_h=45),
    day("4h drive", week_h=50, last_week_h=38, at="Sun 22:00"),
    day("4h drive", "Art. 6(3) Sun 23:59 +1", week_h=50, last_week_h=38 + 1 / 60, at="Sun 22:00"),
    day(f"6 x ({NINE}, 14h15 rest), 30h45 rest, 4 x ({NINE}, 14h15 rest)"),
    day(f"6 x ({NINE}, 14h15 rest), 30h45 rest, 4 x ({NINE}, 14h15 rest), 1m drive",
        "Art. 6(3) 2Fri 12:45 +1"),
    # six times 24 h
    day(f"6 x ({NINE}, 14h15 rest)"),
    day(f"6 x ({NINE}, 14h15 rest), 1m drive", "Art. 8(6) Sun 06:00 +1"),
    day("1h drive", since_weekly_h=143),
    day("1h1m drive", "Art. 8(6) Mon 07:00 +1", since_weekly_h=143),
    day("1h drive, 24h rest, 1h drive", since_weekly_h=143),
    day("1h drive, 23h59 rest, 1m drive", "Art. 8(6) Mon 07:00 +1440", since_weekly_h=143),
    day("24h rest, 6 x (4h drive, 20h rest), 1m rest", at="Sun 06:00"),
    day("24h rest, 1h drive", since_weekly_h=144),
    day("1h1s drive", "Art. 8(6) Mon 07:00 +0.0166667", since_weekly_h=143),
    day("20h rest, 1h1m drive", "Art. 8(6) Tue 02:00 +61", since_weekly_h=124),
    day("23h rest, 6 x (4h drive, 20h rest)"),
    day("20h rest, 6 x (4h drive, 20h rest), 1m drive", "Art. 8(6) 2Mon 02:00 +1"),
    # two in two weeks, one of them regular
    day(f"2 x (5 x ({NINE}, 14h15 rest), 48h rest)", at="Mon 00:00"),
    day("2 x (6 x (4h drive, 20h rest), 24h rest), 4h drive", "Art. 8(6) 3Mon 00:00 +2700",
        at="Mon 00:00"),
    day("2 x (6 x (4h drive, 20h rest), 24h rest)", at="Mon 00:00"),
    day("6 x (4h drive, 20h rest), 24h rest, 6 x (4h drive, 20h rest), 25h rest, 4h drive",
        at="Mon 00:00"),
    day("6 x (4h drive, 20h rest), 25h rest, 6 x (4h drive, 20h rest), 23h rest, 4h drive",
        at="Mon 00:00"),
    day("6 x (4h drive, 20h rest), 24h rest, 6 x (4h drive, 20h rest), 24h rest, 4h drive",
        at="Mon 00:01"),
    day("2 x (6 x (4h drive, 20h rest), 24h rest), 4h drive", "Art. 8(6) 4Mon 00:00 +2700",
        at="2Mon 00:00"),
    day("6 x (4h drive, 20h rest), 25h rest, 5 x (4h drive, 20h rest), 43h rest, 4h drive",
        at="Mon 00:00"),
    day("1h drive, 700h rest, 1h drive", at="Mon 00:00"),
    day(f"10 x (5 x ({LIGHT}), 48h rest)", at="Tue 06:00"),
    # across Sunday midnight in either week; one that ends at midnight is not across
    day(f"1h drive, 45h rest, 3 x ({LIGHT}), 4h available, 50h rest, 7 x ({LIGHT}), "
        f"6h available, 45h rest, 6 x ({LIGHT})", "Art. 8(6) 2Sun 04:00 +1800", at="Mon 00:00"),
    day(f"1h drive, 45h rest, 3 x ({LIGHT}), 4h available, 46h rest, 7 x ({LIGHT}), "
        f"6h available, 45h rest, 6 x ({LIGHT})", "Art. 8(6) 2Sun 00:00 +1800",
        "Art. 8(6) 4Mon 00:00 +1440", at="Mon 00:00"),
    day(f"1h drive, 45h rest, 3 x ({LIGHT}), 4h available, 46h1s rest, 7 x ({LIGHT}), "
        f"6h available, 45h rest, 6 x ({LIGHT})", "Art. 8(6) 2Sun 00:00:01 +1800", at="Mon 00:00"),
    # one across Sunday midnight does not count twice, unless both weeks hold 45 h of it
    day(f"5 x ({LIGHT}), 3h available, 50h rest, 7 x ({LIGHT}), 1h drive",
        "Art. 8(6) 2Sun 05:00 +1500", "Art. 8(6) 3Mon 00:00 +1440", at="Mon 00:00"),
    day(f"7h rest, 6 x ({LIGHT}), 1h drive, 12h available, 50h rest, 5 x ({LIGHT}), 1h drive, "
        "2h available", "Art. 8(6) Sun 07:00 +780", "Art. 8(6) 3Mon 00:00 +1440", at="Mon 00:00"),
    day(f"5 x ({LIGHT}), 3h available, 213h rest, 1h drive", at="Mon 00:00"),
    # what a reduced one lacks, in one block before the end of the third week
    day(f"6 x ({LIGHT}), 24h1s rest, 4 x (5 x ({LIGHT}), 34h rest)", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 2 x (5 x ({LIGHT}), 34h rest), 5 x ({LIGHT}), 43h59m59s rest, "
        f"5 x ({LIGHT}), 34h rest", "Art. 8(6b) 5Mon 00:00 +600", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 5 x ({LIGHT}), 34h rest, 6 x ({LIGHT}), 24h rest, "
        f"5 x ({LIGHT}), 44h rest, 2 x (5 x ({LIGHT}), 34h rest), 5 x ({LIGHT})",
        "Art. 8(6b) 7Mon 00:00 +600", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 5 x ({LIGHT}), 34h rest, 6 x ({LIGHT}), 19h rest, "
        f"{LIGHT}, 8h rest, 4 x ({LIGHT}), 49h rest, 2 x (5 x ({LIGHT}), 34h rest), "
        f"5 x ({LIGHT})", at="Mon 00:00"),
    # a rest of 30 h need not be a weekly one, and then lacks nothing
    day(f"2 x ({LIGHT}), 19h rest, 3 x ({LIGHT}), 34h rest, 4 x (5 x ({LIGHT}), 34h rest)",
        at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 4 x (5 x ({LIGHT}), 34h rest)", "Art. 8(6b) 5Mon 00:00 +600",
        at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 3 x (5 x ({LIGHT}), 34h rest)", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 2 x (5 x ({LIGHT}), 34h rest), 5 x ({LIGHT}), 44h rest, "
        f"5 x ({LIGHT}), 34h rest", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 2 x (5 x ({LIGHT}), 34h rest), 5 x ({LIGHT}), 43h59 rest, "
        f"5 x ({LIGHT}), 34h rest", "Art. 8(6b) 5Mon 00:00 +600", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, 3 x (5 x ({LIGHT}), 34h rest), 4 x ({LIGHT}), 44h rest, "
        f"{LIGHT}, 34h rest", "Art. 8(6b) 5Mon 00:00 +600", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, {LIGHT}, 8h rest, 4 x ({LIGHT}), 34h rest, "
        f"3 x (5 x ({LIGHT}), 34h rest)", at="Mon 00:00"),
    day(f"6 x ({LIGHT}), 24h rest, {LIGHT}, 7h59 rest, 4 x ({LIGHT}), 34h rest, "
        f"3 x (5 x ({LIGHT}), 34h rest)", "Art. 8(6b) 5Mon 00:00 +600", at="Mon 00:00"),
]  # fmt: skip

WORK = [
    day("6h work"),
    day("6h1m work", "2002/15 Art. 5(1) Mon 12:00 +1", "2002/15 Art. 5(1) Mon 12:00 +30"),
    day("3h work, 15m rest, 3h work"),
    day("3h work, 15m rest, 3h1m work", "2002/15 Art. 5(1) Mon 12:15 +15"),
    day("3h work, 15m rest, 3h work, 15m rest, 3h work"),
    day("3h work, 15m rest, 3h work, 15m rest, 3h1m work", "2002/15 Art. 5(1) Mon 15:30 +15"),
    day("3h work, 15m rest, 3h work, 15m rest, 3h work, 15m rest, 1m work"),
    day("3h work, 14m rest, 3h work, 30m rest, 1h work"),
    day("3h work, 14m rest, 3h1m work, 30m rest, 1h work", "2002/15 Art. 5(1) Mon 12:14 +1"),
    day("3h work, 1h available, 3h1m work, 30m rest, 1m work", "2002/15 Art. 5(1) Mon 13:00 +1"),
    day("6h1m work, 15m rest, 6h1m work, 30m rest, 1m work",
        "2002/15 Art. 5(1) Mon 12:00 +1", "2002/15 Art. 5(1) Mon 18:16 +1"),
    day("3h work, 44m passenger, 3h1m work, 30m rest, 1m work",
        "2002/15 Art. 5(1) Mon 12:44 +1"),
    day("3h work, 45m passenger, 3h1m work, 30m rest, 1m work"),
    # a break lies between two pieces of work
    day("3h work, 15m rest, 3h30 work, 15m rest, 30m available, 11h rest, 1m drive",
        "2002/15 Art. 5(1) Mon 12:15 +15"),
    day("2h work, 4h1m drive", "2002/15 Art. 5(1) Mon 12:00 +1", "2002/15 Art. 5(1) Mon 12:00 +30"),
    day("2h work, 8h drive/50"),
    # what was driven before is all that was worked
    day("2h work", since_break_h=4, today_h=4, duty_h=4),
    day("2h1m work", "2002/15 Art. 5(1) Mon 08:00 +1", "2002/15 Art. 5(1) Mon 08:00 +30",
        since_break_h=4, today_h=4, duty_h=4),
    day("1h30 work, 15m rest, 1h work", since_break_h=4, today_h=4, duty_h=4,
        first_part_taken=True),
    day("1h30 work, 15m rest, 1h work", "2002/15 Art. 5(1) Mon 08:15 +15", since_break_h=4,
        today_h=4, duty_h=4),
    day("1h30 work", since_break_h=3, today_h=8, duty_h=10),
    day("3h work, 15m rest, 3h work, 1m available, 1h work", "2002/15 Art. 5(1) Mon 12:16 +15"),
    day("1m work, 1m available",
        "2002/15 Art. 5(1) Mon 06:00 +61", "2002/15 Art. 5(1) Mon 06:00 +30",
        "Art. 7 Mon 06:00 +150", since_break_h=7, today_h=7, duty_h=7),
    # each day for itself
    day("6h work, 11h rest, 6h work"),
    day("5h work, 11h rest, 1m drive", since_break_h=1, today_h=1, duty_h=1),
]  # fmt: skip

EU_DAYS = [*BREAKS, *TWO_DRIVERS, *DAILY_DRIVING, *DAILY_REST, *FERRIES, *WEEKS, *WORK]

US_DAY = "8h drive, 30m rest, 3h drive"
US_DAYS = [
    day(US_DAY),
    day("8h1m drive", "(a)(3)(ii) Mon 14:00 +1"),
    day("8h drive, 30m work, 3h drive"),
    day("8h drive, 15m work, 15m rest, 3h drive"),
    day("8h drive, 29m work, 1m drive", "(a)(3)(ii) Mon 14:29 +1"),
    day("8h1m drive, 30m rest, 1m drive", "(a)(3)(ii) Mon 14:00 +1"),
    day("1m drive", "(a)(3)(ii) Mon 06:00 +61", since_break_h=9, today_h=9, duty_h=9),
    day("4h drive, 30m rest, 7h drive", since_break_h=4, today_h=0, duty_h=2),
    day("8h drive, 29m59s work, 1m drive", "(a)(3)(ii) Mon 14:29:59 +1"),
    day("1h drive, 30m rest, 8h1s drive", "(a)(3)(ii) Mon 15:30 +0.0166667"),
    day("30m work, 1m drive", since_break_h=8, today_h=8, duty_h=8),
    day("29m59s work, 1m drive", "(a)(3)(ii) Mon 06:29:59 +1", since_break_h=8, today_h=8,
        duty_h=8),
    # 11 h of driving
    day("8h drive, 30m rest, 3h1m drive", "(a)(3)(i) Mon 17:30 +1"),
    day("8h drive, 30m rest, 4h drive, 1h rest, 1h drive", "(a)(3)(i) Mon 17:30 +120",
        "(a)(2) Mon 20:00 +30"),
    day("1h drive", today_h=10, duty_h=12),
    day("1h1m drive", "(a)(3)(i) Mon 07:00 +1", today_h=10, duty_h=12),
    day("14h drive/50"),
    day("30m drive", "(a)(3)(i) Mon 06:00 +90", today_h=12, duty_h=13),
    day(f"{US_DAY}, 10h rest, 8h drive, 30m rest, 3h1s drive", "(a)(3)(i) Tue 15:00 +0.0166667"),
    # the 14th hour
    day("3h work, 8h drive, 30m rest, 2h30 drive"),
    day("3h work, 8h drive, 30m rest, 2h31 drive", "(a)(2) Mon 20:00 +1"),
    day("4h available, 8h drive, 30m rest, 1h31 drive", "(a)(2) Mon 20:00 +1"),
    day(f"{US_DAY}, 5h work"),
    day("2m drive", "(a)(2) Mon 06:01 +1", duty_h=13 + 59 / 60),
    day("2h rest, 3h work, 8h drive, 30m rest, 2h30 drive"),
    day("15h work, 5m drive, 30m work, 5m drive", "(a)(2) Mon 21:00 +10"),
    # 10 h off
    day(f"{US_DAY}, 10h rest, {US_DAY}"),
    day(f"{US_DAY}, 9h59 rest, 8h drive", "(a)(3)(i) Tue 03:29 +480", "(a)(2) Tue 05:59 +330"),
    # 7 and 3, in either order, 8 and 2; one pair after the other
    day("4h drive, 3h rest, 7h drive, 7h rest, 4h drive"),
    day("4h drive, 3h rest, 7h drive, 7h rest, 4h1m drive", "(a)(3)(i) Tue 07:00 +1"),
    day("4h drive, 7h rest, 7h drive, 3h rest, 4h drive"),
    day("5h drive, 2h rest, 6h drive, 8h rest, 5h drive"),
    day("5h drive, 2h rest, 6h drive, 7h rest, 5h drive", "(a)(3)(i) Tue 02:00 +300",
        "(a)(2) Tue 03:00 +240"),
    day("5h drive, 1h59 rest, 6h drive, 8h1m rest, 1m drive", "(a)(3)(i) Tue 03:00 +1"),
    day("4h drive, 3h rest, 7h drive, 6h59 rest, 1m drive", "(a)(2) Tue 02:59 +1",
        "(a)(3)(i) Tue 02:59 +1"),
    day("4h drive, 5h rest, 7h drive, 6h59 rest, 1m drive", "(a)(3)(i) Tue 04:59 +1",
        "(a)(2) Tue 04:59 +1"),
    day("4h drive, 3h rest, 7h drive, 7h rest, 4h drive, 3h rest, 7h drive, 7h rest, 4h drive"),
    day("4h drive, 3h rest, 7h drive, 7h rest, 4h drive, 3h rest, 7h1m drive",
        "(a)(3)(i) Tue 17:00 +1"),
    # one of a pair may be left for a better one
    day("4h drive, 7h rest, 4h drive, 3h rest, 4h drive, 4h rest, 3h drive, 7h rest, 1m drive"),
    # neither of a pair counts in the 14 h
    day("5h work, 3h rest, 8h drive, 30m work, 30m drive, 7h rest, 1m drive"),
    day("5h work, 3h rest, 8h drive, 30m work, 31m drive, 7h rest, 1m drive",
        "(a)(2) Mon 23:00 +1"),
    day("5h work, 3h rest, 8h drive, 30m work, 30m drive, 10h rest, 1m drive"),
    day("5h work, 3h rest, 6h work, 7h rest, 8h drive"),
    day("5h work, 3h rest, 6h work, 7h rest, 8h drive, 30m work, 1m drive", "(a)(2) Tue 11:30 +1"),
    # 70 h in 8 days, 60 in 7, and 34 h off
    day("8h drive", week_h=62),
    day("8h drive, 30m rest, 1m drive", "(b)(2) Mon 14:30 +1", week_h=62),
    day("1h drive, 30m work, 1h drive", "(b)(2) Mon 07:30 +60", week_h=69),
    day("1h work, 1h work", week_h=70),
    day("1h drive, 34h rest, 8h drive", week_h=69),
    day("1h drive, 33h59 rest, 8h drive", "(b)(2) Tue 16:59 +480", week_h=69),
    day("1h1m drive, 34h rest, 1h drive", "(b)(2) Mon 07:00 +1", week_h=69),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 1m drive", "(b)(2) 2Mon 06:00 +1"),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 17h59 rest, 1m drive",
        "(b)(2) 2Mon 23:59 +1"),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 18h rest, 1m drive"),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 17h59 rest, 1m drive", clock_s=60),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 17h58 rest, 2m drive",
        "(b)(2) 2Mon 23:58 +1", clock_s=60),
    day("7 x (8h drive, 30m rest, 2h work, 13h30 rest), 17h59m30s rest, 1m drive", clock_s=60),
    day("7 x (23h59 rest, 1m available), 1m drive", "(b)(2) 3Mon 00:30 +1", week_h=70,
        at="2Mon 00:30", clock_s=3600),
    day("1m drive, 34h rest, 6 x (8h drive, 30m rest, 2h work, 13h30 rest), 1m drive",
        "(b)(1) Mon 06:00 +1", "(b)(1) 2Mon 16:01 +1", week_h=60, days=7),
    day("8h drive", week_h=52, days=7),
    day("8h drive, 30m rest, 1m drive", "(b)(1) Mon 14:30 +1", week_h=52, days=7),
    day("6 x (8h drive, 30m rest, 2h work, 13h30 rest), 18h rest, 1m drive", days=7),
    day("6 x (8h drive, 30m rest, 2h work, 13h30 rest), 17h59 rest, 1m drive",
        "(b)(1) Sun 23:59 +1", days=7),
]  # fmt: skip
