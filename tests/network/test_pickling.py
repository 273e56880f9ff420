"""A network goes to another process or into a copy, and comes back whole and read-only."""

import copy
import pickle
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings
from made_networks import random_networks, same_network, small_italy

from platoon_osm import Trip, paper_weights, plan_joint
from platoon_osm.network.named_points import NamedPoints
from platoon_osm.network.saved.store import open_network
from platoon_osm.network.texts import TextTable


def through_pickle(net):
    return pickle.loads(pickle.dumps(net))


COPIES = (through_pickle, copy.copy, copy.deepcopy)


def arrays_of(thing):
    names = [item.name for item in fields(thing)]
    return [
        value for name in names if isinstance(value := getattr(thing, name), np.ndarray)
    ]  # fmt: skip


@pytest.mark.parametrize("copied", COPIES)
def test_a_copy_is_equal_and_read_only(copied):
    net = small_italy()
    again = copied(net)
    assert again is not net
    same_network(again, net)
    assert again == net
    assert hash(again) == hash(net)
    assert {net: 1}[again] == 1
    texts = [again.texts.offsets, again.texts.blob]
    arrays = arrays_of(again) + arrays_of(again.points) + texts
    assert len(arrays) == 35
    assert not any(array.flags.writeable for array in arrays)
    assert again.locate("Agrate").node == net.locate("Agrate").node
    assert again.identity() == net.identity()


@settings(max_examples=30, deadline=None)
@given(random_networks())
def test_any_network_survives(net):
    same_network(through_pickle(net), net)


@pytest.mark.parametrize("copied", COPIES)
def test_texts_and_points_alone_come_back_read_only(copied):
    net = small_italy()
    texts, points = copied(net.texts), copied(net.points)
    assert isinstance(texts, TextTable)
    assert isinstance(points, NamedPoints)
    assert list(texts) == list(net.texts)
    assert not any(array.flags.writeable for array in (texts.blob, texts.offsets))
    assert not any(array.flags.writeable for array in arrays_of(points))


def test_what_was_made_of_a_network_is_not_pickled():
    net = small_italy()
    before = len(pickle.dumps(net))
    net.locate("Agrate")
    net.locate((10.0, 45.0), "origin")
    net.connected_share()
    net.incoming()
    net.identity()
    plan_joint(net, paper_weights(net), [Trip("a", 0, 3), Trip("b", 0, 2)])
    assert len(pickle.dumps(net)) == before


def test_arrays_are_pickled_once():
    net = small_italy()
    held = sum(array.nbytes for array in arrays_of(net) + arrays_of(net.points))
    assert len(pickle.dumps(net)) < held + 4_000


def test_a_network_from_a_file_is_pickled_with_its_arrays(tmp_path):
    file = tmp_path / "a.platoon"
    small_italy().save(file)
    net = open_network(file)
    sent = pickle.dumps(net)
    # Workers on this machine find the hierarchy beside the file.
    assert pickle.loads(sent).file == file
    file.unlink()
    again = pickle.loads(sent)
    assert again.file is None
    same_network(again, small_italy())


def test_what_makes_another_network():
    net = small_italy()
    assert net == small_italy()
    assert net != small_italy().with_columns(toll=~net.toll)
    assert net != replace(net, source=replace(net.source, name="another"))
    assert net != replace(net, points=NamedPoints.empty())
    assert net != "net"
    assert net == net.with_report(net.load_report.extended({"a": 1}, "told"))
    assert net.reversed()[0].reversed()[0] == net


@settings(max_examples=60, deadline=None)
@given(random_networks(), random_networks())
def test_equal_networks_have_equal_hashes_and_all_arrays_alike(one, other):
    arrays = zip(arrays_of(one), arrays_of(other), strict=True)
    alike = all(np.array_equal(a, b) for a, b in arrays)
    assert (one == other) == (alike and list(one.texts) == list(other.texts))
    if one == other:
        assert hash(one) == hash(other)


def test_a_replaced_network_starts_with_nothing_made_of_it():
    net = small_italy()
    share = net.connected_share()
    parts = net.strong_component()
    other = replace(net, head=net.head[::-1].copy())
    assert other.strong_component() is not parts
    assert net.with_report(net.load_report).strong_component() is parts
    assert net.connected_share() == share
