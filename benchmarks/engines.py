"""The engines side by side: `python -m benchmarks.engines` writes docs/performance.md.

All alternatives of a task run in turns in one process, and all answers are compared. The tables
hold ratios, not times: how many times longer another engine takes.
"""

from __future__ import annotations

import argparse
import gc
import math
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import block_array, csr_array
from scipy.sparse.csgraph import dijkstra

from benchmarks.interleaved import Comparison, compare
from benchmarks.peers import RoutingKit, installed, one_to_all_peers
from benchmarks.road_like import road_like, shuffled
from benchmarks.sections import ROOT, write_section
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.search import engine as engines
from platoon_osm.search.dijkstra import ReferenceEngine, lightest_edges
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.hierarchy.preparing.storage import topology_of
from platoon_osm.search.hierarchy.preparing.symbolic import build_topology
from platoon_osm.search.hierarchy.runtime.threads import cores
from platoon_osm.search.joining import best_pairs, entry_exit_costs

MEMBERS = 1000
SAVING = 0.82
TURN_S = 0.02
"""A turn lasts at least so long: short calls are made many times."""
SHUFFLED = "scipy, nodes numbered at random"
TARGETS = {
    "one to all": (8, 8, 20), "64 sources": (28, 60, 120), "case C": (15, 300, 1500),
    "case C, routingkit-cch": (5, 10, 5), "case D": (6, 15, 25),
}  # fmt: skip
Floats = NDArray[np.float64]


@dataclass
class Report:
    """Rows of the tables, in the order in which they were measured."""

    ratios: list[tuple[str, str, str, float, float, float]] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)

    def add(
        self, network: str, task: str, against: str, result: Comparison, slow: str, fast: str,
        scale: float = 1.0,
    ) -> None:  # fmt: skip
        """Keep and print one cell of the table."""
        low, high = result.spread(slow, fast)
        ratio = scale * result.ratio(slow, fast)
        self.ratios.append((network, task, against, ratio, scale * low, scale * high))
        print(f"  {task:14} {against:28} {ratio:8.1f}  ({scale * low:.1f} to {scale * high:.1f})")


@dataclass
class Case:
    """One network with whole-number weights [ms], a long route and members to plan."""

    name: str
    net: RoadNetwork
    weight: Floats
    route: NDArray[np.int64]
    origins: NDArray[np.int64]
    destinations: NDArray[np.int64]

    @classmethod
    def of(cls, name: str, net: RoadNetwork) -> Case:
        """Choose a route and members in a network."""
        weight = np.rint(net.length_m / net.speed_mps * 1000) + 1.0
        rng = np.random.default_rng(0)
        nodes = np.flatnonzero(net.strong_component() == 0)
        tree = ReferenceEngine(net, weight).tree(int(nodes[0]))
        # Nine tenths of the way to the farthest: long, but not the network's oddest corner.
        far = nodes[np.argsort(tree.dist[nodes])[int(0.9 * len(nodes))]]
        origins, destinations = rng.choice(nodes, (2, MEMBERS))
        return cls(name, net, weight, tree.path(int(far)), origins, destinations)

    def along(self) -> tuple[NDArray[np.int64], Floats, Floats]:
        """Return the route's nodes, and platoon weight and metres up to each."""
        running = [
            np.concatenate([[0.0], np.cumsum(values[self.route])])
            for values in (self.weight * SAVING, self.net.length_m)
        ]
        return self.net.path_nodes(self.route), running[0], running[1]


def same(a: Any, b: Any) -> None:
    np.testing.assert_allclose(a, b, rtol=1e-12)


def search_tasks(case: Case, report: Report, rounds: int, scipy: str = "scipy") -> None:
    net, weight, source = case.net, case.weight, int(case.origins[0])
    slow, fast = ReferenceEngine(net, weight), HierarchyEngine(net, weight)
    lightest = lightest_edges(net, weight)
    alternatives: dict[str, Callable[[], Any]] = {
        "ours": lambda: fast.distances(source),
        "with customization": lambda: HierarchyEngine(net, weight).distances(source),
        "scipy": lambda: slow.distances(source),
    }
    expected = slow.distances(source)[0]
    same(fast.distances(source)[0], expected)
    peers = one_to_all_peers(net, weight, lightest) if scipy == "scipy" else {}
    for name, search in peers.items():
        same(search(source), expected)
        alternatives[name] = lambda search=search: search(source)
    result = compare(alternatives, rounds, TURN_S)
    report.add(case.name, "one to all", scipy, result, "scipy", "ours")
    report.add(case.name, "one to all", f"{scipy}, customization counted", result, "scipy",
               "with customization")  # fmt: skip
    for name in alternatives:
        if name not in ("ours", "with customization", "scipy"):
            report.add(case.name, "one to all", name, result, name, "ours")

    # scipy has no gain from many sources, so a few of the 64 stand for all.
    many, few = case.origins[:64], case.origins[: 64 if net.n < 20_000 else 4]
    same(fast.distances(many)[: len(few)], slow.distances(few))
    result = compare(
        {
            "ours": lambda: HierarchyEngine(net, weight).distances(many),
            "scipy": lambda: slow.distances(few),
        },
        rounds,
        TURN_S,
    )
    report.add(case.name, "64 sources", scipy, result, "scipy", "ours", 64 / len(few))
    if net.n >= 10_000 and scipy == "scipy":
        # Below, calling takes longer than reading.
        byte_ratio(case, fast, report, rounds)


