"""What numba keeps of a fleet's kernel is told by the files of all that it calls."""

import importlib
from pathlib import Path
from types import CodeType, FunctionType

import pytest

from platoon_osm.search.hierarchy.runtime.where_it_pays import WhereItPays


def names_in(code):
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from names_in(constant)


def called_by(function, found):
    """All functions of the package that one calls, and those that they call."""
    for name in names_in(function.__code__):
        other = function.__globals__.get(name)
        if (
            isinstance(other, FunctionType)
            and other.__module__.startswith("platoon_osm")
            and other not in found
        ):
            found.add(other)
            called_by(other, found)
    return found


@pytest.mark.parametrize(("room", "least"), [("plan", 40), ("trees", 10), ("law", 10)])
def test_all_that_a_kernel_calls_is_told_with_it(room, least):
    module = importlib.import_module(f"platoon_osm.fleets.{room}.compiled")
    kernels = [item for item in vars(module).values() if isinstance(item, WhereItPays)]
    seen = set()
    for kernel in kernels:
        called = called_by(kernel._plain, set())
        assert called <= {*kernel._helpers}, called - {*kernel._helpers}
        seen |= called
    assert len(seen) >= least


def test_what_a_kernel_of_the_bound_calls_in_other_files_is_told_with_it():
    others = set()
    for name in ("schedules", "waiting", "projecting", "ascent", "whole"):
        module = importlib.import_module(f"platoon_osm.fleets.bound.{name}")
        for kernel in vars(module).values():
            if not hasattr(kernel, "py_func") or kernel.py_func.__module__ != module.__name__:
                continue
            called = {one.__code__.co_filename for one in called_by(kernel.py_func, set())}
            called.discard(module.__file__)
            if called:
                stats = [Path(file).stat() for file in sorted(called)]
                stamp = kernel._cache._cache_file._source_stamp
                told = stamp[1] if isinstance(stamp[1], tuple) else ()
                assert set(told) >= {(one.st_mtime, one.st_size) for one in stats}, kernel
            others |= called
    assert len(others) >= 2
