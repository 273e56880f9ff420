"""When kernels are compiled: by what is to be done, what was spent, and what is kept."""

from __future__ import annotations

import importlib
import itertools
import sys

import numpy as np
import pytest

from platoon_osm.search.hierarchy.runtime import where_it_pays
from platoon_osm.search.hierarchy.runtime.where_it_pays import WhereItPays


def _doubled(value):
    return _twice(value)


def _twice(value):
    return 2 * value


@pytest.fixture
def kernel(monkeypatch):
    one = WhereItPays(_doubled, 4.0, (_twice,))
    # Nothing of this test lies in a cache, whoever ran it before.
    monkeypatch.setattr(WhereItPays, "is_kept", lambda _: False)
    return one


def is_compiled(function):
    return hasattr(function, "signatures")


def test_little_work_is_done_as_it_stands_and_much_is_compiled(kernel):
    assert not is_compiled(kernel.ready(3.9))
    assert kernel.ready(3.9)(2.0) == 4.0
    assert is_compiled(kernel.ready(4.0))
    # What is compiled once stays so, for little work too.
    assert is_compiled(kernel.ready(0.0))
    assert kernel.ready(0.0)(np.float64(2.0)) == 4.0


def test_plain_runs_count_until_they_took_as_long_as_compiling(kernel, monkeypatch):
    clock = itertools.count(0.0, 1.5)
    monkeypatch.setattr(where_it_pays.time, "perf_counter", lambda: next(clock))
    plain = [kernel.ready(0.1) for _ in range(3)]
    for one in plain[:2]:
        assert one(1) == 2
    assert not is_compiled(kernel.ready(0.1))
    plain[2](1)
    assert is_compiled(kernel.ready(0.1))


def test_what_is_kept_is_loaded_for_more_than_a_moment_of_work(monkeypatch):
    import numba  # noqa: F401  (what is kept costs no import then)

    one = WhereItPays(_doubled, 4.0)
    monkeypatch.setattr(WhereItPays, "is_kept", lambda _: True)
    assert not is_compiled(one.ready(where_it_pays.LOADING_S))
    assert is_compiled(one.ready(2 * where_it_pays.LOADING_S))


def test_numba_is_not_imported_to_look_for_what_is_kept(kernel, monkeypatch):
    monkeypatch.delitem(where_it_pays.sys.modules, "numba")
    monkeypatch.setattr(WhereItPays, "is_kept", lambda _: pytest.fail("looked"))
    assert not is_compiled(kernel.ready(0.9 * where_it_pays.IMPORTING_S))


def test_who_asks_for_it_gets_it_compiled(kernel):
    assert is_compiled(kernel.now())
    assert is_compiled(kernel.ready(0.0))


def _fresh(folder, monkeypatch):
    """Return the kernel of two new modules, one of which calls the other."""
    monkeypatch.syspath_prepend(str(folder))
    for name in ("a_kernel", "a_helper"):
        sys.modules.pop(name, None)
    importlib.invalidate_caches()
    kernel, helper = (importlib.import_module(name) for name in ("a_kernel", "a_helper"))
    return WhereItPays(kernel.kernel, 4.0, (helper.helped,))


def test_what_is_kept_holds_as_long_as_all_that_is_called(tmp_path, monkeypatch):
    (tmp_path / "a_kernel.py").write_text(
        "from a_helper import helped\n\n\ndef kernel(x):\n    return helped(x) + 1.0\n"
    )
    helper = tmp_path / "a_helper.py"
    helper.write_text("def helped(x):\n    return 2.0 * x\n")
    one = _fresh(tmp_path, monkeypatch)
    assert not one.is_kept()
    assert one.now()(3.0) == 7.0
    assert _fresh(tmp_path, monkeypatch).is_kept()
    helper.write_text("def helped(x):\n    return 30.0 * x\n")
    other = _fresh(tmp_path, monkeypatch)
    assert not other.is_kept()
    assert other.now()(3.0) == 91.0
    for name in ("a_kernel", "a_helper"):
        sys.modules.pop(name, None)
