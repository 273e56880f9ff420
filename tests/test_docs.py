"""What the documents say is there: files, links, commands, names; and their examples run."""

import ast
import os
import re
import subprocess
import sys
import tomllib

import pytest
import yaml
from numpydoc.docscrape import NumpyDocString
from places import ROOT

PACKAGE = ROOT / "platoon_osm"
DOCUMENTS = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), ROOT / "maps/README.md"])
NAMES = [str(path.relative_to(ROOT)) for path in DOCUMENTS]
MODULES = sorted(PACKAGE.rglob("*.py"))
BASES = (ROOT, PACKAGE, PACKAGE / "report")
"""What a path in a document may be counted from."""

SOURCE = ("py", "js", "css")
FOLDERS = {item.name for base in BASES for item in base.iterdir() if item.is_dir()}
TOPS = ("platoon_osm", "tests", "benchmarks", "maps", "docs", "examples")
QUOTED = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


def places(path):
    """Return where a path of our tree is; None if it is not one of ours.

    A path with a folder is ours if the folder is; a bare name if it is one of a source.
    """
    if not re.fullmatch(r"[\w./-]+", path):
        return None
    head, name = path.split("/")[0], path.split("/")[-1]
    if "/" in path:
        is_ours = head in FOLDERS and (not name or "." in name)
        return [base / path for base in BASES if (base / path).exists()] if is_ours else None
    if path.rpartition(".")[2] not in SOURCE or "." not in path:
        return None
    return [item for top in TOPS for item in (ROOT / top).rglob(path)]


def missing_paths(text):
    """Return paths of our tree, and names in them, that are quoted and not there."""
    missing = []
    for quoted in QUOTED.findall(text):
        path, _, name = quoted.partition("::")
        found = places(path)
        pattern = rf"(?m)^\s*(?:def |class )?{re.escape(name)}\b"
        is_there = found and (
            not name or any(re.search(pattern, item.read_text()) for item in found)
        )
        if found is not None and not is_there:
            missing.append(quoted)
    return missing


def missing_links(path):
    """Return relative links of a document that lead nowhere."""
    targets = LINK.findall(path.read_text())
    return [
        target
        for target in targets
        if not re.match(r"[a-z]+:", target) and not (path.parent / target).exists()
    ]


def missing_commands(text):
    """Return commands that nobody could run: modules, targets of make, verbs, scripts."""
    from platoon_osm.cli.verbs import VERBS

    targets = re.findall(r"(?m)^([a-z]+):", (ROOT / "Makefile").read_text())
    modules = re.findall(r"python -m (benchmarks[\w.]*|platoon_osm[\w.]*)", text)
    scripts = re.findall(r"\bpython ((?:[\w-]+/)+[\w-]+\.py)", text)
    return [
        *(f"python -m {module}" for module in modules if not runs(module)),
        *(f"python {script}" for script in scripts if not (ROOT / script).is_file()),
        *(f"make {name}" for name in typed("make", text) if name not in targets),
        *(f"platoon-osm {name}" for name in typed("platoon-osm", text) if name not in VERBS),
    ]


def runs(module):
    place = ROOT.joinpath(*module.split("."))
    return place.with_suffix(".py").is_file() or (place / "__main__.py").is_file()


def typed(command, text):
    """Return what follows a command where it begins a line or a quotation."""
    return re.findall(rf"(?m)(?:^ *|`){command} ([a-z]+(?:-[a-z]+)*)", text)


def missing_names(text):
    """Return names of the front door, said as `po.name`, that it does not have."""
    import platoon_osm

    return [name for name in re.findall(r"\bpo\.(\w+)", text) if not hasattr(platoon_osm, name)]


def python_blocks(path):
    """Return the Python examples of a document, each with the line where it begins."""
    text = path.read_text()
    return [
        (text[: block.start()].count("\n") + 2, block[1])
        for block in re.finditer(r"(?ms)^```python\n(.*?)^```$", text)
    ]


@pytest.mark.parametrize("path", DOCUMENTS, ids=NAMES)
def test_what_a_document_names_is_there(path):
    text = path.read_text()
    assert missing_paths(text) == []
    assert missing_links(path) == []
    assert missing_commands(text) == []
    assert missing_names(text) == []


