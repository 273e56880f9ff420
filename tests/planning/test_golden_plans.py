"""Plans on the bundled map of Italy that can be checked with the tables of km posts and a pencil.

Every distance is a sum of differences of posts in maps/italy/*.csv; ramps between motorways are
in no table, so each interchange passed may add up to 2.5 km (maps/README.md).
"""

import csv
from dataclasses import replace
from pathlib import Path

import pytest
from bundled import italy as italy_map
from places import ROOT

import platoon_osm as po
from platoon_osm.planning.scenario import read_scenario

SCENARIOS = Path(po.__file__).parent / "scenarios"
PER_KM_ALONE, PER_KM_TOGETHER = 37 / 12, 2.1476  # eq. 11, and eq. 12 at (1, 0.18)


@pytest.fixture(scope="module")
def net():
    return italy_map()


@pytest.fixture(scope="module")
def plans(net):
    """The bundled scenarios by the paper's rule, that the longest route leads."""
    rule = {"master": "longest", "company": "master"}
    found = {}
    for case in "abcd":
        asked = read_scenario(SCENARIOS / f"po-valley-{case}.toml")
        found[case] = replace(asked, options={**asked.options, **rule}).plan(net)
    return found


def by_name(plan):
    return {vehicle.vehicle: vehicle for vehicle in plan.vehicles}


def km(ref, start, end):
    """Distance along a motorway between two rows of its table."""
    with (ROOT / "maps" / "italy" / f"{ref}.csv").open(encoding="utf-8", newline="") as handle:
        posts = {row["name"]: float(row["km"]) for row in csv.DictReader(handle) if row["name"]}
    return abs(posts[end] - posts[start])


def about(distance_km, interchanges):
    """The table's distance within 1 %, and what ramps may add."""
    ramps = 2.5 * interchanges / 2
    return pytest.approx(distance_km + ramps, abs=ramps + 0.01 * distance_km)


TORINO, TRIESTE = "Torino Corso Giulio Cesare", "RA13/RA14 Opicina"


def a4_without_mestre():
    """The A4 from end to end but for the arc round Mestre, km 375.8 to 406.0."""
    return (
        km("A4", TORINO, "A4/A57 Dolo")
        + km("A4", "A4/A57 Quarto d'Altino", "A4/RA13 Sistiana")
    )  # fmt: skip


def mestre():
    """Straight through Mestre by the A57: 26.7 km instead of the arc's 30.2."""
    return km("A57", "A4/A57 Dolo", "A4/A57 Quarto d'Altino")


def sistiana_to_trieste():
    """The RA13 up to the junction nearest to the city."""
    return km("RA13", "A4/RA13 Sistiana", TRIESTE)


@pytest.mark.parametrize("case", ["a", "b", "c", "d"])
def test_a_alone_drives_a4_a57_a4_and_ra13(plans, net, case):
    alone = by_name(plans[case])["A"].alone
    whole = a4_without_mestre() + mestre() + sistiana_to_trieste()
    assert alone.length_m / 1000 == about(whole, 3)
    driven = {"A4": 0.0, "A57": 0.0, "RA13": 0.0}
    for edge in alone.edges:
        road = net.edge_ref(edge).replace(" ", "")
        if road in driven:
            driven[road] += net.length_m[edge] / 1000
    assert driven["A4"] == pytest.approx(a4_without_mestre(), rel=0.01)
    assert driven["A57"] == pytest.approx(mestre(), abs=1.5)
    assert driven["RA13"] == pytest.approx(sistiana_to_trieste(), abs=1.5)
    assert alone.cost / 1000 == pytest.approx(alone.length_m / 1000 * PER_KM_ALONE)


@pytest.mark.parametrize("case", ["a", "b", "c"])
def test_a_is_master_and_everyone_has_company(plans, case):
    roles = {name: vehicle.role for name, vehicle in by_name(plans[case]).items()}
    assert roles == {"A": "master", "B": "member", "C": "member"}
    assert plans[case].joint_cost < plans[case].solo_cost
    longest = max(plans[case].vehicles, key=lambda vehicle: vehicle.alone.length_m)
    assert longest.vehicle == "A"


def genova_to_rho():
    """Up the A7 to the western ring of Milano, and along it to the A4."""
    return km("A7", "Genova Ovest", "A7/A50 Milano") + km("A50", "A7/A50 Milano", "A4/A50 Rho")


def chiasso_to_milano():
    """A9 and A8 into Milano."""
    return km("A9", "Chiasso - Brogeda", "A8/A9 Lainate") + km(
        "A8", "A8/A9 Lainate", "A4/A8 Milano"
    )


def test_case_a_b_and_c_join_at_milano_and_stay(plans):
    vehicles = by_name(plans["a"])
    b, c = vehicles["B"], vehicles["C"]
    assert (b.merge.name, b.separation.name) == ("A4/A50 Rho", "San Donà di Piave - Noventa")
    assert b.merge.km == about(genova_to_rho(), 2)
    arc = km("A4", "A4/A57 Dolo", "A4/A57 Quarto d'Altino")
    together = km("A4", "A4/A50 Rho", "San Donà di Piave - Noventa") - arc + mestre()
    assert b.platoon_m / 1000 == about(together, 2)
    assert (c.merge.name, c.separation.name) == ("A4/A8 Milano", TRIESTE)
    assert c.merge.km == about(chiasso_to_milano(), 2)
    with_a = (
        a4_without_mestre() + mestre() + sistiana_to_trieste() - km("A4", TORINO, "A4/A8 Milano")
    )
    assert c.platoon_m / 1000 == about(with_a, 3)
    # C stays with A to the end, B leaves within a ramp's length of its destination.
    assert c.legs[-1].role == "platoon"
    assert c.separation.km == pytest.approx(c.length_m / 1000)
    assert b.length_m / 1000 - b.separation.km < 2.5
    # What C pays: km alone at 3.083 and km together at 2.148.
    paid = (c.length_m - c.platoon_m) * PER_KM_ALONE + c.platoon_m * PER_KM_TOGETHER
    assert c.joint_cost == pytest.approx(paid)


