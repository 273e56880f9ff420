"""Tunnels with a category for dangerous goods, as plans tell of them."""

import numpy as np
from osm_files import MOTORWAY, row, write

import platoon_osm as po
from platoon_osm.plans.trip import Trip
from platoon_osm.report.language.plan_sentences import in_language
from platoon_osm.report.language.speech import speaking
from platoon_osm.sources.osm.extract import read_osm


def bored(category, name="Galleria"):
    return {**MOTORWAY, "tunnel": "yes", "tunnel:name": name, "hazmat:adr_tunnel_cat": category}


WAYS = {
    1: ([1, 2], MOTORWAY), 2: ([2, 3], bored("C")), 3: ([3, 4], MOTORWAY),
    4: ([4, 5], bored("A", "Bassa")), 5: ([5, 6], MOTORWAY), 6: ([6, 7], bored("E", "<b>Alta")),
    7: ([7, 8], MOTORWAY),
}  # fmt: skip


def told(net, origin, destination, **profile):
    ids = net.node_id.tolist()
    trip = Trip("A", ids.index(origin), ids.index(destination), profile=profile or None)
    plan = po.plan_joint(net, po.paper_weights(net), [trip])
    return [remark for remark in plan.remarks if "tunnel" in remark]


def test_tunnels_are_told_with_their_category(tmp_path):
    net = read_osm(write(tmp_path, row(8), WAYS))
    remarks = told(net, 1, 8)
    assert [remark.split(",")[0] for remark in remarks] == [
        "A passes a tunnel of category C (Galleria", "A passes a tunnel of category E (<b>Alta",
    ]  # fmt: skip
    assert told(net, 1, 2) == []
    # Who carries dangerous goods is told of a tunnel of category A; the others are closed to it.
    net = read_osm(write(tmp_path, row(8), {**WAYS, 2: ([2, 3], MOTORWAY), 6: ([6, 7], MOTORWAY)}))
    assert told(net, 1, 8) == []
    (remark,) = told(net, 1, 8, tunnel_code="B")
    assert remark.startswith("A passes a tunnel of category A (Bassa, ")


def test_of_many_tunnels_some_are_told_and_the_rest_counted(tmp_path):
    ways = {}
    for k in range(1, 16):
        ways[k] = ([k, k + 1], bored("D", f"No {k}") if k % 2 else MOTORWAY)
    net = read_osm(write(tmp_path, row(16), ways))
    remarks = told(net, 1, 16)
    assert len(remarks) == 6
    assert remarks[-1] == "A passes 3 more tunnels with a category"
    for language in ("de", "it"):
        with speaking(language):
            assert not {in_language(remark) for remark in remarks} & set(remarks)


def test_without_tunnels_nothing_is_told(tmp_path):
    net = read_osm(write(tmp_path, row(4), {1: ([1, 2, 3, 4], MOTORWAY)}))
    assert not np.any(net.restriction)
    assert told(net, 1, 4) == []