def test_the_checks_see_what_is_missing():
    assert missing_paths("`network/search.py` `costs/fuel.py` `lost.py` `fuel.py`") == [
        "network/search.py",
        "lost.py",
    ]
    assert missing_paths("`costs/fuel.py::FUEL_SAVINGS` `costs/fuel.py::nothing`") == [
        "costs/fuel.py::nothing"
    ]
    # Files of the user's own are nobody's promise.
    assert missing_paths("`out/demo.html` `plan.gpkg` `IT/traffic.csv` `a / b`") == []
    commands = "    make tea\n    platoon-osm fly\n`python -m benchmarks.nothing`"
    assert missing_commands(commands) == [
        "python -m benchmarks.nothing",
        "make tea",
        "platoon-osm fly",
    ]
    assert missing_names("po.plan_joint(po.nothing)") == ["nothing"]


EXAMPLES = [path for path in DOCUMENTS if path.name in ("README.md", "CONTRIBUTING.md")]


@pytest.mark.parametrize("path", EXAMPLES, ids=[str(p.relative_to(ROOT)) for p in EXAMPLES])
def test_examples_run(path, tmp_path):
    """Examples that import what they need run, each by itself; the others are Python at least."""
    for line, block in python_blocks(path):
        compile(block, f"{path.name}, line {line}", "exec")
        if not re.search(r"(?m)^(import|from) ", block):
            continue
        # A process of its own: an example may add to the lists of this one.
        done = subprocess.run(
            [sys.executable, "-W", "error", "-c", block], cwd=tmp_path, capture_output=True,
            text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=120, check=False,
        )  # fmt: skip
        assert done.returncode == 0, f"{path.name}, line {line}: {done.stderr}"


def test_how_to_cite():
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert cited["cff-version"] == "1.2.0"
    for key in ("message", "title", "abstract", "authors", "license", "type", "version"):
        assert cited[key], key
    assert cited["title"] == project["name"]
    assert cited["version"] == project["version"]
    assert cited["license"] == project["license"]
    assert [author["name"] for author in cited["authors"]] == ["platoon_osm developers"]
    assert [(one["type"], one["year"]) for one in cited["references"]] == [
        ("conference-paper", 2025)
    ]
    for one in cited["references"]:
        assert one["title"]
        assert one["authors"]


def test_types_are_published():
    """Type checkers look into a package only if it says so; everything in the folder is packed."""
    marker = PACKAGE / "py.typed"
    assert marker.read_text() == ""
    built = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]
    assert built["targets"]["wheel"]["packages"] == ["platoon_osm"]
    assert "platoon_osm" in built["targets"]["sdist"]["include"]
    assert not {"exclude", "only-include"} & {*built, *built["targets"]["wheel"]}


def test_what_a_commit_checks_is_what_make_lint_checks():
    hooks = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text())["repos"]
    assert [repo["repo"] for repo in hooks] == ["local"]
    recipe = (ROOT / "Makefile").read_text().split("\nlint:")[1].split("\n\n")[0]
    commands = {line.strip().replace("$(BIN)", ".venv/bin") for line in recipe.splitlines()[1:]}
    entries = {hook["entry"] for hook in hooks[0]["hooks"]}
    assert {hook["language"] for hook in hooks[0]["hooks"]} == {"system"}
    for command in commands:
        assert any(command.startswith(entry) for entry in entries), command
    for entry in entries:
        assert any(command.startswith(entry) for command in commands), entry


def half_told(source):
    """Return attributes, parameters and results without a type or a description.

    numpydoc's validation looks at parameters only.
    """
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
            sections = NumpyDocString(ast.get_docstring(node) or "")
            found += [
                f"{node.name}: {item.name}"
                for kind in ("Attributes", "Parameters", "Returns", "Yields")
                for item in sections[kind]
                if not item.desc or not item.type
            ]
    return found


@pytest.mark.parametrize("path", MODULES, ids=[str(path.relative_to(PACKAGE)) for path in MODULES])
def test_all_that_a_docstring_lists_has_a_type_and_a_meaning(path):
    assert half_told(path.read_text()) == []


def test_the_check_sees_what_is_half_told():
    source = """class A:
        '''A.

        Attributes
        ----------
        b : int
        c
            Two.
        d : int
            Three.
        '''
    """
    assert half_told(source) == ["A: b", "A: c"]


def test_the_pages_that_pictures_are_taken_of_are_made(tmp_path):
    code = (
        "import sys, pathlib; sys.path.insert(0, 'docs'); import screenshots\n"
        "screenshots.write_pages(pathlib.Path(sys.argv[1]))"
    )
    subprocess.run([sys.executable, "-c", code, tmp_path], cwd=ROOT, check=True, timeout=120)
    flow = (tmp_path / "flow.html").read_text(encoding="utf-8")
    assert "60 trucks in Italy" in flow
    for name in ("compare", "legal", "legal-sheet"):
        assert (tmp_path / f"{name}.html").exists()