def test_case_a_does_not_apply_to_one_who_ends_off_the_route(net, plans):
    trips = [
        po.Trip("A", net.locate("Torino"), net.locate("Trieste")),
        po.Trip("B", net.locate("Genova"), net.locate("Belluno")),
    ]
    vehicle = by_name(po.plan_joint(net, po.paper_weights(net), trips, "A", master="A"))["B"]
    assert vehicle.reason == ("case A does not apply: its destination is not on the route of A")


def test_case_b_all_start_in_torino(plans):
    vehicles = by_name(plans["b"])
    b, c = vehicles["B"], vehicles["C"]
    assert b.merge.name == c.merge.name == TORINO
    assert b.merge.km == c.merge.km == 0
    # C turns north at Verona, B at Mestre, where the A27 to Belluno begins on the A57.
    assert c.separation.name == "A4/A22 Verona"
    assert c.separation.km == about(km("A4", TORINO, "A4/A22 Verona"), 1)
    assert c.length_m / 1000 == about(
        km("A4", TORINO, "A4/A22 Verona") + km("A22", "A4/A22 Verona", "Brennero"), 1
    )
    assert b.separation.name == "A27/A57 Mestre"
    to_mestre = km("A4", TORINO, "A4/A57 Dolo") + km("A57", "A4/A57 Dolo", "A27/A57 Mestre")
    assert b.separation.km == about(to_mestre, 2)


def test_case_c_merge_and_separate(plans):
    vehicles = by_name(plans["c"])
    b, c = vehicles["B"], vehicles["C"]
    assert b.merge.name == "A4/A50 Rho"
    assert b.merge.km == about(genova_to_rho(), 2)
    rho_to_dolo = km("A4", "A4/A50 Rho", "A4/A57 Dolo")
    assert b.separation.name == "A27/A57 Mestre"
    assert b.platoon_m / 1000 == about(rho_to_dolo + km("A57", "A4/A57 Dolo", "A27/A57 Mestre"), 2)
    assert (c.merge.name, c.separation.name) == ("A4/A8 Milano", "A4/A22 Verona")
    assert c.merge.km == about(chiasso_to_milano(), 2)
    assert c.platoon_m / 1000 == about(km("A4", "A4/A8 Milano", "A4/A22 Verona"), 1)
    # A has B alone first, then both, then B alone again, and drives the rest by itself.
    company = [leg.partners for leg in vehicles["A"].legs]
    assert company == [(), ("B",), ("B", "C"), ("B",), ()]
    assert vehicles["A"].legs[2].length_m == pytest.approx(c.platoon_m)


def test_case_c_the_detour_by_milano_pays(plans):
    # Alone B takes the A21 by Brescia, which is shorter; together by Milano is cheaper.
    b = by_name(plans["c"])["B"]
    assert b.alone.length_m < b.length_m
    by_brescia = km("A7", "Genova Ovest", "A7/A21 Tortona") + km(
        "A21", "A7/A21 Tortona", "A4/A21 Brescia"
    )
    longer = genova_to_rho() + km("A4", "A4/A50 Rho", "A4/A21 Brescia") - by_brescia
    assert (b.length_m - b.alone.length_m) / 1000 == pytest.approx(longer, abs=5)
    extra_alone = genova_to_rho() * PER_KM_ALONE - by_brescia * PER_KM_ALONE
    shared = km("A4", "A4/A50 Rho", "A4/A21 Brescia") * PER_KM_TOGETHER
    assert extra_alone + shared < 0


def test_case_d_is_at_least_as_good_as_c_for_the_same_pair(net, plans):
    pair = plans["d"]
    trips = [po.Trip(v.vehicle, v.origin.node, v.destination.node) for v in pair.vehicles]
    fixed = po.plan_joint(net, po.paper_weights(net), trips, "C")
    assert pair.joint_cost <= fixed.joint_cost
    a, b = pair.vehicles
    assert a.merge.name == b.merge.name == "A4/A50 Rho"
    assert a.merge.km == about(km("A4", TORINO, "A4/A50 Rho"), 1)
    # A stays with B on the A4 round Mestre, up to where the A27 crosses.
    assert a.separation.name == b.separation.name == "A4/A27 Treviso"
    assert a.platoon_m / 1000 == about(km("A4", "A4/A50 Rho", "A4/A27 Treviso"), 0)


@pytest.mark.parametrize("case", ["a", "b", "c", "d"])
def test_plans_say_what_they_are(plans, net, case):
    plan = plans[case]
    assert plan.case == case.upper()
    assert plan.proof["kind"] == "exact"
    assert plan.network.name == "italy-motorways"
    assert plan.network.identity == net.identity()
    assert plan.params["tau"] == 1.0
