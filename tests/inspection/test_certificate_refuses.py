"""Fleet files that somebody changed: refused, or what is believed of them is still true."""

from __future__ import annotations

import copy
import json

import numpy as np
import pytest
from certificates import certificate_of, drawn_shares, file_with_plan, slow_bound
from exhaustive import instance_of, optimum, random_instance
from soak import chosen, soaked

from platoon_osm.cli import main
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.inspection.certificate.belief import certified_with_plan
from platoon_osm.inspection.certificate.faults import FaultError
from platoon_osm.inspection.certificate.told import read_told, told_of

LANES = ("tail", "head", "drive", "alone", "member", "extra", "lane_kind")
TRUCKS = ("origin", "destination", "earliest", "latest_departure", "latest", "kind")


def written(seed, **options):
    """Return an instance and a file that proves what can be proved of its best plan."""
    instance = random_instance(seed, **options)
    schedules = optimum(instance).schedules
    shares = drawn_shares(instance, np.random.default_rng(seed))
    bound = slow_bound(instance, shares)
    certificate = certificate_of(instance, schedules, shares, bound)
    return instance, file_with_plan(certificate, instance, schedules)


def lists_in(certificate):
    """Yield all lists of numbers, with what they are called."""
    for name in (*LANES, *TRUCKS):
        yield name, certificate[name]
    for part in ("shares", "schedules", "lane_edges"):
        for name, own in certificate[part].items():
            yield f"{part}.{name}", own
    for k, own in enumerate(certificate["routes"]):
        yield f"routes.{k}", own


def changed(file, rng):
    """Return a file with one small change, and what was changed."""
    other = copy.deepcopy(file)
    certificate = other["certificate"]
    kind = rng.integers(10)
    if kind < 6:
        some = [item for item in lists_in(certificate) if item[1]]
        name, column = some[rng.integers(len(some))]
        column[rng.integers(len(column))] += int(rng.choice([-7, -2, -1, 1, 2, 7]))
        return other, name
    if kind == 6:
        name = str(rng.choice(["alone", "cost", "bound"]))
        certificate["claims"][name] += int(rng.choice([-1, 1, 50]))
        return other, f"claims.{name}"
    if kind == 7:
        name = str(rng.choice(["largest", "waiting", "rounds", "nodes"]))
        certificate[name] += int(rng.choice([-1, 1, 2]))
        return other, name
    if kind == 8:
        name = str(rng.choice(["saving", "bound", "alone_cost"]))
        other["plan"]["fleet"][name] += float(rng.choice([-0.5, 0.5]))
        return other, f"plan.{name}"
    stretch = other["plan"]["stretches"][rng.integers(len(other["plan"]["stretches"]))]
    if rng.random() < 0.5:
        stretch["edges"][0] += 1
        return other, "plan.edges"
    times = other["plan"]["timetable"]["vehicles"]
    own = times[rng.integers(len(times))]["legs"]
    own[rng.integers(len(own))][0] += float(rng.choice([-0.5, 0.25]))
    return other, "plan.legs"


def is_true(file, belief):
    """Whether what is believed of a file is so, by enumeration of what the file describes."""
    told = file["certificate"]
    instance = instance_of(
        {name: told[name] for name in LANES}, {name: told[name] for name in TRUCKS},
        nodes=told["nodes"], given=False, largest=told["largest"], waiting=told["waiting"],
    )  # fmt: skip
    only = None
    if told["given"]:
        only = {(k, lane) for k, route in enumerate(told["routes"]) for lane in route}
    return belief.least <= optimum(instance, only=only).cost <= belief.cost


@soaked
@pytest.mark.parametrize("seed", chosen(range(24), range(400)))
def test_a_change_is_refused_or_leaves_what_is_true(seed):
    file = written(seed, trucks=2 + seed % 2, waiting=None, slack=3)[1]
    certified_with_plan(told_of(file))
    rng = np.random.default_rng(seed)
    refused = 0
    for _ in range(12):
        other, what = changed(file, rng)
        try:
            belief, plan = certified_with_plan(told_of(other))
        except PlatoonError:
            refused += 1
            continue
        assert is_true(other, belief), what
        assert plan.fleet.saving <= float(belief.saving) + 0.5
        assert plan.fleet.bound >= float(belief.bound) - 0.5
    assert refused >= 4


def put(path, value):
    """Return what writes a value somewhere in a file; KeyError removes what is there."""

    def write(file):
        part = file
        for step in path[:-1]:
            part = part[step]
        if value is KeyError:
            del part[path[-1]]
        else:
            part[path[-1]] = value

    return write


