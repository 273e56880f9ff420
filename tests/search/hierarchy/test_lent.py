"""Memory that is lent out again only when nobody holds it."""

import threading

import numpy as np
import pytest

from platoon_osm.search import engine as engines
from platoon_osm.search.hierarchy.runtime import lent as module
from platoon_osm.search.hierarchy.runtime.lent import lent


@pytest.fixture(autouse=True)
def nothing_spare(monkeypatch):
    monkeypatch.setattr(module, "_spare", {})


def test_arrays_in_use_never_share_memory():
    held = [lent(10_000) for _ in range(5)]
    for value, array in enumerate(held):
        array[:] = value
    assert [array[0] for array in held] == [0, 1, 2, 3, 4]


def test_memory_comes_back_when_the_last_view_is_gone():
    array = lent(100, 200)
    address = array.ctypes.data
    view = array.T[3:5]
    del array
    other = lent(100, 200)
    assert other.ctypes.data != address
    view[:] = 7.0
    other[:] = 1.0
    assert (view == 7.0).all()
    del view
    assert lent(20_000).ctypes.data == address


def test_little_and_too_much_are_not_kept(monkeypatch):
    monkeypatch.setattr(module, "KEPT_BYTES", 200_000)
    small, large = lent(10), lent(30_000)
    assert small.flags.owndata
    assert large.flags.owndata
    first, second = lent(20_000), lent(20_000)
    del first, second
    assert sum(len(blocks) for blocks in module._spare.values()) == 1


def test_what_is_kept_can_be_released():
    array = lent(20_000)
    del array
    engines.release()
    assert not module._spare
    assert module.KEPT_BYTES > 1 << 24


def test_many_threads_take_different_blocks():
    kept = [lent(10_000) for _ in range(8)]
    del kept
    taken, barrier = [], threading.Barrier(8)

    def take():
        barrier.wait(timeout=20)
        taken.extend(lent(10_000) for _ in range(4))

    threads = [threading.Thread(target=take) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=20)
    assert len({array.ctypes.data for array in taken}) == 32


def test_results_outlive_their_engine():
    from graphs import planar

    from platoon_osm.search.hierarchy.engine import HierarchyEngine

    net, weight = planar(10_000, 0)
    dist = HierarchyEngine(net, weight).tree(0).dist
    before = dist.copy()
    for node in range(1, 20):
        HierarchyEngine(net, weight * 2).tree(node)
    np.testing.assert_array_equal(dist, before)
