"""Help, version and lists: what a user sees before anything is planned."""

import re

import pytest
from command_line import run

import platoon_osm
from platoon_osm.cli.verbs import VERBS
from platoon_osm.costs.fuel import FUEL_SAVINGS
from platoon_osm.costs.presets import PRESETS
from platoon_osm.report.exporters import EXPORTERS, Exporter
from platoon_osm.sources.readers import READERS


def test_the_verbs_there_are():
    assert set(VERBS) == {
        "demo", "maps", "prepare", "download", "scenario", "plan", "check", "certify",
        "study", "compare", "what-if", "fleet", "trips", "bench", "warmup",
    }  # fmt: skip


@pytest.mark.parametrize("verb", ["", *VERBS])
def test_help_teaches(verb, capsys):
    assert run(*([verb] if verb else []), "--help") == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert f"Usage: platoon-osm{' ' + verb if verb else ''}" in out
    if not verb:
        assert all(known in out for known in VERBS)
        assert "platoon-osm plan corridor.toml --html plan.html" in out
    else:
        assert len(out.splitlines()) > 4


def test_version(capsys):
    assert run("--version") == 0
    assert capsys.readouterr().out == f"platoon-osm {platoon_osm.__version__}\n"


def test_maps_lists_the_bundled_ones(capsys):
    assert run("maps") == 0
    out, err = capsys.readouterr()
    assert out.startswith("italy-motorways: ")
    assert err == ""


def test_maps_lists_the_kinds_of_file(capsys):
    assert run("maps") == 0
    out = capsys.readouterr().out
    for reader in READERS.values():
        assert reader.about in out
        assert all(suffix in out for suffix in reader.suffixes)


@pytest.mark.parametrize("name", ["case", "help", "mile stones", "1st"])
def test_an_exporter_of_any_name_leaves_help_as_it_is(name, capsys):
    EXPORTERS.add(Exporter(name, "stones to write", ".txt", print))
    try:
        assert run("plan", "--help") == 0
        out, err = capsys.readouterr()
    finally:
        EXPORTERS.remove(name)
    assert err == ""
    assert ("Stones to write." in out) is (name not in ("case", "help"))


def test_objectives_are_listed(capsys):
    run("plan", "--help")
    out = capsys.readouterr().out
    for preset in PRESETS.values():
        assert re.search(rf"{preset.name} +{re.escape(preset.about[:40])}", out)


def test_fuel_tables_are_listed(capsys):
    run("plan", "--help")
    out = capsys.readouterr().out
    for table in FUEL_SAVINGS.values():
        assert re.search(rf"{table.name} .*{re.escape(table.source[:40])}", out)