def byte_ratio(case: Case, fast: HierarchyEngine, report: Report, rounds: int) -> None:
    """Compare sweeps with reading their bytes once at the measured copy bandwidth."""
    t, n = fast.metric.topology, case.net.n
    one = len(t.head) * (4 + 8) + n * (4 + 8)
    batch = one + 64 * 8 * n
    block = np.ones(max(one // 8, 1 << 22))
    target = np.empty_like(block)
    many = case.origins[:64]
    result = compare(
        {
            "copy": lambda: np.copyto(target, block),
            "one": lambda: fast.distances(case.origins[0]),
            "batch": lambda: fast.distances(many),
        },
        rounds,
        TURN_S,
    )
    bytes_per_s = 2 * block.nbytes / result.median("copy")
    report.lines.append(
        f"| {case.name} | {result.median('one') * bytes_per_s / one:.1f} "
        f"| {result.median('batch') * bytes_per_s / batch:.1f} |"
    )


def member_task(case: Case, report: Report, rounds: int) -> None:
    net, weight = case.net, case.weight
    nodes, platoon, length_m = case.along()
    slow = ReferenceEngine(net, weight)
    arguments = (nodes, case.origins, case.destinations, platoon, length_m)
    found = HierarchyEngine(net, weight).best_on_route(*arguments)
    # The best form of scipy: one search from each side that has fewer nodes, route or members.
    searches = 2 * min(len(np.unique(nodes)), MEMBERS)
    part = min(searches, 400 if net.n < 20_000 else 40 if net.n < 200_000 else 8)
    whole = part == searches

    def scipy() -> Any:
        if whole:
            entry, leave, solo = entry_exit_costs(slow, nodes, case.origins, case.destinations)
            return best_pairs(entry, leave, platoon, length_m, solo)
        for forward in (True, False):
            slow.distances(nodes[: part // 2], forward)
        return None

    alternatives: dict[str, Callable[[], Any]] = {
        "ours": lambda: HierarchyEngine(net, weight).best_on_route(*arguments),
        "scipy": scipy,
    }
    if whole:
        same(scipy()[2], found[2])
    else:
        some = slice(0, 6)
        entry, leave, solo = entry_exit_costs(
            slow, nodes, case.origins[some], case.destinations[some]
        )
        same(best_pairs(entry, leave, platoon, length_m, solo)[2], found[2][some])
    share = 1.0
    if installed("routingkit_cch"):
        peer = RoutingKit(net)
        whole_weights = weight.astype(int).tolist()
        count = MEMBERS if net.n < 200_000 else 100
        share = MEMBERS / count
        metric = peer.customized(whole_weights)
        ends = [item[:count].tolist() for item in (case.origins, case.destinations)]

        def routingkit() -> Any:
            return peer.members(metric, nodes.tolist(), *ends, platoon, length_m, found[3][:count])

        same(routingkit(), found[2][:count])
        alternatives["routingkit-cch"] = routingkit
        alternatives["routingkit-cch customization"] = lambda: peer.customized(whole_weights)
    result = compare(alternatives, rounds, TURN_S)
    report.add(case.name, "case C", "scipy", result, "scipy", "ours", searches / part)
    if installed("routingkit_cch"):
        total = Comparison(
            {
                "ours": result.seconds["ours"],
                "peer": tuple(
                    share * a + b
                    for a, b in zip(
                        result.seconds["routingkit-cch"],
                        result.seconds["routingkit-cch customization"],
                        strict=True,
                    )
                ),
            }
        )
        report.add(case.name, "case C", "routingkit-cch", total, "peer", "ours")


def pair_task(case: Case, report: Report, rounds: int, scipy: str = "scipy") -> None:
    net, weight = case.net, case.weight
    pair = weight * (1 + SAVING)
    o, d = case.origins[:2], case.destinations[:2]
    slow, slow_pair = ReferenceEngine(net, weight), ReferenceEngine(net, pair)

    def ours() -> float:
        alone = HierarchyEngine(net, weight)
        u, v = alone.distances(o), alone.distances(d, False)
        limit = u[0, d[0]] + u[1, d[1]]
        dist = alone.shared_stretch(pair, list(u), list(v), limit).dist
        near = np.flatnonzero(np.isfinite(dist))
        return float((dist[near] + v[0, near] + v[1, near]).min(initial=limit))

    def five() -> float:
        u, v = slow.distances(o), slow.distances(d, False)
        limit = u[0, d[0]] + u[1, d[1]]
        return float((slow_pair.seeded(u[0] + u[1]).dist + v[0] + v[1]).min(initial=limit))

    def pruned() -> float:
        """Restrict the fifth search as ours does: only nodes that a worthwhile plan can pass."""
        u, v = slow.distances(o), slow.distances(d, False)
        limit = u[0, d[0]] + u[1, d[1]]
        share = min(1.0, float((pair / weight).min()) / 2)
        near = np.flatnonzero(share * (u[0] + u[1] + v[0] + v[1]) <= limit)
        if not len(near):
            return float(limit)
        graph = slow_pair._forward[near][:, near]
        seeds = (u[0] + u[1])[near]
        start = csr_array(
            (seeds, (np.zeros(len(near), int), np.arange(len(near)))), shape=(1, len(near))
        )
        whole = block_array([[graph, csr_array((len(near), 1))], [start, None]], format="csr")
        dist = dijkstra(whole, indices=len(near))[:-1]
        return float((dist + v[0, near] + v[1, near]).min(initial=limit))

    same(ours(), five())
    same(ours(), pruned())
    result = compare({"ours": ours, "scipy": five, "pruned": pruned}, rounds, TURN_S)
    report.add(case.name, "case D", scipy, result, "scipy", "ours")
    report.add(case.name, "case D", f"{scipy}, fifth search restricted", result, "pruned", "ours")


def shuffled_tasks(case: Case, report: Report, rounds: int) -> None:
    """Repeat searches where nodes are numbered at random, which no engine likes."""
    other = Case.of(case.name, shuffled(case.net))
    for task in (search_tasks, pair_task):
        task(other, report, rounds, SHUFFLED)


def auto_task(case: Case, report: Report, rounds: int) -> None:
    """Check that auto is never slower than twice the better engine, kernels loaded."""
    net = case.net
    for count in (1, 8, 64) if net.n < 200_000 else (1, 8):
        sources = case.origins[:count]

        def ask(name: Any, sources: Any = sources) -> Any:
            net.attached(engines.Searches).forget()
            return engines.distances(net, case.weight, sources, engine=name)

        result = compare(
            {name: lambda name=name: ask(name) for name in ("auto", "reference", "hierarchy")},
            max(3, rounds // 2),
            TURN_S,
        )
        better = min(result.median("reference"), result.median("hierarchy"))
        report.lines.append(
            f"| {case.name}, {count} sources | {result.median('auto') / better:.2f} |"
        )


def profile(case: Case, rounds: int) -> str:
    """Return where the time of 64 sources and of case D goes, in percent."""
    net, weight, many = case.net, case.weight, case.origins[:64]
    engine = HierarchyEngine(net, weight)
    o, d = case.origins[:2], case.destinations[:2]
    u, v = list(engine.distances(o)), list(engine.distances(d, False))
    pair, limit = weight * (1 + SAVING), float(u[0][d[0]] + u[1][d[1]])
    result = compare(
        {
            "customize": lambda: HierarchyEngine(net, weight),
            "batch": lambda: engine.distances(many),
            "two": lambda: engine.distances(many[:2]),
            "fifth": lambda: engine.shared_stretch(pair, u, v, limit),
        },
        rounds,
        TURN_S,
    )
    part = {name: result.median(name) for name in result.seconds}
    all_64 = part["customize"] + part["batch"]
    all_d = part["customize"] + 2 * part["two"] + part["fifth"]
    shares = (
        part["customize"] / all_64, part["batch"] / all_64, part["customize"] / all_d,
        2 * part["two"] / all_d, part["fifth"] / all_d,
    )  # fmt: skip
    return f"| {case.name} | " + " | ".join(f"{share:.0%}" for share in shares) + " |"


def growth(case: Case, rounds: int) -> list[tuple[int, float, float]]:
    """Return for numbers of members the cost of case C over that of ten, ours and scipy's."""
    net, weight = case.net, case.weight
    nodes, platoon, length_m = case.along()
    rng = np.random.default_rng(1)
    pool = np.flatnonzero(net.strong_component() == 0)
    slow = ReferenceEngine(net, weight)
    rows = []
    for count in (10, 100, 1000, 10_000):
        o, d = rng.choice(pool, (2, count))
        searches = 2 * min(len(nodes), count)
        result = compare(
            {
                "ours": lambda o=o, d=d: HierarchyEngine(net, weight).best_on_route(
                    nodes, o, d, platoon, length_m
                ),
                "scipy": lambda: slow.distances(nodes[:5]),
            },
            rounds,
            TURN_S,
        )
        rows.append((count, result.median("ours"), result.median("scipy") * searches / 5))
    return [(count, ours / rows[0][1], other / rows[0][1]) for count, ours, other in rows]


def preparation(case: Case) -> float:
    """Return the least of some times [s] to order and contract a network."""
    net, times = case.net, []
    for _ in range(5 if net.n < 200_000 else 1):
        gc.collect()
        begin = time.perf_counter()
        build_topology(net.tail, net.head, net.lon, net.lat, cores())
        times.append(time.perf_counter() - begin)
    return min(times)


MEMORY = """
import sys
from pathlib import Path
import numpy as np
from platoon_osm.network.saved.store import open_network
from platoon_osm.search.hierarchy.engine import HierarchyEngine
net = open_network(sys.argv[1])
engine = HierarchyEngine(net, net.length_m)
tree = engine.tree(0)
route = tree.path(int(np.argmax(np.where(np.isfinite(tree.dist), tree.dist, -1))))
steps = np.arange(len(route) + 1.0)
some = np.random.default_rng(0).integers(0, net.n, 1000)
engine.best_on_route(net.path_nodes(route), some, some[::-1], steps, steps)
# Not getrusage: its peak is inherited from the process that started this one.
status = Path("/proc/self/status").read_text()
print(int(status.split("VmHWM:")[1].split()[0]) / 1024)
"""


def memory(case: Case) -> float:
    """Return the peak [MB] of a process that builds, customizes, sweeps and plans case C."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "roads.platoon"
        case.net.save(path)
        done = subprocess.run(
            [sys.executable, "-c", MEMORY, str(path)], check=True, capture_output=True, text=True
        )
    return float(done.stdout)


def networks(sizes: list[int], data: Path) -> list[Case]:
    cases = [Case.of(f"{size:,} nodes", road_like(size)) for size in sizes]
    for file in sorted((data / "osm").glob("*.osm.*")) if data.is_dir() else []:
        import platoon_osm as po

        country = "US-CA" if "california" in file.name else None
        classes = ("motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link",
                   "secondary", "tertiary")  # fmt: skip
        try:
            net = po.load_network(
                file, *([] if country else [classes]), country=country, infer_links=bool(country)
            )
        except po.PlatoonError as error:
            print(f"{file.name}: left out ({error})")
            continue
        cases.append(Case.of(file.name.split(".")[0], net))
    return cases


def table(report: Report, names: list[str]) -> list[str]:
    tasks = sorted({(task, against) for _, task, against, *_ in report.ratios},
                   key=lambda key: [k[1:3] for k in report.ratios].index(key))  # fmt: skip
    lines = [
        "| task | against | " + " | ".join(names) + " |",
        "|---" * (len(names) + 2) + "|",
    ]
    cells = {row[:3]: row[3:] for row in report.ratios}
    for task, against in tasks:
        key = f"{task}, {against}" if against == "routingkit-cch" else task
        goals = TARGETS.get(key) if against in ("scipy", "routingkit-cch") else None
        line = [task, against]
        for at, name in enumerate(names):
            if (name, task, against) not in cells:
                line.append("")
                continue
            ratio, low, high = cells[name, task, against]
            goal = f" of {goals[at]}" if goals and at < 3 and "nodes" in name else ""
            line.append(f"**{rounded(ratio)}**{goal} ({rounded(low)}–{rounded(high)})")
        lines.append("| " + " | ".join(line) + " |")
    return lines


def rounded(value: float) -> str:
    if value < 10:
        return f"{value:.1f}"
    digits = max(0, 1 - math.floor(math.log10(value)))
    return f"{round(value, digits) if value < 100 else round(value / 10) * 10:,.0f}"


def plot(report: Report, sizes: list[int], rows: list[tuple[int, float, float]]) -> None:
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "platoon_osm"
    from matplotlib import pyplot as plt

    cells = {row[:3]: row[3:] for row in report.ratios}
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    for task, mark in (("one to all", "o"), ("64 sources", "s"), ("case C", "^"), ("case D", "v")):
        got = [cells.get((f"{size:,} nodes", task, "scipy")) for size in sizes]
        known = [(size, *cell) for size, cell in zip(sizes, got, strict=True) if cell]
        x, y, low, high = np.array(known).T
        left.errorbar(x, y, [np.maximum(y - low, 0), np.maximum(high - y, 0)], marker=mark,
                      capsize=3, label=task)  # fmt: skip
    left.set(xscale="log", yscale="log", xlabel="nodes", ylabel="scipy's time over ours",
             title="Ratio to scipy's best form")  # fmt: skip
    left.legend()
    count, ours, scipy = np.array(rows).T
    right.plot(count, scipy, "o-", label="scipy, fewer of 2N and 2K searches")
    right.plot(count, ours, "^-", label="hierarchy, customization included")
    right.set(xscale="log", yscale="log", xlabel="members", title="Growth of case C",
              ylabel="cost over the hierarchy's for 10 members")  # fmt: skip
    right.legend()
    for axes in (left, right):
        axes.grid(alpha=0.3)
    path = ROOT / "docs" / "images" / "engines.svg"
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", default="2000,50000,1000000")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    parser.add_argument("--dry-run", action="store_true", help="print, but write nothing")
    options = parser.parse_args()
    sizes = [int(size) for size in options.sizes.split(",")]
    engines.warm_up()
    report, extra, grown = Report(), [], []
    names: list[str] = []
    bytes_lines: list[str] = []
    auto_lines: list[str] = []
    profiles: list[str] = []
    for case in networks(sizes, options.data):
        rounds = options.rounds if case.net.n < 200_000 else max(3, options.rounds // 2)
        print(f"{case.name}: {case.net}, route of {len(case.route)} edges")
        names.append(case.name)
        seconds = preparation(case)
        topology = topology_of(case.net)
        extra.append(
            f"| {case.name} | {case.net.n:,} | {case.net.m:,} | {len(topology.head):,} "
            f"| {len(topology.triangle):,} | {len(case.route):,} | {seconds:.3g} s |"
        )
        print(extra[-1])
        for task in (search_tasks, member_task, pair_task):
            task(case, report, rounds)
        if "nodes" in case.name and case.net.n >= 50_000:
            shuffled_tasks(case, report, rounds)
        bytes_lines += report.lines
        report.lines.clear()
        if case.net.n >= 2000:
            profiles.append(profile(case, rounds))
            print(profiles[-1])
        auto_task(case, report, rounds)
        auto_lines += report.lines
        report.lines.clear()
        if case.net.n == 50_000:
            grown = growth(case, rounds)
        if case.net.n >= 1_000_000:
            extra.append(f"| {case.name}, peak memory | | | | | | {memory(case):.0f} MB |")
            print(extra[-1])
    print("\n".join(bytes_lines + auto_lines))
    section = [
        "## Engines", "",
        "Times of another engine over ours (`python -m benchmarks.engines`; "
        f"{cores()} cores, medians and spread of rounds in which all run in turns; "
        "after \"of\" the target). "
        "Synthetic networks have as many roads a node as the DIMACS road graphs and are numbered "
        "along a space-filling curve, which suits scipy too (best form); where it says so, both "
        "run on the same networks with their nodes numbered at random. Order building is left out; "
        "customization is counted in 64 sources, case C and case D. Scipy runs in its best "
        "form: 2K searches from the route where it has fewer nodes K than there are members "
        f"({MEMBERS}); of long runs of equal searches a part is timed. "
        "Weights are whole milliseconds, so that routingkit-cch, which knows only 32-bit "
        "integers, gives the same answers; all answers were compared.", "",
        *table(report, names), "",
        "![Ratio to scipy, and growth with members](images/engines.svg)", "",
        "| network | nodes | edges | arcs | triangles | route | order and contraction |",
        "|---|---|---|---|---|---|---|", *extra, "",
        "A sweep over the time to read its bytes once at the measured copy bandwidth of one core:",
        "", "| network | one source | 64 sources |", "|---|---|---|", *bytes_lines, "",
        "Where the time goes:", "",
        "| network | 64 sources: customization | sweep "
        "| case D: customization | four searches | the fifth |",
        "|---|---|---|---|---|---|", *profiles, "",
        '`engine="auto"` over the better engine, kernels loaded and order kept:', "",
        "| search | ratio |", "|---|---|", *auto_lines, "",
    ]  # fmt: skip
    if options.dry_run:
        return
    write_section("engines", "\n".join(section))
    if grown:
        plot(report, sizes, grown)


if __name__ == "__main__":
    main()
    sys.stderr.write(f"peak {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024} MB\n")
