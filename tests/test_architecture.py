"""The walls of the house: who may import whom, and what an import may cost."""

import ast
import functools
import subprocess
import sys
from graphlib import CycleError, TopologicalSorter

import pytest
from places import ROOT

from platoon_osm.cli.verbs import VERBS

PACKAGE = ROOT / "platoon_osm"

WALLS = {
    "": (
        "errors", "kinds", "registry", "interrupts", "leftovers", "shown_text", "output_paths",
        "atomic_file", "csv_tables", "offers", "network", "vehicles", "sources", "search",
        "costs", "sharing", "chance", "driving", "plans", "planning", "fleets", "inspection",
        "report", "study", "cli",
    ),
    "network": ("towns", "preparing", "saved"),
    "sources": ("country", "speeds", "stops", "graphs", "osm", "overpass", "gis", "overture"),
    "search": ("hierarchy",),
    "search/hierarchy": ("runtime", "preparing", "sweeping", "fused"),
    "costs": ("tolls", "money"),
    "driving": ("bans",),
    "planning": ("timing", "company", "rotation", "legal", "scenario"),
    "planning/legal": ("driver", "platoon"),
    "fleets": ("bound", "plan", "trees", "dutch", "day", "law"),
    "inspection": ("certificate",),
    "report": (
        "language", "markup", "drawing", "ground", "document", "maps", "charts", "exports", "pages",
        "sheets",
    ),
    "cli": ("verbs",),
}  # fmt: skip
"""The order of the parts of each folder that has folders inside: each may import those to its left.

Files beside such folders stand in no list; that they make no circle is tested for all.
"""

MODULES = sorted(PACKAGE.rglob("*.py"))
NAMES = [str(path.relative_to(PACKAGE)) for path in MODULES]
HEAVY = (
    "numpy", "scipy", "networkx", "geopandas", "folium", "osmium", "osmnx", "shapely", "rich",
    "numba", "matplotlib", "pyarrow", "babel", "holidays", "opening_hours",
)  # fmt: skip
FRONT_DOOR = {"platoon_osm", "platoon_osm._version"}
"""The front door names everything and loads it when first used; the version is a number."""


def dotted(path):
    """Return the dotted name of a module of the package."""
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def package_of(path):
    """Return the package that a module's relative imports count from."""
    return dotted(path) if path.stem == "__init__" else dotted(path).rpartition(".")[0]


KNOWN = {dotted(path) for path in MODULES}


