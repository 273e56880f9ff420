"""Verbs and extensions of other packages, found by their entry points."""

from pathlib import Path

import pytest
from command_line import CORRIDOR, command
from packages import install

VERBS, EXTENSIONS = "platoon_osm.verbs", "platoon_osm.extensions"

DEPOTS = """
import click

@click.command()
@click.option("--town", required=True)
def verb(town):
    '''List the depots of a town.'''
    click.echo(f"depots of {town}")
"""

FORMATS = """
from platoon_osm.costs.fuel import FUEL_SAVINGS, FuelSaving
from platoon_osm.report.exporters import EXPORTERS, Exporter

def write(plan, net, path, *, title=None):
    path.write_text(f"{title}: {len(plan.vehicles)} vehicles")

EXPORTERS.add(Exporter("mile-stones", "stones to write", ".txt", write))
FUEL_SAVINGS.add(FuelSaving("ours", 0.02, 0.06, 0.06, "measured by ourselves"))
"""


@pytest.fixture
def site(tmp_path):
    """A folder to install packages into."""
    folder = tmp_path / "site"
    folder.mkdir()
    return folder


def refused_in_one_line(done, *said):
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("\n") == 1
    for part in said:
        assert part in done.stderr


def test_a_verb_of_another_package(site):
    install(site, "depots", {VERBS: {"depots": "depot_list:verb"}}, depot_list=DEPOTS)
    done = command("--help", path=site)
    assert (done.returncode, done.stderr) == (0, "")
    assert "added by depots" in done.stdout
    done = command("depots", "--town", "Verona", path=site)
    assert (done.returncode, done.stdout, done.stderr) == (0, "depots of Verona\n", "")
    assert "Usage: platoon-osm depots" in command("depots", "--help", path=site).stdout
    refused_in_one_line(command("depots", path=site), "platoon-osm depots: ", "--town")
    refused_in_one_line(command("depot", path=site), "did you mean 'depots'?")


def test_a_verb_of_ours_cannot_be_taken(site):
    install(site, "depots", {VERBS: {"maps": "depot_list:verb"}}, depot_list=DEPOTS)
    assert command("maps", path=site).stdout.startswith("italy-motorways: ")
    assert "added by" not in command("--help", path=site).stdout


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("broken:verb", "RuntimeError: out of order"),
        ("nowhere:verb", "ModuleNotFoundError"),
        ("depot_list:gone", "AttributeError"),
        ("depot_list:DEPOT", "is no click.Command"),
    ],
)
def test_a_broken_verb_is_told_when_it_is_called(site, value, said):
    install(
        site, "works", {VERBS: {"depots": "depot_list:verb"}}, depot_list=DEPOTS + "DEPOT = 1\n"
    )
    install(site, "fails", {VERBS: {"bad": value}}, broken="raise RuntimeError('out of\\norder')")
    done = command("--help", path=site)
    assert (done.returncode, done.stderr) == (0, "")
    assert "bad " in done.stdout
    assert command("depots", "--town", "Pavia", path=site).stdout == "depots of Pavia\n"
    refused_in_one_line(command("bad", path=site), "verb 'bad' of fails cannot be loaded", said)


def test_an_extension_adds_to_the_lists(site):
    install(site, "formats", {EXTENSIONS: {"ours": "our_formats"}}, our_formats=FORMATS)
    done = command("plan", "--help", path=site)
    assert (done.returncode, done.stderr) == (0, "")
    assert "--mile-stones FILE  Stones to write." in done.stdout
    assert "measured by ourselves" in done.stdout
    costs = '[costs]\npositions = "ours"\n'
    text = CORRIDOR.format(network="italy-motorways") + costs
    Path("corridor.toml").write_text(text)
    done = command("plan", "corridor.toml", "--mile-stones", "stones.txt", path=site)
    assert (done.returncode, done.stderr) == (0, "")
    assert Path("stones.txt").read_text() == "A small corridor: 2 vehicles"
    refused_in_one_line(command("plan", "corridor.toml"), "fuel saving 'ours' is unknown")


def test_a_broken_extension_is_told_and_the_others_work(site):
    install(site, "formats", {EXTENSIONS: {"ours": "our_formats"}}, our_formats=FORMATS)
    install(site, "abroad", {EXTENSIONS: {"bad": "broken"}}, broken="1 / 0")
    done = command("plan", "--help", path=site)
    assert done.returncode == 0
    assert "--mile-stones" in done.stdout
    assert done.stderr == (
        "platoon-osm: extension 'bad' of abroad cannot be loaded "
        "(ZeroDivisionError: division by zero); mend or uninstall abroad\n"
    )


def test_an_extension_adds_a_reader(site):
    text = """
from platoon_osm.sources.readers import READERS, Reader

def read(path, classes, rules):
    from platoon_osm.sources.load import load_network
    return load_network("italy-motorways", classes)

READERS.add(Reader("links", (".links",), "list of links, one a line", read))
"""
    install(site, "formats", {EXTENSIONS: {"links": "links_reader"}}, links_reader=text)
    Path("roads.links").write_text("")
    assert ".links: list of links, one a line" in command("maps", path=site).stdout
    done = command("maps", "roads.links", path=site)
    assert (done.returncode, done.stderr) == (0, "")
    assert "RoadNetwork italy-motorways" in done.stdout
