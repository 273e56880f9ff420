"""The verb `demo`."""

import re
from pathlib import Path

from command_line import refused, run


def test_the_demo(capsys):
    assert run("demo", "-o", "shown") == 0
    out = capsys.readouterr().out
    assert sorted(path.name for path in Path("shown").iterdir()) == ["demo.gpkg", "demo.html"]
    for case in "ABCD":
        assert re.search(rf"[Cc]ase {case}\b", out), case


def test_the_demo_where_a_file_is_in_the_way(capsys):
    Path("out").write_text("mine")
    refused(capsys, ["demo", "-o", "out"], "out")
