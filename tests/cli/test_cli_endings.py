"""How the command ends: as a process, interrupted, or with nobody left to read."""

import os
import signal
import subprocess
import sys
from pathlib import Path

from command_line import command, refused, scenario

from platoon_osm.atomic_file import whole_file


def test_as_a_command_of_its_own():
    done = command("plan", scenario(), "--json", "a.json")
    assert (done.returncode, done.stderr) == (0, "")
    assert "Written: a.json" in done.stdout
    assert Path("a.json").is_file()


def test_a_request_to_end_cleans_up_first(capsys, monkeypatch):
    def ended(net, path):
        with whole_file(path) as draft:
            draft.write_text("half")
            signal.raise_signal(signal.SIGTERM)

    before = signal.getsignal(signal.SIGTERM)
    monkeypatch.setattr("platoon_osm.network.road_network.RoadNetwork.save", ended)
    refused(capsys, ["prepare", "italy-motorways", "-o", "a.platoon"], "interrupted")
    assert list(Path().iterdir()) == []
    assert signal.getsignal(signal.SIGTERM) is before


def test_an_interrupt_is_one_line_too(capsys, monkeypatch):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("platoon_osm.sources.load.load_network", interrupted)
    refused(capsys, ["prepare", "italy-motorways", "-o", "a.platoon"], "interrupted")


def test_a_reader_that_has_seen_enough_is_no_error():
    seen, written = os.pipe()
    os.close(seen)
    try:
        done = subprocess.run(
            [sys.executable, "-m", "platoon_osm.cli", "maps", "italy-motorways"],
            stdout=written, stderr=subprocess.PIPE, timeout=60, check=False,
        )  # fmt: skip
    finally:
        os.close(written)
    assert (done.returncode, done.stderr) == (0, b"")
