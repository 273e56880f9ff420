"""`platoon-osm what-if`: values as they are typed, what is printed, and what is written."""

from pathlib import Path

import pytest
from command_line import CORRIDOR, refused, run, scenario
from hypothesis import given
from hypothesis import strategies as st

import platoon_osm as po
from platoon_osm.cli.value_lists import MOST_VALUES, values_of

PRICED = CORRIDOR.replace('case = "C"', 'case = "C"\nobjective = "eu"')


def test_ranges_have_both_their_ends():
    assert values_of("--price", "1.4:2.2:0.1") == [1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.2]
    assert values_of("--toll", " 0, 0.5,1 ,2,") == [0, 0.5, 1, 2]
    assert values_of("--toll", "1,0:2:1,1") == [1, 0, 2]
    assert values_of("--wage", "5:5:1") == [5]
    assert values_of("--wage", "0:9:4") == [0, 4, 8]
    assert values_of("--figure", "-1:1:0.5") == [-1, -0.5, 0, 0.5, 1]
    assert values_of("--positions", "eddi,nacfe", names=True) == ["eddi", "nacfe"]


@given(st.integers(-50, 50), st.integers(1, 20), st.integers(0, MOST_VALUES - 1))
def test_a_range_of_tenths_is_that_of_whole_numbers(first, step, steps):
    last = first + step * steps
    found = values_of("--x", f"{first / 10}:{last / 10}:{step / 10}")
    assert found == [(first + step * k) / 10 for k in range(steps + 1)]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "nothing to vary; give values, such as --price 1.4:2.2:0.1"),
        (["--price", ""], "--price: empty"),
        (["--price", ","], "--price: empty"),
        (["--price", "1:2"], "FROM:TO:STEP"),
        (["--price", "1:2:3:4"], "FROM:TO:STEP"),
        (["--price", "1:2:0"], "step of 0 never ends"),
        (["--price", "1:2:-1"], "step of -1 never ends"),
        (["--price", "2:1:0.1"], "ends before it begins"),
        (["--price", "0:1:0.0001"], "more than 200 values"),
        (["--price", "0:1e300:1e-300"], "more than 200 values"),
        (["--price", "dear"], "'dear': is no number"),
        (["--price", "nan"], "is no finite number"),
        (["--price", "1:inf:1"], "is no finite number"),
        (["--price", "-1"], "fuel_per_l = -1.0 must be a number in"),
        (["--relief", "0:2:1"], "task_relief is 2.0"),
        (["--positions", "nobody"], "nobody"),
        (["--positions", "1"], "give a name"),
        (["--figure", "fuel_per_l"], "write NAME=VALUES"),
        (["--figure", "=1"], "write NAME=VALUES"),
        (["--figure", "fuel=1"], "which have no 'fuel'; it has fuel_per_l"),
        (["--figure", "xi=0.1,0.2"], "have no 'xi'; add --objective paper"),
        (["--price", "1", "--figure", "fuel_per_l=2"], "is varied twice"),
        (["--objective", "paper", "--price", "1,2"], "have no 'fuel_per_l'; add --objective eu"),
        (["--objective", "fuel", "--price", "1,2"], "add --objective eu"),
        (["--price", "1", "-o", "a.xlsx"], "use .csv, .svg, .png, .pdf, .html"),
        (["--price", "1", "-o", ""], "-o: empty"),
        (["--price", "1", "-o", "corridor.toml"], "ends in '.toml'"),
        (["--price", "1", "-o", "-", "-o", "-"], "standard output takes one"),
        (["--price", "1", "-o", "a.csv", "-o", "a.csv"], "write the same file"),
        (["--cost", "tau=1", "--price", "1"], "tau"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(capsys, arguments, said):
    refused(capsys, ["what-if", scenario(), *arguments], said)


def test_a_scenario_of_the_papers_weights_is_told_what_to_add(capsys):
    paper = scenario(CORRIDOR + "\n[costs]\ntau = 1.0\n")
    refused(
        capsys, ["what-if", paper, "--price", "1,2"],
        "corridor.toml: its costs are those of paper", "add --objective eu",
    )  # fmt: skip


def test_what_is_printed_and_written(capsys):
    """Costs are those of eu where nobody says otherwise; each row is a plan of its own."""
    put = ["what-if", scenario(), "--price", "1:2:1", "--positions", "nacfe", "-o", "out"]
    assert run(*put, "-o", "a.pdf", "-o", "a.png", "--language", "it") == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert max(map(len, out.splitlines())) <= 100
    assert out.startswith("What if fuel_per_l [EUR/l] were another? As asked it is 1.3.\n")
    assert "What if positions were another? As asked it is eddi." in out
    assert out.endswith("Written: out\nWritten: a.pdf\nWritten: a.png\n")
    assert sorted(path.name for path in Path("out").iterdir()) == [
        "what-if.csv", "what-if.html", "what-if.svg",
    ]  # fmt: skip
    assert Path("a.pdf").read_bytes().startswith(b"%PDF")
    table = Path("out/what-if.csv").read_text().splitlines()
    assert [line.split(",")[:2] for line in table[1:]] == [
        ["fuel_per_l", "1"], ["fuel_per_l", "2"], ["positions", "nacfe"],
    ]  # fmt: skip
    net = po.load_network("italy-motorways")
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    for line, more in zip(
        table[1:], ({"fuel_per_l": 1}, {"fuel_per_l": 2}, {"positions": "nacfe"}), strict=True
    ):
        plan = po.plan_joint(net, po.money_costs("eu", **more), trips, "C")
        told = dict(zip(table[0].split(","), line.split(","), strict=True))
        assert round(float(told["planned_EUR"]) * 100) == plan.bill.joint_cents
    page = Path("out/what-if.html").read_text()
    assert 'lang="it"' in page
    assert "compiled by hand from public facts, MIT" in page
    assert "<script" not in page


def test_the_table_goes_to_standard_output(capsys):
    put = ["what-if", scenario(PRICED), "--price", "1,2", "-o", "-", "--cost", "toll=0"]
    assert run(*put) == 0
    out, err = capsys.readouterr()
    assert out.startswith("figure,value,figure_unit,")
    assert len(out.splitlines()) == 3
    assert err.startswith("What if fuel_per_l")
