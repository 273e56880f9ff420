"""Packages of somebody else, as an installer leaves them in a folder."""

from pathlib import Path


def install(folder, name, entry_points, **modules):
    """Put a package with its entry points, such as {"group": {"name": "value"}}, in a folder."""
    for module, text in modules.items():
        Path(folder, f"{module}.py").write_text(text, encoding="utf-8")
    info = Path(folder, f"{name}-1.0.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    lines = []
    for group, entries in entry_points.items():
        lines += [f"[{group}]", *(f"{key} = {value}" for key, value in entries.items())]
    (info / "entry_points.txt").write_text("\n".join(lines) + "\n")
