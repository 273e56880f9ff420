"""Each thing that a fleet file could get wrong, by itself, and what is said of it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from certificates import (
    certificate_of,
    drawn_shares,
    empty_shares,
    file_of,
    file_with_plan,
    slow_bound,
)
from exhaustive import cost_of, instance_of, optimum, random_instance

from platoon_osm.errors import PlatoonError
from platoon_osm.inspection.certificate.belief import certified, certified_with_plan
from platoon_osm.inspection.certificate.faults import FaultError
from platoon_osm.inspection.certificate.told import told_of

ROADS = {
    "tail": [0, 1, 0, 0, 0], "head": [1, 2, 2, 1, 1], "drive": [2, 2, 5, 2, 2],
    "alone": [20, 20, 45, 20, 21], "member": [12, 12, 30, 12, 13], "extra": [5, 8, 15, 8, 8],
    "lane_kind": [0, 0, 0, 1, 0],
}  # fmt: skip
# Lane 0 and lane 1 in a row, lane 2 beside them, lane 3 for vehicles of another kind, and lane 4
# beside lane 0.


def trucks(count):
    return {
        "origin": [0] * count, "destination": [2] * count, "earliest": [0] * count,
        "latest_departure": [3] * count, "latest": [9] * count, "kind": [0] * count,
    }  # fmt: skip


def written(count=2, at=1, **options):
    """Return a file of some trucks that drive lanes 0 and 1 together."""
    instance = instance_of(ROADS, trucks(count), nodes=3, **options)
    schedules = (((0, at), (1, at + 2)),) * count
    shares = empty_shares(instance)
    certificate = certificate_of(instance, schedules, shares, slow_bound(instance, shares))
    return instance, certificate, file_with_plan(certificate, instance, schedules)


def schedule(index, lane=None, depart=None):
    def change(certificate):
        own = certificate["schedules"]
        if lane is not None:
            own["lane"][index] = lane
        if depart is not None:
            own["depart"][index] = depart
        # No claim of cost: the schedule itself is to be refused.
        certificate["claims"]["cost"] = 10**6

    return change


def value(name, index, number):
    def change(certificate):
        certificate[name][index] = number

    return change


def route(number, lanes):
    def change(certificate):
        certificate["routes"][number] = lanes

    return change


def claim(name, number):
    def change(certificate):
        certificate["claims"][name] += number

    return change


FAULTS = [
    (schedule(0, depart=-1), "truck 0' leaves before it may"),
    (schedule(0, depart=4), "truck 0' leaves after it may"),
    (schedule(3, depart=8), "truck 1' arrives after it may"),
    (schedule(1, depart=2), "truck 0' enters a lane before it is there"),
    (schedule(1, lane=0), "truck 0' ends elsewhere on its schedule"),
    (schedule(0, lane=1), "truck 0' starts elsewhere on its schedule"),
    (schedule(0, lane=3), "truck 0' is on a lane of another kind on its schedule"),
    (schedule(0, lane=2), "truck 0' jumps on its schedule"),
    (route(1, []), "truck 1' goes nowhere; its way alone has no lanes"),
    (route(1, [3, 1]), "truck 1' is on a lane of another kind on its way alone"),
    (value("latest", 1, 3), "truck 1' is late even alone"),
    (value("latest_departure", 1, -1), "truck 1' must leave before it may"),
    (claim("alone", 1), "claims a figure of 81 grains for alone; it is 80"),
    (claim("alone", -1), "claims a figure of 79 grains for alone; it is 80"),
    (claim("cost", -1), "claims a figure of 60 grains for cost; it is 61"),
    (claim("bound", 1000), "grains for bound; it is"),
]


@pytest.mark.parametrize(("change", "said"), FAULTS)
def test_each_fault_is_told(change, said):
    certificate = written()[1]
    certified(told_of(file_of(certificate)))
    change(certificate)
    with pytest.raises(FaultError) as caught:
        certified(told_of(file_of(certificate)))
    assert said in str(caught.value)


@pytest.mark.parametrize("lanes", [[2], [4, 1]])
def test_a_given_route_is_kept(lanes):
    certificate = written(given=True)[1]
    certified(told_of(file_of(certificate)))
    own = certificate["schedules"]
    own["first"], own["lane"] = [0, 2, 2 + len(lanes)], [0, 1, *lanes]
    own["depart"] = [1, 3, 1, 3][: 2 + len(lanes)]
    certificate["claims"]["cost"] = 10**6
    with pytest.raises(FaultError, match="truck 1' leaves its given route"):
        certified(told_of(file_of(certificate)))
    certificate["given"] = False
    certified(told_of(file_of(certificate)))


@pytest.mark.parametrize("largest", [0, 2, 3])
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7])
def test_companies_cost_what_they_do(count, largest):
    instance, certificate, file = written(count, largest=largest)
    schedules = (((0, 1), (1, 3)),) * count
    belief = certified_with_plan(told_of(file))[0]
    assert belief.cost == cost_of(instance, schedules)
    certificate["claims"]["cost"] -= 1
    with pytest.raises(FaultError, match="for cost"):
        certified(told_of(file_of(certificate)))


@pytest.mark.parametrize("seed", range(40))
def test_shares_are_valid_if_no_company_pays_more_than_it_costs(seed):
    rng = np.random.default_rng(seed)
    instance = random_instance(seed, trucks=4, leader=bool(seed % 2))
    shares = drawn_shares(instance, rng)
    for _ in range(4):
        if not shares["share"]:
            return
        certificate = certificate_of(instance, optimum(instance).schedules, shares)
        try:
            certified(told_of(file_of(certificate)))
            believed = True
        except FaultError:
            believed = False
        assert believed == valid_by_trying(instance, shares)
        place = int(rng.integers(len(shares["share"])))
        shares["share"][place] += int(rng.integers(-2, 4))


def valid_by_trying(instance, shares):
    """Whether no 2 to `largest` trucks of a bucket, one without shares among them, pay too much."""
    at: dict[tuple[int, int], list[int]] = {}
    for row, lane in enumerate(shares["lane"]):
        first, last = shares["first_share"][row], shares["first_share"][row + 1]
        for i in range(last - first):
            key = lane, shares["first_bucket"][row] + i
            at.setdefault(key, []).append(shares["share"][first + i])
    for (lane, _), own in at.items():
        extra, leader = int(instance.extra[lane]), int(instance.leader_saves[lane])
        all_of_them = [*own, -leader]
        most = instance.largest or len(all_of_them)
        sizes = range(2, min(most, len(all_of_them)) + 1)
        companies = itertools.chain.from_iterable(
            itertools.combinations(all_of_them, size) for size in sizes
        )
        if any(sum(company) > extra for company in companies):
            return False
    return True


def shifted_buckets(shares):
    shares["first_bucket"][0] += 1


def too_many(shares):
    shares["first_share"] = [0, *(one + 1 for one in shares["first_share"][1:])]
    shares["share"] = [0, *shares["share"]]


def of_nobody(shares):
    shares["lane"][0] = 3


def below_members(shares):
    shares["share"][0] = -(10**6)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (shifted_buckets, "not listed for the buckets of its window"),
        (too_many, "not listed for the buckets of its window"),
        (of_nobody, "which it has no use for"),
        (below_members, "is below what a member pays"),
    ],
)
def test_shares_belong_to_pairs_and_their_buckets(change, said):
    instance, certificate, _ = written()
    shares = {
        "lane_first": [0, 1, 2, 2, 2, 2], "starts": [0, 0], "truck": [0, 1], "lane": [0, 0],
        "first_bucket": [0, 0], "first_share": [0, 1, 2], "share": [2, 3],
    }  # fmt: skip
    certificate["shares"] = shares
    certified(told_of(file_of(certificate)))
    change(shares)
    with pytest.raises(FaultError) as caught:
        certified(told_of(file_of(certificate)))
    assert said in str(caught.value)
    assert instance.lanes == 5


def planned(path, number):
    def change(plan):
        part = plan
        for step in path[:-1]:
            part = part[step]
        part[path[-1]] = number(part[path[-1]])

    return change


def window(name, sign):
    return planned(["timetable", "vehicles", 1, name], lambda at: at + sign)


BESIDE = [
    (planned(["trips", 0, "vehicle"], lambda _: "other"), "plan"),
    (planned(["timetable"], lambda _: None), "has no timetable"),
    (planned(["stretches", 0, "edges"], lambda _: [2]), "drive other roads on its way"),
    (planned(["trips", 1, "alone", "edges"], lambda _: [2]), "other roads on its way alone"),
    (window("earliest_departure_s", -1.0), "tighter than asked"),
    (window("latest_departure_s", 1.0), "tighter than asked"),
    (window("latest_arrival_s", 1.0), "tighter than asked"),
    (planned(["fleet", "alone_cost"], lambda cost: cost + 1), "another cost of driving alone"),
    (planned(["fleet", "saving"], lambda saving: saving + 0.1), "claims to save more"),
    (planned(["fleet", "bound"], lambda bound: bound - 0.1), "a bound that is not proved"),
    (planned(["fleet", "max_platoon"], lambda _: 3), "other platoons or routes"),
    (planned(["fleet", "routes"], lambda _: "given"), "other platoons or routes"),
]


@pytest.mark.parametrize(("change", "said"), BESIDE)
def test_the_plan_beside_is_the_one_that_is_proved(change, said):
    file = written()[2]
    certified_with_plan(told_of(file))
    change(file["plan"])
    with pytest.raises(PlatoonError) as caught:
        certified_with_plan(told_of(file))
    assert said in str(caught.value)


def test_a_clock_that_starts_later_is_no_other_time():
    file = written(3)[2]
    for times in file["plan"]["timetable"]["vehicles"]:
        times["departure_s"] -= 1.0
        times["legs"] = [[begin - 1.0, end - 1.0] for begin, end in times["legs"]]
        for name in ("earliest_departure_s", "latest_departure_s", "latest_arrival_s"):
            times[name] -= 1.0
    certified_with_plan(told_of(file))
    own = file["plan"]["timetable"]["vehicles"][0]
    own["departure_s"] = own["legs"][0][0] = own["legs"][0][0] - 0.1
    with pytest.raises(FaultError, match="other times"):
        certified_with_plan(told_of(file))


def example(shares):
    """Return what is believed of the example of docs/certificate.md, with some shares."""
    roads = {name: column[:3] for name, column in ROADS.items()}
    instance = instance_of(roads, trucks(2), nodes=3)
    told = {
        "lane_first": [0, 1, 2, 3], "starts": [0, 0, 0], "truck": [0, 1, 0, 1, 0, 1],
        "lane": [0, 0, 1, 1, 2, 2], "first_bucket": [0, 0, 1, 1, 2, 2],
        "first_share": list(range(7)), "share": shares,
    }  # fmt: skip
    schedules = (((0, 0), (1, 2)),) * 2
    return certified(told_of(file_of(certificate_of(instance, schedules, told))))


def test_the_example_that_is_told_by_hand():
    belief = example([2, 3, 4, 4, 7, 8])
    assert (belief.alone, belief.cost, belief.least) == (80, 61, 61)
    for place in range(6):
        shares = [2, 3, 4, 4, 7, 8]
        shares[place] += 1
        with pytest.raises(FaultError, match="than it costs"):
            example(shares)
