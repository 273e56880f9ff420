"""Tables of least ways between places, against the routes of trips."""

import numpy as np
import pytest

import platoon_osm as po

PLACES = ["Torino", "Genova", "Trieste", "Bologna"]


@pytest.fixture(scope="module")
def net():
    return po.load_network("italy-motorways")


@pytest.mark.parametrize("measure", ["cost", "km", "hours"])
def test_it_is_what_trips_alone_take(net, measure):
    weights = po.paper_weights(net)
    table = po.place_table(net, PLACES, measure=weights if measure == "cost" else measure)
    assert list(table.index) == list(table.columns) == PLACES
    assert table.attrs["unit"] == {"cost": "m", "km": "km", "hours": "h"}[measure]
    assert (np.diag(table) == 0).all()
    edges = {"cost": weights.solo, "km": net.length_m / 1000,
             "hours": net.length_m / net.speed_mps / 3600}[measure]  # fmt: skip
    least = po.EdgeWeights(edges, edges, edges, measure, {})
    for origin in PLACES[:2]:
        for destination in PLACES[2:]:
            trip = po.Trip("A", origin, destination)
            alone = po.plan_joint(net, least, [trip], "C").vehicles[0].alone
            assert table.loc[origin, destination] == pytest.approx(alone.cost)


def test_places_of_every_kind(net):
    beside = (10.22, 45.54)
    table = po.place_table(net, ["Torino", 5, beside, net.locate("Genova")], ["Trieste"])
    assert table.shape == (4, 1)
    assert np.isfinite(table.to_numpy()).all()
    trip = po.Trip("A", beside, "Trieste")
    least = po.EdgeWeights(*[net.length_m / 1000] * 3, "km", {})
    alone = po.plan_joint(net, least, [trip], "C").vehicles[0].alone
    assert table.iloc[2, 0] == pytest.approx(alone.length_m / 1000, rel=1e-6)


def test_no_way_is_infinite():
    net = po.RoadNetwork.from_edges([0], [1], lon=[9, 9.1], lat=[45, 45])
    table = po.place_table(net, [0, 1])
    assert table.iloc[0, 1] == pytest.approx(net.length_m[0] / 1000)
    assert np.isinf(table.iloc[1, 0])


@pytest.mark.parametrize(
    "wrong",
    [{"origins": []}, {"origins": "Torino"}, {"measure": "miles"}, {"measure": None},
     {"destinations": [None]}, {"destinations": 3}],
)  # fmt: skip
def test_nonsense(net, wrong):
    with pytest.raises(po.PlatoonError) as caught:
        po.place_table(**{"net": net, "origins": ["Torino"], **wrong})
    assert "\n" not in str(caught.value)
