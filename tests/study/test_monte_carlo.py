"""The same seed gives the same arrays, whoever works; what is done stays done."""

from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import fields, replace
from multiprocessing import get_context

import numpy as np
import pytest

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.study import monte_carlo
from platoon_osm.study.monte_carlo import StudyResult, run_study
from platoon_osm.study.settings import PAPER_STUDY, Study

SMALL = Study(
    network=po.RandomNetwork(spawn_diameter_m=3e5, vehicles=5),
    runs=7, tau=(0.0, 1.0), xi=(0.0, 0.5, 1.0), methods=("dijkstra", "astar"),
)  # fmt: skip
ARRAYS = [f.name for f in fields(StudyResult) if f.name not in ("study", "seed")]


def same(one, two):
    return all(
        getattr(one, name).tobytes() == getattr(two, name).tobytes()
        and getattr(one, name).dtype == getattr(two, name).dtype
        for name in ARRAYS
    )


@pytest.fixture(scope="module")
def result():
    return run_study(SMALL, seed=3)


def test_shapes(result):
    different = len(SMALL.factors().different)
    assert result.joint_cost.shape == (7, 2, 5, different)
    for reading in range(2):
        assert result.joint(1, reading).shape == (7, 5, 2 * 3 + 1)
    assert result.solo_cost.shape == (7, 2, 5)
    assert result.is_member().sum() == 7 * 4


@pytest.mark.parametrize("workers", [1, 8])
def test_threads_give_the_same(result, workers, monkeypatch):
    monkeypatch.setattr(monte_carlo, "CHUNK", 1)
    with ThreadPoolExecutor(workers) as pool:
        assert same(run_study(SMALL, seed=3, executor=pool), result)


def test_processes_give_the_same(result):
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        assert same(run_study(SMALL, seed=3, executor=pool), result)


def test_another_seed_gives_another_answer(result):
    assert not same(run_study(SMALL, seed=4), result)


def test_interrupted_work_resumes_without_doing_anything_twice(result, tmp_path, monkeypatch):
    real, calls = monte_carlo.run_once, []

    def until_the_fourth(*arguments):
        if len(calls) == 3:
            raise KeyboardInterrupt
        calls.append(1)
        return real(*arguments)

    monkeypatch.setattr(monte_carlo, "run_once", until_the_fourth)
    with pytest.raises(KeyboardInterrupt):
        run_study(SMALL, seed=3, folder=tmp_path)
    assert len(list(tmp_path.rglob("run-*.npz"))) == 3

    def count(*arguments):
        calls.append(1)
        return real(*arguments)

    monkeypatch.setattr(monte_carlo, "run_once", count)
    told = []
    again = run_study(SMALL, seed=3, folder=tmp_path, progress=told.append)
    assert len(calls) == 7
    assert sum(told) == 7
    assert same(again, result)
    assert same(run_study(SMALL, seed=3, folder=tmp_path), result)
    assert len(calls) == 7


def test_a_damaged_part_is_done_again(result, tmp_path):
    run_study(SMALL, seed=3, folder=tmp_path)
    part = sorted(tmp_path.rglob("run-*.npz"))[2]
    for damage in (b"", b"not a zip", part.read_bytes()[:-200]):
        part.write_bytes(damage)
        assert same(run_study(SMALL, seed=3, folder=tmp_path), result)
    # A part of another shape, such as an older version's, is no part of this study.
    np.savez(part, master=np.array(1))
    assert same(run_study(SMALL, seed=3, folder=tmp_path), result)


def test_more_runs_keep_the_first_ones(result, tmp_path):
    run_study(SMALL, seed=3, folder=tmp_path)
    more = run_study(replace(SMALL, runs=9), seed=3, folder=tmp_path)
    assert (more.joint_cost[:7] == result.joint_cost).all()
    assert len(list(tmp_path.rglob("run-*.npz"))) == 9


def test_other_parameters_do_not_find_these_parts():
    keys = {
        SMALL.key(3), SMALL.key(4), replace(SMALL, case="A").key(3),
        replace(SMALL, network=po.RandomNetwork(spawn_diameter_m=3e5)).key(3),
        replace(SMALL, tau=(0.0, 0.9)).key(3),
    }  # fmt: skip
    assert len(keys) == 5
    assert replace(SMALL, runs=99).key(3) == SMALL.key(3)


def test_the_front_door():
    assert po.PAPER_STUDY is PAPER_STUDY
    assert po.run_study is run_study
    assert PAPER_STUDY.grid_shape == (11, 11)
    assert PAPER_STUDY.runs == 100


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"runs": 0}, "runs"), ({"runs": 1.5}, "runs"), ({"case": "D"}, "case"),
        ({"methods": ()}, "methods"), ({"methods": ("bfs",)}, "methods"),
        ({"mixings": ("printed", "printed")}, "mixings"), ({"tau": ()}, "tau"),
        ({"tau": (1.0, 0.0)}, "tau"), ({"xi": (0.0, 1.1)}, "xi"),
        ({"points": ((2.0, 0.0),)}, "grid point"), ({"xi": (float("nan"),)}, "xi"),
    ],
)  # fmt: skip
def test_bad_parameters_are_refused_in_one_line(options, message):
    with pytest.raises(ScenarioError, match=message) as caught:
        Study(**options)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("seed", [-1, 1.5, True, "7"])
def test_bad_seeds_are_refused(seed):
    with pytest.raises(ScenarioError, match="seed"):
        run_study(SMALL, seed=seed)
