"""`platoon-osm study`: what it writes, the same bytes each time, and what it refuses."""

import csv
import re
import shutil

import pytest
from page_texts import ENGLISH, left_over, told_by_study

from platoon_osm.cli import main

SMALL = (
    "--runs", "4", "--vehicles", "4", "--grid", "3", "--diameter-km", "1,400",
    "--spawning", "points", "--nodes", "60", "--edges", "300",
)  # fmt: skip


def run(folder, *more):
    assert main(["study", *SMALL, "-o", str(folder), *more]) == 0


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study") / "out"
    run(folder, "--workers", "1")
    return folder


def test_everything_is_written(made):
    names = {path.name for path in made.iterdir()} - {"runs"}
    stems = [
        "figure-1-network", "figure-2-costs", "figure-3-involvement-dijkstra",
        "figure-4-involvement-astar", "figure-5-involvement-astar-closed-once",
    ]  # fmt: skip
    assert names == {
        *(f"{stem}{suffix}" for stem in stems for suffix in (".png", ".svg", ".csv")),
        "comparison.csv", "results.parquet", "report.html",
    }  # fmt: skip


def test_two_workers_write_the_same_bytes(made, tmp_path):
    run(tmp_path, "--workers", "2")
    for path in sorted(made.iterdir()):
        if path.suffix in (".csv", ".svg", ".html", ".parquet"):
            assert (tmp_path / path.name).read_bytes() == path.read_bytes(), path.name


def test_the_parquet_has_every_vehicle_at_every_point(made):
    from pyarrow import parquet

    table = parquet.read_table(made / "results.parquet")
    # 2 placings, 3 methods, 2 mixings, 4 runs, 4 vehicles, 9 + 1 points.
    assert table.num_rows == 2 * 3 * 2 * 4 * 4 * 10
    rows = table.to_pylist()
    assert {row["mixing"] for row in rows} == {"printed", "gain"}
    assert sum(row["is_master"] for row in rows) == len(rows) / 4
    for row in rows:
        assert row["joined"] == (row["platoon_km"] > 0)
        assert (row["merge_node"] >= 0) == (row["joined"] and not row["is_master"])
        assert row["cost_joint_m"] <= row["cost_alone_m"] * (1 + 1e-9)


def test_the_network_csv_has_the_longest_platoon(made):
    with (made / "figure-1-network.csv").open(encoding="utf-8") as handle:
        items = [row["item"] for row in csv.DictReader(handle)]
    assert items.count("spawn point") == 2 * 4
    assert {"road", "access", "master"} <= set(items)


def test_the_report_asks_for_nothing(made):
    page = (made / "report.html").read_text(encoding="utf-8")
    assert "Content-Security-Policy" in page
    assert "default-src &#x27;none&#x27;" in page
    assert not re.search(r'(?:src|href)="(?!data:|#)', page)
    assert "<script" not in page
    assert page.count("<img ") == 5
    assert "paper 33&nbsp;%" in page
    assert "xi = 18 %" in page.replace("&nbsp;", " ")


def test_a_report_in_another_language_leaves_all_data_english(made, tmp_path, capsys):
    document = tmp_path / "paper.md"
    document.write_text("before\n<!-- study:begin -->\nold\n<!-- study:end -->\nafter\n")
    folder = tmp_path / "out"
    shutil.copytree(made / "runs", folder / "runs")
    run(folder, "--table", str(document), "--language", "de")
    said = capsys.readouterr().out
    text = document.read_text(encoding="utf-8")
    assert text.startswith("before\n<!-- study:begin -->\nMeasured by `platoon-osm study")
    assert text.endswith("<!-- study:end -->\nafter\n")
    assert "\nold\n" not in text
    assert "| Dijkstra: members | Dijkstra: with master |" in text
    assert said.startswith("Of 288 readings the one closest")
    assert "--language" not in text
    for path in made.iterdir():
        if path.suffix in (".csv", ".parquet"):
            assert (folder / path.name).read_bytes() == path.read_bytes(), path.name
    english, german = ((one / "report.html").read_text(encoding="utf-8") for one in (made, folder))
    assert '<html lang="de"' in german
    said = told_by_study(german)
    assert left_over(told_by_study(english), said, {"Dijkstra", "tau"}) == set()
    assert [sentence for sentence in said if ENGLISH.search(sentence)] == []
    for path in made.glob("*.svg"):
        drawn = [
            set(re.findall("<!-- (.*?) -->", (one / path.name).read_text(encoding="utf-8")))
            for one in (made, folder)
        ]
        assert len(drawn[1]) > 5
        assert left_over(*drawn, set()) == set(), path.name


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["--runs", "0"], "runs"), (["--seed", "-1"], "seed"), (["--grid", "0"], "grid"),
        (["--method", "bfs"], "methods"), (["--mixing", ""], "mixings"), (["--case", "D"], "case"),
        (["--diameter-km", "x"], "diameter-km"), (["--workers", "0"], "workers"),
        (["--network", "nowhere.osm"], "nowhere.osm"), (["--flows", "traffic.csv"], "--network"),
        (["--dropout", "2"], "dropout"), (["--edges", "20", "--runs", "1"], "draws"),
        (["--table", "missing.md"], "missing.md"), (["--pruning", "tall"], "pruning"),
        (["--spawning", ""], "spawning"), (["--language", "xx"], "language"),
        (["--diameter-km", "nan"], "spawn_diameter_m"),
    ],
)  # fmt: skip
def test_bad_input_is_refused_in_one_line(arguments, word, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["study", "--workers", "1", "-o", str(tmp_path / "out"), *arguments]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert word in said


def test_a_file_where_the_folder_should_be_is_refused(tmp_path, capsys):
    (tmp_path / "out").write_text("")
    assert main(["study", "-o", str(tmp_path / "out")]) == 2
    assert "is a file" in capsys.readouterr().err
