"""The verb that compiles the kernels ahead of the first plan."""

import importlib

import numpy as np
from graphs import planar

from platoon_osm.cli import main
from platoon_osm.network.saved.store import save_network
from platoon_osm.search import engine as engines
from platoon_osm.search import price
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.hierarchy.preparing.storage import hierarchy_path


def test_warmup_compiles_and_prepares(tmp_path, capsys):
    path = tmp_path / "roads.platoon"
    save_network(planar(100, 0)[0], path)
    assert main(["warmup", str(path)]) == 0
    assert "ready" in capsys.readouterr().out
    assert hierarchy_path(path).is_file()
    assert price._loaded()
    assert price._compiled()


def test_nothing_is_left_to_compile(monkeypatch):
    engines.warm_up()
    parts = (
        "customization", "fused.members", "fused.selection", "fused.shared_stretch",
        "sweeping.batches", "sweeping.rows", "sweeping.sweeps", "sweeping.two_sweeps",
    )  # fmt: skip
    modules = [importlib.import_module(f"platoon_osm.search.hierarchy.{part}") for part in parts]
    for module in modules:
        monkeypatch.setattr(module, "WORTH_A_THREAD", 0, raising=False)

    kernels = [
        item for module in modules for item in vars(module).values() if hasattr(item, "stats")
    ]
    assert len(kernels) > 20

    def compilations():
        return {kernel.__name__: dict(kernel.stats.cache_misses) for kernel in kernels}

    before = compilations()
    net, weight = planar(3000, 1)
    engine = HierarchyEngine(net, weight, threads=2)
    some = np.arange(70)
    engine.distances(some)
    engine.distances(some[:3], forward=False)
    tree = engine.tree(0)
    path = tree.path(int(np.argmax(np.where(np.isfinite(tree.dist), tree.dist, -1))))
    engine.seeded(np.zeros(net.n)).path(5)
    engine.many_to_many(some, some)
    there, onward = engine.distances([0, 9]), engine.distances([7, 8], forward=False)
    limit = there[0, 7] + there[1, 8]
    for table in (np.asfortranarray, np.ascontiguousarray):
        engine.shared_stretch(weight * 1.9, list(table(there)), list(table(onward)), limit)
    steps = np.arange(len(path) + 1.0)
    engine.best_on_route(net.path_nodes(path), some, some[::-1], steps, steps)
    # What was compiled along with another kernel may still be loaded, which is quick.
    assert compilations() == before


def test_warmup_refuses_what_is_no_saved_network(tmp_path, capsys):
    assert main(["warmup", str(tmp_path / "nowhere.platoon")]) == 2
    assert "nowhere.platoon" in capsys.readouterr().err


def test_warmup_takes_maps_by_name_and_says_what_is_not_kept(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["warmup", "italy-motorways"]) == 0
    out = capsys.readouterr().out
    assert "platoon-osm prepare italy-motorways -o italy-motorways.platoon" in out
    assert list(tmp_path.iterdir()) == []
