"""Exporters: one list that the command is made from, and that users add to."""

import subprocess
import sys

import pytest
from places import ROOT

from platoon_osm import PlatoonError, report
from platoon_osm.report.exporters import EXPORTERS, Exporter


def test_the_exporters_and_their_order():
    assert list(EXPORTERS) == [
        "html",
        "pages",
        "gpkg",
        "json",
        "csv",
        "pauses",
        "bill",
        "flows",
        "gpx",
        "sheets",
        "drivers",
        "figures",
    ]
    assert [name for name in EXPORTERS if EXPORTERS[name].is_folder] == [
        "pages",
        "gpx",
        "drivers",
        "figures",
    ]
    for exporter in EXPORTERS.values():
        assert exporter.about
        assert bool(exporter.suffix) is not exporter.is_folder


@pytest.mark.parametrize(
    "name", ["html", "pages", "gpkg", "json", "csv", "pauses", "flows", "gpx", "sheets", "drivers"]
)
def test_each_writes_what_its_function_writes(name, plan, net, tmp_path):
    exporter = EXPORTERS.find(name)
    path = tmp_path / f"out{exporter.suffix}"
    if exporter.is_folder:
        path.mkdir()
    exporter.write(plan, net, path, title="Ours")
    files = list(path.iterdir()) if exporter.is_folder else [path]
    assert files
    assert all(file.stat().st_size for file in files)
    if name in ("html", "flows"):
        assert "<title>Ours</title>" in path.read_text(encoding="utf-8")


def test_a_user_adds_an_exporter(plan, net, tmp_path):
    def write(plan, net, path, *, title=None):
        path.write_text(f"{title}: {len(plan.vehicles)} vehicles, {net.m} edges", encoding="utf-8")

    def toy():
        with pytest.raises(
            PlatoonError, match=r"exporter 'toy' is unknown.*html, pages, gpkg, json"
        ):
            EXPORTERS.find("toy")

    toy()
    EXPORTERS.add(Exporter("toy", "a line to write", ".txt", write))
    try:
        EXPORTERS.find("toy").write(plan, net, tmp_path / "toy.txt", title="Toy")
        assert list(EXPORTERS)[-1] == "toy"
    finally:
        EXPORTERS.remove("toy")
    assert (tmp_path / "toy.txt").read_text() == f"Toy: 3 vehicles, {net.m} edges"
    toy()


def test_reading_the_list_loads_no_exporter():
    code = (
        "import sys; from platoon_osm.report.exporters import EXPORTERS; list(EXPORTERS.values())\n"
        "print([m for m in ('numpy', 'folium', 'shapely', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT,
        timeout=60,
    )  # fmt: skip
    assert done.stdout.strip() == "[]"


def test_every_name_of_the_room_exists():
    assert set(report.__all__) == set(report._WHERE)
    for name in report.__all__:
        assert getattr(report, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        report.nonsense  # noqa: B018 (asking is the test)
