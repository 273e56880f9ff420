"""The checker has its own numbers and reading: it imports no planner, and none of its laws."""

import ast

from places import ROOT

ROOM = ROOT / "platoon_osm" / "inspection"
ALLOWED = {"errors", "kinds", "atomic_file", "plans"}


def test_the_checker_imports_records_and_errors_alone():
    for path in sorted(ROOM.rglob("*.py")):
        depth = len(path.relative_to(ROOM).parts)
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                assert not any(alias.name.startswith("platoon_osm") for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and node.level:
                room = (node.module or "").split(".")[0]
                outside = node.level == depth + 1
                assert node.level <= depth or (outside and room in ALLOWED), (path, node.module)
