"""Loading and planning on the California extract, against OSMnx, pyosmium and networkx.

Run with `python -m benchmarks.california`; it reads ../shared/data/osm and writes its table to
docs/performance.md. Ratios are medians over interleaved rounds in one run.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.interleaved import compare
from benchmarks.sections import ROOT, markdown_table, write_section

EXTRACT = ROOT.parent / "shared" / "data" / "osm" / "california-motorway.osm.pbf"
MEMBERS = 100
SAN_DIEGO, SACRAMENTO = (-117.16, 32.715), (-121.494, 38.58)


def bare_pass() -> int:
    """Touch every object of the file once, as the plainest pyosmium program does."""
    import osmium

    return sum(1 for _ in osmium.FileProcessor(str(EXTRACT)))


def loading(folder: Path) -> list[list[str]]:
    """Ratios of loading to a contracted network."""
    import osmium
    import osmnx

    from platoon_osm.network.saved.store import open_network
    from platoon_osm.sources.osm.extract import read_osm

    # OSMnx reads XML only; the conversion is not counted.
    xml = folder / "california.osm"
    writer = osmium.SimpleWriter(str(xml))
    for item in osmium.FileProcessor(str(EXTRACT)):
        writer.add(item)
    writer.close()
    saved = folder / "california.platoon"
    read_osm(EXTRACT).save(saved)
    ours = compare({"ours": lambda: read_osm(EXTRACT), "bare": bare_pass}, rounds=9)
    low, high = ours.spread("ours", "bare")
    opened = compare({"open": lambda: open_network(saved)}, rounds=20)
    began = time.perf_counter()
    osmnx.graph_from_xml(xml, simplify=True, retain_all=True)
    osmnx_s = time.perf_counter() - began
    again = compare({"ours": lambda: read_osm(EXTRACT)}, rounds=3)
    return [
        ["OSMnx reads and simplifies, against ours", f"{osmnx_s / again.median('ours'):.0f}",
         "at least 10", "one OSMnx run, three of ours after it"],
        ["ours, against a bare pyosmium pass", f"{ours.ratio('ours', 'bare'):.2f}",
         "at most 2", f"{low:.2f} to {high:.2f} in 9 rounds"],
        ["reopening the saved form", f"{1000 * opened.median('open'):.1f} ms",
         "under 50 ms", "20 rounds; all arrays hashed"],
    ]  # fmt: skip


def networkx_case_c(
    graph: Any, backward: Any, net: Any, weights: Any, route: Any, trips: Any
) -> list[float]:
    """Plan members as a careful networkx user would: two searches each, then one pass."""
    import networkx

    nodes = net.path_nodes(route)
    platoon = np.concatenate([[0.0], np.cumsum(weights.platoon[route])]).tolist()
    costs = []
    for origin, destination in trips:
        to_route = networkx.single_source_dijkstra_path_length(graph, origin, weight="weight")
        from_route = networkx.single_source_dijkstra_path_length(
            backward, destination, weight="weight"
        )
        best = to_route.get(destination, float("inf"))
        lead = float("inf")
        for at, node in enumerate(nodes.tolist()):
            lead = min(lead, to_route.get(node, float("inf")) - platoon[at])
            best = min(best, lead + platoon[at] + from_route.get(node, float("inf")))
        costs.append(best)
    return costs


def planning() -> list[list[str]]:
    """Ratio of planning case C for many members."""
    import networkx

    import platoon_osm as po
    from platoon_osm.search.dijkstra import ReferenceEngine
    from platoon_osm.search.engine import warm_up

    net = po.load_network(EXTRACT, country="US-CA", infer_links=True)
    weights = po.paper_weights(net)
    start = net.locate(SAN_DIEGO, "origin").node
    end = net.locate(SACRAMENTO, "destination").node
    route = ReferenceEngine(net, weights.solo).tree(start).path(end)
    draw = np.random.default_rng(0)
    main = np.flatnonzero(net.strong_component() == 0)
    origins, destinations = draw.choice(main, (2, MEMBERS))
    trips = list(zip(origins.tolist(), destinations.tolist(), strict=True))
    graph = networkx.DiGraph()
    for edge in np.argsort(-weights.solo, kind="stable").tolist():
        graph.add_edge(int(net.tail[edge]), int(net.head[edge]), weight=float(weights.solo[edge]))
    backward = graph.reverse(copy=True)

    warm_up()

    def ours(engine: Any = "auto") -> Any:
        return po.plan_members(net, weights, route, origins, destinations, "C", engine=engine).cost

    def theirs() -> list[float]:
        return networkx_case_c(graph, backward, net, weights, route, trips)

    if not np.allclose(ours(), theirs(), rtol=1e-9):
        raise AssertionError("networkx and platoon_osm disagree")
    fresh = iter(range(1, 1000))

    def customized() -> Any:
        # Other weights each time: the engine has to be customized again before it can answer.
        scale = 1 + next(fresh) * 1e-6
        changed = replace(weights, solo=weights.solo * scale)
        return po.plan_members(
            net, changed, route, origins, destinations, "C", engine="hierarchy"
        ).cost

    result = compare(
        {
            "networkx": theirs,
            "hierarchy": lambda: ours("hierarchy"),
            "new weights": customized,
            "reference": lambda: ours("reference"),
        },
        rounds=5,
    )
    rows = []
    for engine, how in (
        ("hierarchy", "compiled before; the network's order and its weights' hierarchy kept"),
        ("new weights", "hierarchy engine, compiled before, customized anew in every round"),
        ("reference", "scipy alone, as where nothing is compiled yet"),
    ):
        low, high = result.spread("networkx", engine)
        rows.append(
            [
                f"networkx plans case C for {MEMBERS} members, against ours ({engine})",
                f"{result.ratio('networkx', engine):.0f}",
                "" if engine == "reference" else "at least 100",
                f"{how}; {low:.0f} to {high:.0f} in 5 rounds; K = {len(route)} edges; costs agree "
                "to 1e-9",
            ]
        )
    return rows


def importing() -> list[list[str]]:
    """Seconds to import the package, beyond starting Python."""
    runs = {
        name: lambda code=code: subprocess.run([sys.executable, "-c", code], check=True)
        for name, code in (("bare", "pass"), ("import", "import platoon_osm"))
    }
    result = compare(runs, rounds=9)
    seconds = result.median("import") - result.median("bare")
    return [["import platoon_osm", f"{seconds:.3f} s", "under 0.3 s", "9 rounds"]]


def main() -> None:
    """Measure and write the section."""
    if not EXTRACT.is_file():
        sys.exit(f"{EXTRACT.name}: not found in ../shared/data/osm; this benchmark needs it")
    with tempfile.TemporaryDirectory() as folder:
        rows = loading(Path(folder))
    rows += planning() + importing()
    table = markdown_table(["California extract", "measured", "wanted", "how"], rows)
    print(table)
    write_section("california", table)


if __name__ == "__main__":
    main()
