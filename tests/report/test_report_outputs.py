"""Where a report may be written: one rule for all kinds, by the command and from Python."""

import json
import os
import sqlite3
import xml.etree.ElementTree as ElementTree
from contextlib import closing

import pytest
from money_plans import in_money
from po_valley import THREE, make_plan, po_valley

import platoon_osm as po
from platoon_osm import PlatoonError, ScenarioError
from platoon_osm.network.load_report import Source
from platoon_osm.output_paths import check_outputs
from platoon_osm.report.exporters import EXPORTERS

FILES = [name for name in EXPORTERS if not EXPORTERS[name].is_folder]
KINDS = [*(name for name in EXPORTERS if name != "figures"), "compare"]
"""Figures take seconds, so they are tried apart."""


@pytest.fixture(scope="module")
def plan(plan):
    """In money, or it had no bill to write."""
    return in_money(plan)


def writer(kind):
    """Return what writes a kind of output to a path, and its suffix."""
    if kind == "compare":
        return lambda plan, net, path: po.write_comparison([plan, plan], net, path), ".html"
    exporter = EXPORTERS.find(kind)
    return exporter.write, exporter.suffix


@pytest.mark.parametrize("kind", KINDS)
def test_folders_that_are_missing_are_made(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    target = tmp_path / "some" / "where" / f"new{suffix}"
    write(plan, net, target)
    assert target.is_file() or any(target.iterdir())
    assert not list(tmp_path.rglob(".draft-*"))


@pytest.mark.parametrize("kind", [*KINDS, "figures"])
def test_a_file_on_the_way_is_refused_alike(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    (tmp_path / "file").write_text("mine")
    for way in (f"file/new{suffix}", f"file/deeper/new{suffix}"):
        with pytest.raises(ScenarioError) as refused:
            write(plan, net, tmp_path / way)
        assert str(refused.value) == (
            f"{tmp_path / way}: {tmp_path / 'file'} is no folder; name another"
        )
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
    assert (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize("kind", [*KINDS, "figures"])
def test_the_other_kind_of_thing_in_its_place(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    target = tmp_path / f"there{suffix}"
    if suffix:
        target.mkdir()
        said = "is a folder and cannot be written; give the name of a file, such as plan"
    else:
        target.write_text("mine")
        said = "is a file; name a folder to write into"
    with pytest.raises(ScenarioError) as refused:
        write(plan, net, target)
    assert f"{target}: {said}" in str(refused.value)
    assert [path.name for path in tmp_path.iterdir()] == [target.name]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write all")
@pytest.mark.parametrize("kind", [*KINDS, "figures"])
def test_a_folder_that_takes_no_files(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o500)
    for way in (f"new{suffix}", f"deeper/new{suffix}"):
        with pytest.raises(ScenarioError) as refused:
            write(plan, net, closed / way)
        assert str(refused.value) == f"{closed / way}: {closed} takes no files; name another folder"


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_there_is_replaced_or_joined(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    target = tmp_path / f"there{suffix}"
    if suffix:
        target.write_text("old")
    else:
        target.mkdir()
        (target / "theirs.txt").write_text("kept")
    write(plan, net, target)
    if suffix:
        assert target.stat().st_size > 100
    else:
        assert (target / "theirs.txt").read_text() == "kept"
        assert len(list(target.iterdir())) > 1


@pytest.mark.parametrize("kind", KINDS)
def test_a_name_that_is_no_utf_8(kind, plan, net, tmp_path):
    write, suffix = writer(kind)
    for way in (f"\udcff{suffix}", f"\udcff/new{suffix}"):
        with pytest.raises(
            ScenarioError, match="is no name in UTF-8; name it otherwise"
        ) as refused:
            write(plan, net, tmp_path / way)
        str(refused.value).encode()
    assert not list(tmp_path.iterdir())


def test_figures_make_their_folder(plan, net, tmp_path):
    written = po.write_figures(plan, net, tmp_path / "new" / "figures", formats=["svg"])
    assert all(path.is_file() and path.parent == tmp_path / "new" / "figures" for path in written)


@pytest.mark.parametrize("kind", ["html", "gpx"])
def test_folders_made_for_nothing_are_gone_again(kind, plan, net, tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    write, suffix = writer(kind)
    with pytest.raises(PlatoonError, match="No space left"):
        write(plan, net, tmp_path / "some" / "where" / f"new{suffix}")
    assert not list(tmp_path.iterdir())


def test_halves_of_characters_are_written_alike(tmp_path):
    half, whole = "half \ud83d of one", "half \ufffd of one"
    net = po_valley(lambda name: f"{half} {name}", Source(half, half, half, half, half))
    plan = in_money(make_plan(net, THREE, lambda name: f"{name} {half}"))
    for name in FILES:
        path = tmp_path / f"plan-{name}{EXPORTERS[name].suffix}"
        EXPORTERS[name].write(plan, net, path, title=half)
        if name == "gpkg":
            with closing(sqlite3.connect(path)) as file:
                assert file.execute("SELECT vehicle FROM routes").fetchone() == (f"A {whole}",)
            continue
        text = path.read_bytes().decode("utf-8")
        assert whole in text or name == "pauses"  # a plan without times has none
        if name == "json":
            assert json.loads(text)["trips"][0]["vehicle"] == f"A {whole}"
            assert po.Plan.read_json(path).vehicles[0].vehicle == f"A {whole}"
    for path in po.write_gpx(plan, net, tmp_path / "gpx"):
        assert whole in path.read_bytes().decode("utf-8")
        ElementTree.parse(path)
    net.save(tmp_path / "net.platoon")
    assert whole in "".join(po.load_network(tmp_path / "net.platoon").texts)
    assert plan.summary().encode()


def test_names_of_outputs_are_checked_before_anything_is_done(tmp_path):
    from platoon_osm.cli.outputs import output_kind

    for holds in ((), ("*",)):
        made = output_kind("--x", holds=holds)(str(tmp_path / "not" / "there"))
        check_outputs([made])
        with pytest.raises(ScenarioError, match="UTF-8"):
            output_kind("--x", holds=holds)(str(tmp_path / "\udcff"))
    assert not list(tmp_path.iterdir())
