"""One table of columns: whoever makes, takes, saves or exchanges networks goes through it."""

from dataclasses import dataclass, field, fields

import numpy as np
import pytest
from made_networks import network, small_italy

from platoon_osm.errors import NetworkError
from platoon_osm.network import columns, making
from platoon_osm.network.arrays import NetworkArrays
from platoon_osm.network.columns import COLUMNS, Column, columns_per, lengthened
from platoon_osm.network.named_points import NamedPoints
from platoon_osm.network.preparing.inferred_links import infer_links
from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.network.preparing.split import split_edges
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.saved import store
from platoon_osm.network.saved.checks import check_arrays
from platoon_osm.sources.graphs import exchange


def test_every_array_of_a_network_stands_in_the_table():
    net = small_italy()
    arrays = [item.name for item in fields(net) if isinstance(getattr(net, item.name), np.ndarray)]
    named = [f"points.{item.name}" for item in fields(NamedPoints)]
    assert [column.name for column in COLUMNS] == arrays + named


def test_every_column_has_the_type_and_size_that_the_table_says():
    net = small_italy()
    sizes = {
        "node": net.n, "edge": net.m, "shape point": len(net.shape_lon),
        "named point": len(net.points),
    }  # fmt: skip
    for column in COLUMNS:
        owner = net.points if column.per == "named point" else net
        values = getattr(owner, column.name.removeprefix("points."))
        assert values.dtype == np.dtype(column.dtype), column.name
        assert len(values) == sizes.get(column.per, len(values)), column.name


@dataclass(frozen=True, slots=True, eq=False)
class WithHeights(RoadNetwork):
    """A network with columns that the table of today has not."""

    height_m: np.ndarray = field(default_factory=lambda: np.zeros(0))
    tunnel: np.ndarray = field(default_factory=lambda: np.zeros(0, bool))
    bridge: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    altitude_m: np.ndarray = field(default_factory=lambda: np.zeros(0))


@pytest.fixture
def wider(monkeypatch):
    """Add rows to the table, as the next issue will, and attributes to the network."""
    base = network([(0, 0), (1_000, 0), (2_000, 0), (3_000, 0)], [(1, 2), (0, 1), (2, 3)])
    rows = (
        Column("height_m", "edge", "f8", "m", 4.0),
        Column("tunnel", "edge", "b1", "", False, in_chain="same"),
        Column("bridge", "edge", "i4", "text", 0, "texts"),
        Column("altitude_m", "node", "f8", "m", -1.0),
    )
    for module in (columns, making, store):
        monkeypatch.setattr(module, "COLUMNS", COLUMNS + rows)
    for module in (store, exchange):
        monkeypatch.setattr(module, "RoadNetwork", WithHeights)
    return WithHeights.from_edges(
        [1, 0, 2], [2, 1, 3], lon=base.lon, lat=base.lat, height_m=[3.5, 3.0, 4.5],
        tunnel=[True, False, False], bridge=["Ponte", "", ""], altitude_m=[10, 20, 30, 40],
    )  # fmt: skip


def told(net):
    """Return what the new columns say, edges by tail."""
    return (
        net.height_m.tolist(), net.tunnel.tolist(), [net.texts[code] for code in net.bridge],
        net.altitude_m.tolist(),
    )  # fmt: skip


def test_a_new_row_is_made_and_sorted(wider):
    expected = [3.0, 3.5, 4.5], [False, True, False], ["", "Ponte", ""], [10, 20, 30, 40]
    assert told(wider) == expected
    bare = WithHeights.from_edges([0], [1], lon=[9.0, 9.1], lat=[45.0, 45.0])
    assert told(bare) == ([4.0], [False], [""], [-1.0, -1.0])


def test_a_new_row_is_taken_turned_and_changed(wider):
    assert wider.take([2, 1, 1]).height_m.tolist() == [3.5, 3.5, 4.5]
    assert wider.reversed()[0].height_m.tolist() == [3.0, 3.5, 4.5]
    assert wider.with_columns(height_m=2.0).height_m.tolist() == [2.0, 2.0, 2.0]
    assert lengthened(wider, "edge", 1, tunnel=True)["height_m"].tolist() == [3.0, 3.5, 4.5, 4.0]


def test_a_new_row_goes_through_chains_cuts_and_links(wider):
    # A tunnel is something of its own, so the road is not joined over its ends.
    assert told(merge_chains(wider)) == told(wider)
    joined = merge_chains(wider.with_columns(tunnel=False, length_m=[100.0, 300.0, 200.0]))
    assert (joined.m, joined.height_m.tolist()) == (1, [3.5])
    cut, _ = split_edges(wider, [1], [500.0])
    assert cut.height_m.tolist() == [3.0, 3.5, 4.5, 3.5]
    assert cut.altitude_m.tolist() == [10, 20, 30, 40, -1]
    linked = infer_links(wider, reach_m=5_000.0)
    assert linked.inferred.any()
    assert set(linked.height_m[linked.inferred].tolist()) == {4.0}


def test_a_new_row_is_saved_checked_and_exchanged(wider, tmp_path):
    wider.save(tmp_path / "a.platoon")
    assert told(store.open_network(tmp_path / "a.platoon")) == told(wider)
    arrays = store._arrays(wider)
    for name, wrong in (
        ("bridge", np.array([0, 99, 0], "i4")), ("altitude_m", np.zeros(3)),
        ("tunnel", np.array([2, 0, 0], "u1").view("?")),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=name):
            check_arrays({**arrays, name: wrong})
    assert told(exchange.from_networkx(wider.to_networkx())) == told(wider)
    nodes, edges = wider.to_geodataframes()
    assert edges["height_m"].tolist() == [3.0, 3.5, 4.5]
    assert edges["bridge"].tolist() == ["", "Ponte", ""]
    assert nodes["altitude_m"].tolist() == [10, 20, 30, 40]


def test_a_column_may_be_misspelt_but_not_in_silence():
    with pytest.raises(NetworkError, match="called 'speed_ms'; did you mean speed_mps"):
        RoadNetwork.from_edges([0], [1], lon=[9, 9.1], lat=[45, 45], speed_ms=20)
    with pytest.raises(NetworkError, match="no column is called 'zzz'; use climb_m, country"):
        small_italy().take([0], zzz=1)


def test_rows_say_what_they_are():
    assert {column.per for column in COLUMNS} == {
        "node", "edge", "shape point", "named point", "offset",
    }  # fmt: skip
    assert [column.name for column in columns_per("offset")] == ["first_out", "shape_first"]
    assert issubclass(RoadNetwork, NetworkArrays)
