"""The verb that compiles the kernels ahead of the first plan."""

from graphs import planar

from platoon_osm.cli import main
from platoon_osm.network import engines
from platoon_osm.network.hierarchy.storage import hierarchy_path
from platoon_osm.network.store import save_network


def test_warmup_compiles_and_prepares(tmp_path, capsys):
    path = tmp_path / "roads.platoon"
    save_network(planar(100, 0)[0], path)
    assert main(["warmup", str(path)]) == 0
    assert "ready" in capsys.readouterr().out
    assert hierarchy_path(path).is_file()
    assert engines._loaded()
    assert engines._compiled()


def test_warmup_refuses_what_is_no_saved_network(tmp_path, capsys):
    assert main(["warmup", str(tmp_path / "nowhere.platoon")]) == 2
    assert "nowhere.platoon" in capsys.readouterr().err
