"""Objectives by name: what the list says of one is what it takes."""

from __future__ import annotations

from dataclasses import fields

import pytest

from platoon_osm.costs.paper import PaperCosts
from platoon_osm.costs.presets import DEFAULT_PRESET, PRESETS
from platoon_osm.errors import ScenarioError


def test_the_papers_parameters_are_all_listed():
    assert PRESETS.find("paper").parameters == tuple(item.name for item in fields(PaperCosts))


def test_a_preset_makes_its_objective():
    assert PRESETS.find(DEFAULT_PRESET).objective({}) == PaperCosts()
    assert PRESETS.find("paper").objective({"xi": 0.5}) == PaperCosts(xi=0.5)


@pytest.mark.parametrize(
    ("params", "says"),
    [({"tua": 1.0}, "did you mean 'tau'"), ({"zzz": 1.0}, "those of 'paper' are tau"),
     ({"tau": 2.0}, "tau = 2.0 must be a number in [0, 1]")],
)  # fmt: skip
def test_what_it_does_not_take_is_refused(params, says):
    with pytest.raises(ScenarioError) as refusal:
        PRESETS.find("paper").objective(params)
    assert says in str(refusal.value)
