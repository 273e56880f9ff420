"""The page on tags says what the code's tables say."""

import re

from places import ROOT

from platoon_osm.sources.restricting_tags import NOT_JUDGED
from platoon_osm.sources.way_sides import ONLY_SOME
from platoon_osm.vehicles.access import BARRIERS, CHAIN, HAZARDOUS, RESERVED, VALUES, Way
from platoon_osm.vehicles.limits import LIMITS

PAGE = (ROOT / "docs" / "tags.md").read_text("utf-8")
QUOTED = set(re.findall(r"`([^`]+)`", PAGE))


def test_every_key_that_is_judged_stands_there():
    wanted = {*CHAIN, *HAZARDOUS, *RESERVED, *LIMITS, "trailer", "oneway", *ONLY_SOME[:3]}
    assert wanted <= QUOTED
    assert NOT_JUDGED - {"maxdraught", "maxspan", "maxheight:legal"} <= QUOTED


def test_values_stand_in_the_row_of_what_they_mean():
    rows = {
        Way.OPEN: "everybody", Way.ENDS: "who starts or ends a trip there; never transit",
        Way.CLOSED: "nobody we plan for",
    }  # fmt: skip
    for way, told in rows.items():
        (row,) = re.findall(rf"^\| (`.*) \| {re.escape(told)} \|$", PAGE, re.M)
        values = re.findall(r"`([^`]+)`", row)
        assert values
        assert {VALUES[value] for value in values} == {way}


def test_barriers_are_what_the_page_says():
    text = PAGE[PAGE.index("## Barriers") :]
    opened, closed = text[: text.index("are open")], text[text.index("are open") :]
    for part, way in ((opened, Way.OPEN), (closed, Way.CLOSED)):
        named = [one for one in re.findall(r"`([a-z_]+)`", part) if one in BARRIERS]
        assert {BARRIERS[one] for one in named} == {way}
