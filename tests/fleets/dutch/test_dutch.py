"""The published Dutch instances: read from tables and as published, and planned as published."""

import csv
import pickle
from pathlib import Path

import numpy as np
import pytest
from places import SHARED
from soak import chosen, soaked

from platoon_osm.cli import main
from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.dutch.comparing import cells_of, kinds_of, run_all, table_of
from platoon_osm.fleets.dutch.folder import read_dutch
from platoon_osm.fleets.dutch.model import dutch_instance
from platoon_osm.fleets.dutch.pickled import plain_objects
from platoon_osm.fleets.dutch.records import DutchData, DutchInstance, DutchTruck
from platoon_osm.fleets.exact_process import Solver, exact_fleet
from platoon_osm.fleets.matching import matched_pairs

FOLDER = SHARED / "data" / "dutch_platooning"
needs_data = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="../shared/data/dutch_platooning is not here"
)

TABLES = {
    "links.csv": "from,to,km\n1,2,40\n2,3,80\n3,4,40\n2,5,60\n",
    "instances.csv": (
        "set,n_trucks,instance,truck,origin,destination,dep_min\n"
        "UNIFORM,3,0,0,1,4,7\nUNIFORM,3,0,1,1,5,10\nUNIFORM,3,0,2,2,4,50\n"
    ),
    "published.csv": (
        "set,n_trucks,flexibility_min,max_trucks_per_platoon,platoons_per_trip,fuel_savings_pct,"
        "platoon_km_pct,trucks_in_platoon_pct\nUNIFORM,3,30,2,inf,5.5,60,100\n"
    ),
}


@pytest.fixture
def folder(tmp_path):
    for name, text in TABLES.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def published(folder, data, name="UNIFORM"):
    """Write instances as their authors did: links, and arrays of dictionaries."""
    inside = folder / "data"
    (inside / name).mkdir(parents=True)
    rows = "".join(f"{a};{b};{km:g}\n" for a, b, km in data.links)
    (inside / "Link list.csv").write_text("From Node;To Node;Distance in km\n" + rows)
    for one in data.instances:
        size = f"{len(one.trucks)}_{one.number}"
        ends = {k: (t.origin, t.destination) for k, t in enumerate(one.trucks)}
        times = {k: t.departure_min for k, t in enumerate(one.trucks)}
        np.save(inside / name / f"ODdata_{size}.npy", ends)
        np.save(inside / name / f"deptimes_{size}.npy", times)


def test_tables_are_read(folder):
    data = read_dutch(folder)
    assert data.links[1] == (2, 3, 80.0)
    assert data.instances == (
        DutchInstance("UNIFORM", 0, (DutchTruck(1, 4, 7.0), DutchTruck(1, 5, 10.0),
                                     DutchTruck(2, 4, 50.0))),
    )  # fmt: skip
    assert data.published["UNIFORM", 3, 30, 2, 0].saving_pct == 5.5


@pytest.mark.parametrize("whole", [True, False])
def test_the_published_folder_is_read_alike(folder, tmp_path, whole):
    data = read_dutch(folder)
    other = tmp_path / "2020.0302"
    published(other, data)
    found = read_dutch(other if whole else other / "data")
    assert (found.links, found.instances, found.published) == (data.links, data.instances, {})


class Evil:
    def __reduce__(self):
        return (Path.touch, (Path("ran"),))


@pytest.mark.parametrize("what", [Evil(), {0: Evil()}, [Evil(), 1], lambda: 0])
def test_pickles_that_name_more_than_plain_data_are_refused_and_not_run(
    tmp_path, monkeypatch, what
):
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "ODdata_3_0.npy"
    array = np.empty((), object)
    array[()] = what
    try:
        np.save(file, array)
    except (pickle.PicklingError, AttributeError):
        np.save(file, np.array(Evil(), object))
    with pytest.raises(ScenarioError, match="no array of plain numbers") as told:
        plain_objects(file)
    assert "\n" not in str(told.value)
    assert not (tmp_path / "ran").exists()


@pytest.mark.parametrize(
    "value", [{1: (2, 3)}, [(1, 2), (3, 4)], {0: 1.5}, np.array([[1, 2], [3, 4]])]
)
def test_plain_data_is_opened(tmp_path, value):
    file = tmp_path / "a.npy"
    np.save(file, value if isinstance(value, np.ndarray) else np.array(value, object))
    found = plain_objects(file)
    plain = value.tolist() if isinstance(value, np.ndarray) else value
    assert str(found).replace("(", "[").replace(")", "]") == str(plain).replace("(", "[").replace(
        ")", "]"
    )


@pytest.mark.parametrize("cut", [0, 5, 40, 100])
def test_broken_array_files_are_told_in_one_line(tmp_path, cut):
    file = tmp_path / "a.npy"
    np.save(file, np.array({0: (1, 2)}, object))
    file.write_bytes(file.read_bytes()[:cut])
    with pytest.raises(ScenarioError, match=r"a\.npy: is no array"):
        plain_objects(file)


