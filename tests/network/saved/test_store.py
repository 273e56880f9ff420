"""The saved form: what comes back, what is refused, and that writing is all or nothing."""

import hashlib
import json
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_networks import random_networks, same_network, small_italy

from platoon_osm.errors import MapDataError, NetworkError
from platoon_osm.network.load_report import LoadReport, Source
from platoon_osm.network.saved import store
from platoon_osm.network.saved.store import (
    BEFORE_HEADER,
    FORMAT_VERSION,
    MAGIC,
    open_network,
    save_network,
)


@pytest.fixture
def saved(tmp_path):
    file = tmp_path / "italy.platoon"
    small_italy().save(file)
    return file


def assert_refused(file, *said):
    with pytest.raises(MapDataError) as caught:
        open_network(file)
    message = str(caught.value)
    assert str(file) in message
    assert "\n" not in message
    for part in said:
        assert part in message


def test_a_network_comes_back_with_everything(tmp_path):
    net = replace(
        small_italy(),
        source=Source("Łódź.osm", "ab" * 32, "2024-01-01T00:00:00Z", "ODbL 1.0", "© OSM"),
        load_report=LoadReport({"ways": 12}, ("a remark",)),
    )
    save_network(net, tmp_path / "a.platoon")
    same_network(open_network(tmp_path / "a.platoon"), net)


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(random_networks())
def test_any_network_comes_back(tmp_path, net):
    file = tmp_path / "random.platoon"
    save_network(net, file)
    again = open_network(file)
    same_network(again, net)
    assert again.identity() == net.identity()


def test_arrays_are_mapped_and_read_only(saved):
    net = open_network(saved)
    for array in (net.lon, net.tail, net.shape_lon, net.points.lon, net.texts.blob):
        assert not array.flags.writeable
        base = array
        while base is not None and not isinstance(base, np.memmap):
            base = base.base
        assert isinstance(base, np.memmap)
    with pytest.raises(ValueError, match="read-only"):
        net.length_m[0] = 1.0


def test_a_large_network_is_not_hashed_on_opening(saved, monkeypatch):
    monkeypatch.setattr(store, "SOON_HASHED_BYTES", 100)
    change_array(saved, "length_m", lambda values: values * 2)
    opened = open_network(saved)
    assert opened.length_m.sum() == 2 * small_italy().length_m.sum()
    with pytest.raises(MapDataError, match="arrays do not match their checksum"):
        open_network(saved, verify=True)


def test_saving_over_a_map_that_is_open(saved):
    opened = open_network(saved)
    before = opened.lon.copy()
    turned, _ = opened.reversed()
    save_network(turned, saved)
    # The open map still reads the old file, not half of the new one.
    np.testing.assert_array_equal(opened.lon, before)
    same_network(open_network(saved), turned)


@pytest.mark.parametrize("share", [0.001, 0.2, 0.5, 0.9, 0.999])
def test_cut_short(saved, share):
    content = saved.read_bytes()
    saved.write_bytes(content[: max(20, int(share * len(content)))])
    assert_refused(saved, "damaged or cut short", "platoon-osm prepare")


@pytest.mark.parametrize("content", [b"", b"PLT", b"<osm>" * 100, b"\x89PNG" + bytes(100)])
def test_another_file(saved, content):
    saved.write_bytes(content)
    assert_refused(saved, "not a saved network", "prepare")


def header_of(content):
    size = int.from_bytes(content[len(MAGIC) + 1 : BEFORE_HEADER - 32], "little")
    return json.loads(content[BEFORE_HEADER : BEFORE_HEADER + size]), BEFORE_HEADER + size


def with_header(file, change):
    """Rewrite the header of a saved network, keeping its length and hash in step."""
    content = file.read_bytes()
    header, begin = header_of(content)
    header = change(header)
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    text += b" " * (-(BEFORE_HEADER + len(text)) % 64)
    start = MAGIC + bytes([FORMAT_VERSION]) + len(text).to_bytes(8, "little")
    file.write_bytes(start + hashlib.sha256(text).digest() + text + content[begin:])


