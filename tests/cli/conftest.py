"""Every test of the command starts in a folder of its own."""

import pytest


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Every test starts in an empty folder, so that whatever is left behind is seen."""
    monkeypatch.chdir(tmp_path)