@pytest.mark.parametrize(
    ("name", "old", "new", "match"),
    [
        ("links.csv", "from,to,km", "from,to,miles", "no column 'km'"),
        ("links.csv", "1,2,40", "1,2,-4", "give a length above 0"),
        ("links.csv", "1,2,40", "1,1,4", "give a length above 0"),
        ("links.csv", "1,2,40", "x,2,40", "give a number"),
        ("links.csv", "1,2,40", "1.5,2,40", "give a whole number"),
        ("instances.csv", "0,0,1,4,7", "0,0,1,1,7", "to itself"),
        ("instances.csv", "0,0,1,4,7", "0,0,1,4,nan", "give a number"),
        ("instances.csv", "UNIFORM,3,0,2,2,4,50\n", "", "has 2 trucks of 3"),
        ("published.csv", ",inf,", ",two,", "use 1 or inf"),
        ("published.csv", "5.5", "much", "give a number"),
    ],
)
def test_broken_tables_are_told_with_file_and_line(folder, name, old, new, match):
    file = folder / name
    file.write_text(file.read_text().replace(old, new, 1))
    with pytest.raises(ScenarioError, match=match) as told:
        read_dutch(folder)
    assert name in str(told.value)
    assert "\n" not in str(told.value)


def test_a_folder_of_something_else_is_refused(tmp_path):
    with pytest.raises(ScenarioError, match="holds neither"):
        read_dutch(tmp_path)


def test_a_published_folder_with_a_file_missing_is_told(folder, tmp_path):
    other = tmp_path / "other"
    published(other, read_dutch(folder))
    (other / "data" / "UNIFORM" / "deptimes_3_0.npy").unlink()
    with pytest.raises(ScenarioError, match=r"deptimes_3_0\.npy"):
        read_dutch(other)


def test_platoons_of_two_and_three_save_what_the_model_says():
    """Trucks from one place to another at one time: 16 and 27 % in all, of what one burns."""
    data = DutchData(((1, 2, 100.0),), (), {})
    with Solver() as solver:
        for count, saved in ((2, 0.16), (3, 0.27), (4, 0.32), (5, 0.43), (6, 0.54)):
            one = DutchInstance("UNIFORM", 0, (DutchTruck(1, 2, 0.0),) * count)
            found = exact_fleet(dutch_instance(data, one, 15, 3), 10.0, solver)
            assert found.proved
            assert found.saving / 1e7 == pytest.approx(saved)
    one = DutchInstance("UNIFORM", 0, (DutchTruck(1, 2, 0.0),) * 5)
    assert matched_pairs(dutch_instance(data, one, 15, 2))[2] / 1e7 == pytest.approx(0.32)


def test_departures_are_rounded_up_to_the_grid():
    data = DutchData(((1, 2, 80.0),), (), {})
    one = DutchInstance("UNIFORM", 0, (DutchTruck(1, 2, 7.0), DutchTruck(1, 2, 30.0)))
    found = dutch_instance(data, one, 20, 2)
    assert found.earliest.tolist() == [900_000, 1_800_000]
    assert (found.latest - found.earliest).tolist() == [4_800_000] * 2
    assert dutch_instance(data, one, 20, 2, 0).earliest.tolist() == [420_000, 1_800_000]


def test_a_truck_to_a_city_without_links_is_told():
    data = DutchData(((1, 2, 80.0), (3, 4, 80.0)), (), {})
    for end, match in ((9, "no link leads to city 9"), (3, "has no way")):
        one = DutchInstance("UNIFORM", 0, (DutchTruck(1, end, 0.0),))
        with pytest.raises(ScenarioError, match=match):
            dutch_instance(data, one, 20, 2)


def test_the_command_prints_and_writes_both_tables(folder, tmp_path, capfd):
    out = tmp_path / "out"
    assert main(["bench", "dutch", "--data", str(folder), "-o", str(out)]) == 0
    said = capfd.readouterr().out
    assert "Exact minutes" in said
    assert "10.1287/ijoc.2020.0302" in said
    rows = list(csv.DictReader((out / "instances.csv").read_text().splitlines()))
    assert len(rows) == 18
    assert all(float(row["gap_on_savings_pct"]) < 0.01 for row in rows)
    cells = list(csv.DictReader((out / "cells.csv").read_text().splitlines()))
    assert [cell["published_fuel_savings_pct"] for cell in cells].count("5.5") == 1
    assert main(["bench", "dutch", "--data", str(folder), "--set", "ONEORIG"]) == 2
    assert "has no instance of ONEORIG" in capfd.readouterr().err


@soaked
@needs_data
def test_the_published_savings_are_reached():
    """Every day those of 20 trucks with up to 30 minutes; all of them in a soak."""
    data = read_dutch(FOLDER)
    trucks, flexibility = chosen((20, 30), (40, 45))
    some = tuple(one for one in data.instances if len(one.trucks) <= trucks)
    part = DutchData(data.links, some, data.published)
    asked = [one for one in kinds_of(part, (), (15.0,)) if one[1] <= flexibility]
    runs = run_all(part, asked)
    cells = cells_of(part, runs)
    assert len(cells) == chosen(12, 54)
    for kind in ((2, 1), (2, 0), (3, 0)):
        own = [cell for cell in cells if (cell.largest, cell.per_trip) == kind]
        apart = [cell.saving_pct - cell.published.saving_pct for cell in own]
        if kind == (2, 1):
            assert np.mean(np.abs(apart)) <= 0.08
        else:
            assert np.mean(apart) >= 0
        assert min(apart) > -0.2
    assert max(cell.worst_gap_pct for cell in cells) <= 0.5
    assert "ONEORIG" in table_of(cells, runs)