def change_array(file, name, change):
    """Write other values into one array of a saved network, as damage to the disk would."""
    content = bytearray(file.read_bytes())
    header, begin = header_of(content)
    item = header["arrays"][name]
    values = np.frombuffer(
        content, item["dtype"], int(np.prod(item["shape"])), begin + item["offset"]
    )
    values[:] = change(values.copy())
    del values
    file.write_bytes(content)


def test_another_version(saved):
    content = bytearray(saved.read_bytes())
    content[len(MAGIC)] = 1
    saved.write_bytes(content)
    assert_refused(saved, "saved in format 1", f"reads 3 and {FORMAT_VERSION}", "prepare")


def test_a_file_of_the_version_before_opens_without_what_it_lacks(saved, monkeypatch):
    climbs = ("climb_m", "descent_m", "graded_m", "toll_free_m")
    later = (*climbs, "points.capacity", "points.tags")
    monkeypatch.setattr(store, "SOON_HASHED_BYTES", 100)
    net = pickle.loads(pickle.dumps(open_network(saved)))  # a copy: the file changes below it

    def older(header):
        return {
            **header,
            "arrays": {name: item for name, item in header["arrays"].items() if name not in later},
        }

    with_header(saved, older)
    assert_refused(saved, "climb_m")
    content = bytearray(saved.read_bytes())
    content[len(MAGIC)] = 3
    saved.write_bytes(content)
    # Kinds of points had other codes then: "city", "services", "town", "town".
    change_array(saved, "points.kind", lambda _: np.array([2, 0, 3, 3], np.uint8))
    assert open_network(saved) == net
    for name in climbs:
        assert getattr(open_network(saved), name).tolist() == [0.0] * net.m
    change_array(saved, "points.kind", lambda values: values + 3)
    assert_refused(saved, "points.kind points beyond its 5 entries")


def test_a_file_of_the_version_before_has_no_columns_of_today(saved):
    content = bytearray(saved.read_bytes())
    content[len(MAGIC)] = 3
    saved.write_bytes(content)
    assert_refused(saved, "more than its version knows")


@settings(
    max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.data())
def test_no_changed_byte_goes_unnoticed(tmp_path, data):
    file = tmp_path / "a.platoon"
    small_italy().save(file)
    content = bytearray(file.read_bytes())
    at = data.draw(st.integers(0, len(content) - 1))
    content[at] ^= data.draw(st.integers(1, 255))
    file.write_bytes(content)
    assert_refused(file, "prepare")


def set_at(position, value):
    def change(values):
        values[position] = value
        return values

    return change


@pytest.mark.parametrize(
    ("name", "position", "value"),
    [
        ("head", 3, 8), ("head", 0, -1), ("tail", 2, 7), ("tail", 0, -5),
        ("first_out", 0, 1), ("first_out", 2, 2**31 - 1), ("first_out", -1, 9),
        ("shape_first", 0, -2), ("shape_first", 3, 2**40), ("shape_first", 1, 1),
        ("shape_first", 2, -(2**63)),
        ("node_name", 0, 10), ("node_ref", 1, -1), ("ref", 4, 2**30), ("name", 0, -(2**31)),
        ("points.name", 0, 99), ("points.kind", 1, 9), ("points.tags", 0, 99),
        ("road_class", 0, 12),
        ("texts.offsets", 1, 2**50), ("texts.offsets", 0, -1), ("toll", 0, None),
        ("inferred", 2, None),
    ],
)  # fmt: skip
def test_damaged_positions_are_found_without_hashing(saved, name, position, value):
    if value is None:  # a byte that is neither true nor false
        content = bytearray(saved.read_bytes())
        header, begin = header_of(content)
        content[begin + header["arrays"][name]["offset"] + position] = 7
        saved.write_bytes(content)
    else:
        change_array(saved, name, set_at(position, value))
    with pytest.raises(MapDataError, match="damaged") as caught:
        open_network(saved, verify=False)
    assert "\n" not in str(caught.value)
    assert str(saved) in str(caught.value)
    assert name in str(caught.value)


def test_a_network_that_could_not_be_opened_again_is_not_saved(tmp_path):
    net = replace(small_italy(), head=np.full(10, 99, np.int32))
    with pytest.raises(NetworkError, match="head points beyond its 8 entries"):
        net.save(tmp_path / "a.platoon")
    assert list(tmp_path.iterdir()) == []


