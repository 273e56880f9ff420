"""The hierarchy beside a saved network: found again, rebuilt when stale, safe to race for."""

import subprocess
import sys
from dataclasses import fields

import numpy as np
import pytest
from graphs import planar

from platoon_osm.network.saved.store import open_network, save_network
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.hierarchy.preparing import storage


@pytest.fixture
def saved(tmp_path):
    net, weight = planar(500, 1)
    path = tmp_path / "roads.platoon"
    save_network(net, path)
    return path, weight


def same_topology(a, b):
    return all(
        np.array_equal(getattr(a, item.name), getattr(b, item.name)) for item in fields(a)
    )  # fmt: skip


def refuse_to_build(*_):
    raise AssertionError("the hierarchy was built although it is stored")


def answers(net, weight):
    quick, slow = HierarchyEngine(net, weight), ReferenceEngine(net, weight)
    np.testing.assert_allclose(quick.distances([0, 7]), slow.distances([0, 7]), rtol=1e-12)
    return quick.metric.topology


def test_stored_once_and_found_again(saved, monkeypatch):
    path, weight = saved
    built = answers(open_network(path), weight)
    assert storage.hierarchy_path(path).is_file()
    monkeypatch.setattr(storage, "build_topology", refuse_to_build)
    assert same_topology(built, answers(open_network(path), weight))


def test_rebuilt_when_the_network_changed(saved):
    path, weight = saved
    answers(open_network(path), weight)
    before = storage.hierarchy_path(path).read_bytes()
    other, weight = planar(450, 2)
    save_network(other, path)
    answers(open_network(path), weight)
    assert storage.hierarchy_path(path).read_bytes() != before


@pytest.mark.parametrize("damage", ["cut", "empty", "flip", "text"])
def test_rebuilt_when_damaged(saved, damage):
    path, weight = saved
    answers(open_network(path), weight)
    file = storage.hierarchy_path(path)
    whole = bytearray(file.read_bytes())
    middle = len(whole) // 2
    whole[middle] ^= 0xFF
    file.write_bytes(
        {"cut": whole[:middle], "empty": b"", "flip": bytes(whole), "text": b"hello"}[damage]
    )
    answers(open_network(path), weight)


def test_arrays_that_point_outside_are_refused(saved):
    path, weight = saved
    net = open_network(path)
    good = answers(net, weight)
    for name in (
        "head", "triangle", "forth", "back", "parent", "rank", "node", "subtree", "upper",
        "run", "block", "local",
    ):  # fmt: skip
        arrays = {item.name: getattr(good, item.name).copy() for item in fields(good)}
        arrays[name][-1] = 10**8
        assert not storage._is_sound(storage.Topology(**arrays), net), name
    assert storage._is_sound(good, net)


def test_a_folder_that_cannot_be_written_costs_only_time(saved, monkeypatch):
    path, weight = saved

    def denied(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(np, "savez", denied)
    answers(open_network(path), weight)
    assert not storage.hierarchy_path(path).exists()
    assert list(path.parent.iterdir()) == [path]


def test_two_processes_build_at_once(saved):
    path, weight = saved
    script = (
        "import sys; from platoon_osm.network.saved.store import open_network;"
        "from platoon_osm.search.hierarchy.preparing.storage import topology_of;"
        "print(topology_of(open_network(sys.argv[1])).head.sum())"
    )
    both = [
        subprocess.Popen([sys.executable, "-c", script, str(path)], stdout=subprocess.PIPE)
        for _ in range(2)
    ]
    sums = [process.communicate(timeout=120)[0] for process in both]
    assert [process.returncode for process in both] == [0, 0]
    net = open_network(path)
    assert storage._read(storage.hierarchy_path(path), net) is not None
    assert [int(text) for text in sums] == [answers(net, weight).head.sum()] * 2
    assert sorted(p.name for p in path.parent.iterdir()) == [
        "roads.platoon", "roads.platoon.hierarchy",
    ]  # fmt: skip


def test_nothing_is_compiled_or_loaded_at_import():
    script = (
        "import sys, platoon_osm as po; po.plan_members, po.many_to_many;"
        "import platoon_osm.search.engine; assert 'numba' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", script], check=True, timeout=60)
