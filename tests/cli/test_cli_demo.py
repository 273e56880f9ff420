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
    # Costs are euros, and the four trucks to the south save some.
    assert out.count("costs in EUR") == 4
    assert "kg CO2e well to wheel" in out
    assert float(re.findall(r"^Saved: ([\d.]+) EUR", out, re.MULTILINE)[-1]) > 20
    assert (Path("shown") / "demo.html").stat().st_size < 500_000


def test_the_demo_where_a_file_is_in_the_way(capsys):
    Path("out").write_text("mine")
    refused(capsys, ["demo", "-o", "out"], "out")