def moved(header):
    header["arrays"]["lon"]["offset"] = 10**9
    return header


def without_lon(header):
    del header["arrays"]["lon"]
    return header


def of_no_type(header):
    header["arrays"]["lon"]["dtype"] = "nonsense"
    return header


@pytest.mark.parametrize(
    "change",
    [
        moved, without_lon, of_no_type,
        lambda _: [1, 2],
        lambda header: {**header, "source": {"unknown": 1}},
        lambda _: {"payload_bytes": 0},
        lambda header: {**header, "payload_bytes": -1},
        lambda _: b"\xff\xfe{",
    ],
    ids=["moved", "without", "type", "list", "source", "bare", "negative", "bytes"],
)  # fmt: skip
def test_damaged_header(saved, change):
    with_header(saved, change)
    assert_refused(saved, "damaged or cut short")


def test_a_header_longer_than_the_file(saved):
    saved.write_bytes(MAGIC + bytes([FORMAT_VERSION]) + (2**60).to_bytes(8, "little") + bytes(40))
    assert_refused(saved, "damaged or cut short")


def test_missing_file_and_folder(tmp_path):
    assert_refused(tmp_path / "none.platoon", "cannot be read")
    assert_refused(tmp_path, "cannot be read")


def test_a_write_that_fails_leaves_the_old_file_and_nothing_else(saved, monkeypatch):
    before = saved.read_bytes()
    other = saved.with_name("new.platoon")

    def disk_full(self, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", disk_full)
    for file in (saved, other):
        with pytest.raises(MapDataError, match="No space left on device") as caught:
            save_network(small_italy().reversed()[0], file)
        assert str(file) in str(caught.value)
    assert saved.read_bytes() == before
    assert [item.name for item in saved.parent.iterdir()] == [saved.name]


def test_an_interrupted_write_leaves_nothing(saved, monkeypatch):
    before = saved.read_bytes()
    net = small_italy()

    def interrupted(array):
        raise KeyboardInterrupt

    monkeypatch.setattr(np, "ascontiguousarray", interrupted)
    with pytest.raises(KeyboardInterrupt):
        save_network(net, saved)
    monkeypatch.undo()
    assert saved.read_bytes() == before
    assert [item.name for item in saved.parent.iterdir()] == [saved.name]


def test_no_folder_to_write_in(tmp_path):
    (tmp_path / "file").write_text("mine")
    with pytest.raises(MapDataError, match=r"a\.platoon: .*file is no folder") as caught:
        save_network(small_italy(), tmp_path / "file" / "a.platoon")
    assert "\n" not in str(caught.value)


def test_a_folder_is_not_written_over(tmp_path):
    (tmp_path / "a.platoon").mkdir()
    with pytest.raises(MapDataError, match="cannot be written"):
        save_network(small_italy(), tmp_path / "a.platoon")
    assert [item.name for item in tmp_path.iterdir()] == ["a.platoon"]


def test_others_may_read_what_was_saved(saved):
    # A file beside it, written the plain way, has the rights that the user's umask gives.
    plain = saved.with_name("plain")
    plain.write_bytes(b"")
    assert saved.stat().st_mode == plain.stat().st_mode


def test_an_opened_network_knows_its_file(tmp_path):
    net = small_italy()
    assert net.file is None
    net.save(tmp_path / "a.platoon")
    opened = open_network(tmp_path / "a.platoon")
    assert opened.file == tmp_path / "a.platoon"
    assert opened.with_report(LoadReport()).file == opened.file
    assert replace(opened, source=Source("x")).file == opened.file
    assert opened.reversed()[0].file is None
    # Python's frozen classes with slots say TypeError here, later versions AttributeError.
    with pytest.raises((AttributeError, TypeError)):
        opened.file = tmp_path


def test_what_was_made_of_a_network_is_not_shared_with_one_of_other_arrays():
    net = small_italy()
    made = net.attached(list_of_lengths)
    assert net.attached(list_of_lengths) is made
    assert net.with_report(LoadReport({"x": 1})).attached(list_of_lengths) is made
    longer = replace(net, length_m=net.length_m * 2)
    assert longer.attached(list_of_lengths) == [2 * length for length in made]


def list_of_lengths(net):
    return net.length_m.tolist()
