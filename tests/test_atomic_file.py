"""Files that appear whole, together or not at all, wherever the work is interrupted."""

import os
import random
import signal
import stat
import subprocess
import sys
import textwrap

import pytest

from platoon_osm import leftovers
from platoon_osm.atomic_file import all_or_none, filled_folder, whole_file
from platoon_osm.errors import MapDataError, ScenarioError
from platoon_osm.interrupts import ended_by_signals, held_back


def names(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


@pytest.fixture(autouse=True)
def nothing_is_left():
    yield
    assert leftovers._noted == {}


def write(path, text="new", **options):
    with whole_file(path, **options) as draft:
        draft.write_text(text)


def test_an_error_leaves_what_was_there(tmp_path):
    (tmp_path / "a.txt").write_text("old")

    def fail():
        with whole_file(tmp_path / "a.txt") as draft:
            draft.write_text("half")
            raise ValueError("no")

    with pytest.raises(ValueError, match="no"):
        fail()
    assert (tmp_path / "a.txt").read_text() == "old"
    assert names(tmp_path) == ["a.txt"]


def test_several_files_appear_together_or_not_at_all(tmp_path):
    (tmp_path / "b").write_text("old b")

    def fail():
        with all_or_none():
            for place in ("a", "b", "b/c"):
                write(tmp_path / place)

    with pytest.raises(ScenarioError, match="b is no folder"):
        fail()
    assert names(tmp_path) == ["b"]
    assert (tmp_path / "b").read_text() == "old b"
    with all_or_none():
        write(tmp_path / "a")
        write(tmp_path / "b")
        assert not (tmp_path / "a").exists()
    assert (tmp_path / "a").read_text() == (tmp_path / "b").read_text() == "new"


@pytest.mark.parametrize("links", [True, False])
def test_a_move_that_fails_brings_back_what_earlier_ones_replaced(tmp_path, monkeypatch, links):
    def no_links(*_, **__):
        raise OSError("no links here")

    if not links:
        monkeypatch.setattr(os, "link", no_links)
    (tmp_path / "a").write_text("old a")

    def fail():
        with all_or_none():
            for name in ("a", "b", "c"):
                write(tmp_path / name, refusal=MapDataError)
            (tmp_path / "c").mkdir()  # somebody is quicker
            (tmp_path / "c" / "d").write_text("theirs")

    with pytest.raises(MapDataError, match="c: is a folder and cannot be written"):
        fail()
    assert (tmp_path / "a").read_text() == "old a"
    assert names(tmp_path) == ["a", "c", "c/d"]


def test_a_folder_is_made_for_its_files_alone(tmp_path):

    def fail():
        with filled_folder(tmp_path / "x" / "y") as draft:
            (draft / "one").write_text("1")
            raise ValueError("no")

    with pytest.raises(ValueError, match="no"):
        fail()
    assert names(tmp_path) == []
    (tmp_path / "x").mkdir()
    (tmp_path / "x" / "mine").write_text("stays")
    with filled_folder(tmp_path / "x" / "y") as draft:
        (draft / "one").write_text("1")
        write(draft / "two", "2")
    assert names(tmp_path) == ["x", "x/mine", "x/y", "x/y/one", "x/y/two"]


def test_messages_name_the_file_and_not_its_draft(tmp_path):
    def fail():
        with filled_folder(tmp_path / "x") as folder, whole_file(folder / "a.txt"):
            raise OSError(28, "No space left on device")

    with pytest.raises(ScenarioError) as caught:
        fail()
    assert str(caught.value).startswith(f"{tmp_path / 'x' / 'a.txt'}: cannot be written (No space")
    assert names(tmp_path) == []


@pytest.mark.skipif(os.name == "nt", reason="rights and links of POSIX")
def test_links_and_rights_stay(tmp_path):
    real = tmp_path / "real.txt"
    real.write_text("old")
    real.chmod(0o640)
    (tmp_path / "link.txt").symlink_to("real.txt")
    (tmp_path / "far.txt").symlink_to(tmp_path / "link.txt")
    write(tmp_path / "far.txt")
    assert real.read_text() == "new"
    assert stat.S_IMODE(real.stat().st_mode) == 0o640
    assert (tmp_path / "link.txt").is_symlink()
    assert (tmp_path / "far.txt").is_symlink()
    (tmp_path / "dangling.txt").symlink_to("made.txt")
    write(tmp_path / "dangling.txt")
    assert (tmp_path / "made.txt").read_text() == "new"
    (tmp_path / "loop").symlink_to("loop")
    with pytest.raises(ScenarioError, match="loop: cannot be written"):
        write(tmp_path / "loop")


@pytest.mark.parametrize("name", ["a.gpkg", "a.csv.html.x", "a.HTMLX"])
def test_a_suffix_of_another_format_is_refused(tmp_path, name):
    with pytest.raises(ScenarioError, match=r"ends in \.html or \.htm, not") as caught:
        write(tmp_path / name, suffixes=(".html", ".htm"))
    assert "\n" not in str(caught.value)
    for right in ("a.html", "a.HTM", "a"):
        write(tmp_path / right, suffixes=(".html", ".htm"))


def test_interrupts_wait_while_files_are_moved():
    seen = []

    def interrupted():
        with held_back():
            signal.raise_signal(signal.SIGINT)
            seen.append("went on")

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert seen == ["went on"]


def test_pressing_twice_is_one_interrupt():
    with ended_by_signals():
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGTERM)
        signal.raise_signal(signal.SIGINT)  # while it cleans up


def test_what_was_ignored_stays_ignored():
    before = signal.signal(signal.SIGTERM, signal.SIG_IGN)
    try:
        with ended_by_signals():
            signal.raise_signal(signal.SIGTERM)
    finally:
        signal.signal(signal.SIGTERM, before)


WRITER = textwrap.dedent("""
    import sys
    from pathlib import Path
    from platoon_osm.atomic_file import all_or_none, filled_folder, whole_file
    folder = Path(sys.argv[1])
    print("begun", flush=True)
    while True:
        with all_or_none():
            for name in ("a", "b"):
                with whole_file(folder / name) as draft:
                    draft.write_text(name * 50_000)
            with filled_folder(folder / "made" / "deep") as inner:
                (inner / "c").write_text("c" * 50_000)
        for name in ("a", "made/deep/c"):
            (folder / name).unlink()
        (folder / "made/deep").rmdir()
        (folder / "made").rmdir()
""")


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_interrupts_at_random_moments_leave_no_half_file_and_no_draft(tmp_path):
    draw = random.Random(11)
    for number in range(25):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "b").write_text("b" * 50_000)
        process = subprocess.Popen(
            [sys.executable, "-c", WRITER, folder], stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )  # fmt: skip
        assert process.stdout is not None
        process.stdout.readline()
        try:
            process.wait(draw.uniform(0, 0.05))
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
        process.wait(20)
        process.stdout.close()
        for path in folder.rglob("*"):
            assert ".draft-" not in str(path), number
            if path.is_file():
                assert path.read_text() == path.name * 50_000, number
        assert (folder / "b").exists(), number
