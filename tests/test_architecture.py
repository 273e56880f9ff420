"""The walls of the house: who may import whom, and what an import may cost."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "platoon_osm"
ORDER = (
    "errors", "whole_file", "display", "network", "sources", "costs", "planning", "study", "report",
    "cli",
)  # fmt: skip
"""Each may import those to its left, and itself."""

MODULES = sorted(PACKAGE.rglob("*.py"))
NAMES = [str(path.relative_to(PACKAGE)) for path in MODULES]
HEAVY = ("numpy", "scipy", "networkx", "geopandas", "folium", "osmium", "osmnx", "shapely", "rich")


def imports(source, package):
    """Return the absolute names of all modules that a source imports, wherever it does so."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, *([node.module] if node.module else [])])
            # "from . import cases" imports a module too; a name that is none does no harm here.
            found |= {module, *(f"{module}.{alias.name}" for alias in node.names)}
    return found


def room(module):
    """Return the part of the package a dotted name belongs to, None outside of it."""
    parts = module.split(".")
    if parts[0] != "platoon_osm" or len(parts) < 2:
        return None
    return parts[1] if parts[1] in ORDER else None


def forbidden(source, own, package):
    seen = {room(module) for module in imports(source, package)} - {None, own}
    return {other for other in seen if ORDER.index(other) > ORDER.index(own)}


@pytest.mark.parametrize("path", MODULES, ids=NAMES)
def test_imports_run_one_way(path):
    relative = path.relative_to(PACKAGE)
    own = relative.parts[0].removesuffix(".py")
    if own in {"__init__", "_version"}:
        return  # the front door names everything, and loads it when first used
    package = ["platoon_osm", *relative.parts[:-1]]
    if own not in ORDER:
        # Folders of data, such as scenarios/, may be importable but import nothing of ours.
        assert not {m for m in imports(path.read_text(), package) if m.startswith("platoon_osm")}
        return
    assert forbidden(path.read_text(), own, package) == set()


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("from ..planning.cases import CASES", {"planning"}),
        ("if TYPE_CHECKING:\n    from ..report.page import write_html", {"report"}),
        ("def f():\n    import platoon_osm.cli", {"cli"}),
        ("from .. import costs", {"costs"}),
        ("from platoon_osm.sources import osm", {"sources"}),
        ("from ..errors import NetworkError\nfrom .texts import TextTable\nimport numpy", set()),
    ],
)
def test_the_check_sees_wrong_imports(source, expected):
    assert forbidden(source, "network", ["platoon_osm", "network"]) == expected


def test_no_room_for_odds_and_ends():
    for path in PACKAGE.rglob("*"):
        assert path.stem not in {"utils", "util", "helpers", "helper", "common", "misc"}, path


def test_importing_the_package_loads_nothing_heavy():
    code = f"import sys, platoon_osm; print([m for m in {HEAVY} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True,
        cwd=PACKAGE.parent, timeout=60,
    )  # fmt: skip
    assert done.stdout.strip() == "[]"


def test_help_loads_nothing_heavy():
    code = (
        "import sys; from platoon_osm.cli import main\n"
        "try: main(['--help'])\n"
        f"except SystemExit: print('loaded', [m for m in {HEAVY} if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True,
        cwd=PACKAGE.parent, timeout=60,
    )  # fmt: skip
    assert done.stdout.splitlines()[-1] == "loaded []"


def test_every_name_at_the_front_door_exists():
    import platoon_osm

    for name in platoon_osm.__all__:
        assert getattr(platoon_osm, name) is not None
    assert set(platoon_osm.__all__) == {*platoon_osm._WHERE, "__version__"}
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        platoon_osm.nonsense  # noqa: B018


def undocumented(source):
    """Return public functions, methods and classes without a docstring."""
    missing = []

    def visit(body, prefix):
        for node in body:
            is_class = isinstance(node, ast.ClassDef)
            if not is_class and not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                continue
            # A property's setter repeats its name and needs no text of its own.
            if node.name.startswith("_"):
                continue
            if ast.get_docstring(node) is None:
                missing.append(prefix + node.name)
            if is_class:
                visit(node.body, f"{prefix}{node.name}.")

    visit(ast.parse(source).body, "")
    return missing


@pytest.mark.parametrize("path", MODULES, ids=NAMES)
def test_everything_public_has_a_docstring(path):
    source = path.read_text()
    if path.name != "__init__.py" or source.strip():
        assert ast.get_docstring(ast.parse(source)) or path.name == "_version.py"
    # `_Parser.error` and its like belong to classes nobody else uses.
    assert undocumented(source) == []


def test_the_check_sees_missing_docstrings():
    source = "def a(): ...\nclass B:\n    '''b'''\n    def c(self): ...\ndef _d(): ...\n"
    assert undocumented(source) == ["a", "B.c"]