C = "certificate"
BROKEN = [
    (put(["format"], "a plan"), 'its "format" must be'),
    (put(["version"], 2), "of version 2"),
    (put([C], []), "certificate is a list"),
    (put([C, "tick_s"], 0), "tick_s is 0"),
    (put([C, "tick_s"], None), "tick_s is None"),
    (put([C, "grain"], 0.01), "grain is 0.01"),
    (put([C, "grain"], "much"), "grain is 'much'"),
    (put([C, "nodes"], True), "nodes is a bool"),
    (put([C, "tail"], KeyError), "tail is missing"),
    (put([C, "tail"], "0123"), "tail is a str"),
    (put([C, "tail", 0], 0.0), "tail is a list"),
    (put([C, "tail", 0], True), "tail is a list"),
    (put([C, "head", 0], 10**30), "head holds 1000"),
    (put([C, "head", 0], -1), "head holds -1"),
    (put([C, "head"], [0]), "head has 1 entries"),
    (put([C, "drive", 0], 0), "drive holds 0"),
    (put([C, "drive", 0], 2**50), "above 1125899906842624"),
    (put([C, "extra", 0], 10**6), "costs more than driving alone"),
    (put([C, "origin"], []), "names no truck"),
    (put([C, "vehicles"], ["A"]), "names of all"),
    (put([C, "vehicles", 0], "truck 1"), "have one name"),
    (put([C, "largest"], 1), "largest is 1"),
    (put([C, "given"], 0), "given is a int"),
    (put([C, "waiting"], -1), "waiting is a int -1"),
    (put([C, "waiting"], 2**50), "waiting all the time"),
    (put([C, "rounds"], 10**9), "rounds is a int"),
    (put([C, "routes"], None), "routes must be"),
    (put([C, "routes", 0], [10**6]), "route 0 holds 1000000"),
    (put([C, "shares", "lane_first", 0], 1), "lane_first must rise"),
    (put([C, "shares", "starts", 0], 2**40), "must rise"),
    (put([C, "shares", "truck", 0], -1), "truck holds -1"),
    (put([C, "shares", "share", 0], 1.5), "share is a list"),
    (put([C, "shares", "first_share"], [0]), "first_share has 1 entries"),
    (put([C, "schedules", "first", -1], 0), "must rise"),
    (put([C, "schedules", "depart"], [0]), "depart has 1 entries"),
    (put([C, "lane_edges"], KeyError), "lane_edges is missing"),
    (put([C, "claims", "bound"], None), "bound is a null"),
    (put(["plan"], KeyError), "plan is missing"),
    (put(["plan", "ways"], KeyError), "plan"),
    (put(["plan", "fleet"], None), "says nothing of its fleet"),
]


@pytest.fixture(scope="module")
def true_file():
    return written(3, trucks=3, given=False, largest=0, kinds=1)[1]


@pytest.mark.parametrize(("write", "said"), BROKEN)
def test_what_says_nothing_is_an_error_of_one_line(true_file, write, said):
    other = copy.deepcopy(true_file)
    write(other)
    with pytest.raises(ScenarioError) as caught:
        certified_with_plan(told_of(other))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def raised_share(file):
    """Raise a share that meets others beyond what its company costs."""
    shares = file[C]["shares"]
    shares["share"] = [one + 10**6 for one in shares["share"]]


def better_bound(file):
    file[C]["claims"]["bound"] += 1


def moved_instant(file):
    file[C]["schedules"]["depart"][0] -= 100


def swapped_lane(file):
    lanes = file[C]["schedules"]["lane"]
    lanes[0] = (lanes[0] + 1) % len(file[C]["tail"])


def tighter_window(file):
    file[C]["earliest"][0] += 1


def other_company(file):
    stretches = file["plan"]["stretches"]
    one = next(s for s in stretches if len(s["vehicles"]) > 1)
    alone = {**one, "vehicles": one["vehicles"][:1], "shares": one["shares"][:1]}
    one["vehicles"], one["shares"] = one["vehicles"][1:], one["shares"][1:]
    k = alone["vehicles"][0]
    at = next(i for i, s in enumerate(stretches) if s is one)
    ways = file["plan"]["ways"]
    ways[k] = [len(stretches) if number == at else number for number in ways[k]]
    stretches.append(alone)


@pytest.mark.parametrize(
    "change",
    [raised_share, better_bound, moved_instant, swapped_lane, tighter_window, other_company],
)
def test_what_is_not_so_is_refused(change):
    seed = next(s for s in range(50) if saves(s))
    file = written(seed, trucks=3, given=False, largest=0, departures=False)[1]
    certified_with_plan(told_of(file))
    change(file)
    with pytest.raises(FaultError):
        certified_with_plan(told_of(file))


def saves(seed):
    instance = random_instance(seed, trucks=3, given=False, largest=0, departures=False)
    return optimum(instance).cost < instance.alone_cost.sum()


def test_files_that_cannot_be_read(tmp_path):
    path = tmp_path / "fleet.json"
    with pytest.raises(ScenarioError, match="cannot be read"):
        read_told(path)
    for text in ("", "[", "[[" * 10_000, "\xff"):
        path.write_text(text)
        with pytest.raises(ScenarioError, match="is no JSON file"):
            read_told(path)
    for text in ("3", "{}", "[]", "null"):
        path.write_text(text)
        with pytest.raises(ScenarioError, match="is no fleet file"):
            read_told(path)


def test_the_command_tells_what_it_believes_and_what_it_refuses(tmp_path, capsys, true_file):
    path = tmp_path / "fleet.json"
    path.write_text(json.dumps(true_file))
    assert main(["certify", str(path)]) == 0
    said = capsys.readouterr().out
    assert said.startswith("believed, of 3 trucks: ")
    assert "at most" in said
    assert "proved for: any route in time" in said
    assert "exact model" not in said
    told = copy.deepcopy(true_file)
    told["plan"]["fleet"]["exact_bound"] = told["plan"]["fleet"]["bound"]
    path.write_text(json.dumps(told))
    assert main(["certify", str(path)]) == 0
    assert "not looked at: by the exact model's solver" in capsys.readouterr().out
    other = copy.deepcopy(true_file)
    better_bound(other)
    path.write_text(json.dumps(other))
    assert main(["certify", str(path)]) == 1
    told = capsys.readouterr()
    assert not told.out
    assert told.err.count("\n") == 1
    assert "refused: claims a figure of" in told.err
    path.write_text("{}")
    assert main(["certify", str(path)]) == 2