def imports(source, package):
    """Return the dotted names of our modules that a source imports, wherever it does so."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            parts = package.split(".")
            base = parts[: len(parts) - node.level + 1] if node.level else []
            module = ".".join([*base, *([node.module] if node.module else [])])
            names = {f"{module}.{alias.name}" for alias in node.names}
            # "from . import cases" imports a module; other names come from the module itself.
            found |= names & KNOWN or {module}
    return found & KNOWN - FRONT_DOOR


@functools.cache
def arrows():
    """Return for each module of the package those it imports."""
    return {
        dotted(path): imports(
            path.read_text(), package_of(path)
        ) - {dotted(path)}
        for path in MODULES
        if dotted(path) not in FRONT_DOOR
    }  # fmt: skip


def wrong(own, others):
    """Return which imports of a module break a wall."""
    broken = set()
    for folder, order in WALLS.items():
        inside = ("platoon_osm", *folder.split("/")) if folder else ("platoon_osm",)
        mine = part_of(own, inside)
        for other in others:
            theirs = part_of(other, inside)
            if mine in order and theirs in order and order.index(theirs) > order.index(mine):
                broken.add(other)
    return broken


def part_of(module, inside):
    parts = tuple(module.split("."))
    return parts[len(inside)] if parts[: len(inside)] == inside and len(parts) > len(inside) else ""


def circle(graph):
    """Return modules that import each other in a circle; nothing if none do."""
    try:
        tuple(TopologicalSorter(graph).static_order())
    except CycleError as error:
        return error.args[1]
    return []


@pytest.mark.parametrize("path", MODULES, ids=NAMES)
def test_imports_run_one_way(path):
    own = dotted(path)
    assert wrong(own, arrows().get(own, ())) == set()


AWAY_FROM_REPORT = ("planning", "study", "sources", "search")


def test_a_report_needs_plans_and_costs_alone():
    """What is told of a plan does not depend on how it was found, nor on where the map is from."""
    found = {
        (own, other)
        for own, others in arrows().items()
        if part_of(own, ("platoon_osm",)) == "report"
        for other in others
        if part_of(other, ("platoon_osm",)) in AWAY_FROM_REPORT
    }
    assert found == set()


def test_a_study_draws_its_own_figures_and_shares_only_the_language_of_the_report():
    found = {
        other
        for own, others in arrows().items()
        if part_of(own, ("platoon_osm",)) == "study"
        for other in others
        if part_of(other, ("platoon_osm",)) == "report"
    }
    assert found == {"platoon_osm.report.language.speech"}


def test_every_part_of_the_house_stands_in_its_order():
    for folder, order in WALLS.items():
        place = PACKAGE / folder
        parts = {item.name for item in place.iterdir() if (item / "__init__.py").is_file()}
        if not folder:
            parts |= {item.stem for item in place.glob("*.py")} - {"__init__", "_version"}
            # Folders of data may be importable but hold nothing of ours.
            parts -= {"scenarios"}
        assert parts <= set(order), folder
        with_folders = {
            str(item.parent.parent.relative_to(PACKAGE)) for item in place.glob("*/*/__init__.py")
        } - {"."}
        assert with_folders <= set(WALLS)


def test_nothing_is_imported_in_a_circle():
    assert circle(arrows()) == []


@pytest.mark.parametrize("folder", sorted(WALLS))
def test_files_and_folders_of_a_folder_make_no_circle(folder):
    inside = ("platoon_osm", *folder.split("/")) if folder else ("platoon_osm",)
    graph = {}
    for own, others in arrows().items():
        if mine := part_of(own, inside):
            there = {part_of(other, inside) for other in others} - {mine, ""}
            graph.setdefault(mine, set()).update(there)
    assert circle(graph) == []


@pytest.mark.parametrize(
    ("own", "source", "expected"),
    [
        ("network.locate", "from ..planning.cases import CASES", {"planning.cases"}),
        ("network.locate", "if TYPE_CHECKING:\n    from ..report.pages.page import write_html",
         {"report.pages.page"}),
        ("network.locate", "def f():\n    import platoon_osm.cli", {"cli"}),
        ("network.locate", "from .. import costs", {"costs"}),
        ("network.locate", "from platoon_osm.sources import osm", {"sources.osm"}),
        ("network.locate", "from ..errors import NetworkError\nimport numpy", set()),
        ("report.charts.charts", "from ..pages import panel", {"report.pages.panel"}),
        ("report.pages.panel", "from ..charts.charts import along_chart", set()),
        ("search.hierarchy.runtime.jit", "from ..sweeping.rows import sweep_rows",
         {"search.hierarchy.sweeping.rows"}),
    ],
)  # fmt: skip
def test_the_check_sees_wrong_imports(own, source, expected):
    own = f"platoon_osm.{own}"
    found = wrong(own, imports(source, own.rpartition(".")[0]))
    assert found == {f"platoon_osm.{name}" for name in expected}


def test_the_check_sees_circles():
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"a"}})
    assert not circle({"a": {"b", "c"}, "b": {"c"}, "c": set()})


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


@pytest.mark.parametrize("verb", ["", *VERBS])
def test_help_loads_nothing_heavy(verb):
    code = (
        "import sys; from platoon_osm.cli import main\n"
        f"status = main([*{verb.split()}, '--help'])\n"
        f"print('loaded', status, [m for m in {HEAVY} if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True,
        cwd=PACKAGE.parent, timeout=60,
    )  # fmt: skip
    assert done.stdout.splitlines()[-1] == "loaded 0 []"


def test_every_name_at_the_front_door_exists():
    import platoon_osm

    for name in platoon_osm.__all__:
        assert getattr(platoon_osm, name) is not None
    assert set(platoon_osm.__all__) == {*platoon_osm._WHERE, "__version__"}
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        platoon_osm.nonsense  # noqa: B018 (asking is the test)


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
