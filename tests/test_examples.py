"""The examples run as they stand, where a newcomer would run them."""

import os
import subprocess
import sys

import pytest
from places import ROOT

SCRIPTS = sorted((ROOT / "examples").glob("*.py"))


@pytest.mark.parametrize("script", SCRIPTS, ids=[script.name for script in SCRIPTS])
def test_an_example_runs(script, tmp_path, forks):
    done = forks.run(script=script, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    if done.stdout.startswith("Skipped: there is no extract at "):
        pytest.skip(done.stdout.strip())
    # Never without what it is proved for.
    assert "Proved optimal for: " in done.stdout or "dearer than the best there" in done.stdout


def test_a_plan_from_its_parts_is_that_of_plan_joint(tmp_path):
    path = os.pathsep.join([str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])])
    done = subprocess.run(
        [sys.executable, str(ROOT / "examples" / "plan_from_parts.py"), "page.html"],
        cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False,
        env={**os.environ, "PYTHONPATH": path},
    )  # fmt: skip
    assert "the same as plan_joint: True" in done.stdout
    assert "A plan from its parts" in (tmp_path / "page.html").read_text(encoding="utf-8")
