"""Every test of the command starts in a folder of its own."""

import os

import pytest
from forked_command import Mother
from places import ROOT


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Every test starts in an empty folder, so that whatever is left behind is seen."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="session")
def forks():
    """What runs the command in processes of its own that need not start from nothing."""
    if not hasattr(os, "fork"):
        pytest.skip("processes fork on POSIX only")
    mother = Mother(ROOT)
    yield mother
    mother.end()
