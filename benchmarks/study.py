"""The paper's Monte Carlo, against a plain networkx loop over the same work.

Run with `python -m benchmarks.study`; it writes its table to docs/performance.md. The ratio is
the median over interleaved rounds in one run, on one network and the whole grid; the answers of
both are compared first.
"""

from __future__ import annotations

import itertools
import time
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import networkx
import numpy as np

from benchmarks.interleaved import compare
from benchmarks.sections import markdown_table, write_section
from platoon_osm.costs.paper import PaperCosts
from platoon_osm.study.monte_carlo import run_study
from platoon_osm.study.one_run import plan_draw
from platoon_osm.study.random_network import Draw
from platoon_osm.study.settings import Study

STUDY = Study(mixings=("printed",), points=())
"""100 networks, 10 vehicles, an 11 x 11 grid, Dijkstra."""
ROUNDS = 3


def networkx_loop(draw: Draw, graph: Any, repeat_searches: bool) -> np.ndarray:  # type: ignore[type-arg]  # numbers of one kind
    """Plan case C point by point and member by member, as one would write it down.

    Parameters
    ----------
    repeat_searches : search anew at each grid point, or once for all of them.

    Returns
    -------
    (V, T, X) joint costs; the master's is its cost alone.
    """
    kappa = PaperCosts().solo_factor()
    backward = graph.reverse(copy=False)
    origins, destinations = draw.origins.tolist(), draw.destinations.tolist()
    shape = (len(origins), *STUDY.grid_shape)
    costs = np.zeros(shape)
    search = networkx.single_source_dijkstra_path_length
    known: dict[tuple[int, bool], dict[int, float]] = {}

    def distances(node: int, forward: bool) -> dict[int, float]:
        if repeat_searches:
            return dict(search(graph if forward else backward, node, weight="solo"))
        if (node, forward) not in known:
            known[node, forward] = search(graph if forward else backward, node, weight="solo")
        return known[node, forward]

    for t, tau in enumerate(STUDY.tau):
        for x, xi in enumerate(STUDY.xi):
            factor = PaperCosts(tau=tau, xi=xi).platoon_factor()
            alone = [distances(o, True)[g] for o, g in zip(origins, destinations, strict=True)]
            master = int(np.argmax(np.round(np.array(alone) / kappa, 3)))
            route = networkx.dijkstra_path(
                graph, origins[master], destinations[master], weight="solo"
            )
            platoon = [0.0]
            for tail, head in itertools.pairwise(route):
                platoon.append(platoon[-1] + factor * graph[tail][head]["length"])
            for vehicle in range(len(origins)):
                best = alone[vehicle]
                if vehicle != master:
                    to_route = distances(origins[vehicle], True)
                    from_route = distances(destinations[vehicle], False)
                    for i, merge in enumerate(route):
                        for j in range(i + 1, len(route)):
                            cost = (
                                to_route.get(merge, np.inf) + platoon[j] - platoon[i]
                                + from_route.get(route[j], np.inf)
                            )  # fmt: skip
                            best = min(best, cost)
                costs[vehicle, t, x] = best
    return costs


def main() -> None:
    """Measure and write the section."""
    factors = STUDY.factors()
    draw = STUDY.network.draw(np.random.default_rng(7))
    net = draw.net
    graph = networkx.DiGraph()
    kappa = STUDY.costs.solo_factor()
    for edge in range(net.m):
        length = float(net.length_m[edge])
        graph.add_edge(int(net.tail[edge]), int(net.head[edge]), length=length, solo=kappa * length)

    def ours() -> Any:
        return plan_draw(STUDY, factors, draw)

    answer = ours()
    joint = answer["joint_cost"][0][:, factors.at[0]].reshape(-1, *STUDY.grid_shape)
    # The loop leaves out what the master saves in company.
    joint[int(answer["master"])] = answer["optimum"][int(answer["master"])]
    for repeat in (True, False):
        if not np.allclose(joint, networkx_loop(draw, graph, repeat), rtol=1e-9):
            raise AssertionError("networkx and platoon_osm disagree")
    result = compare(
        {
            "plain": lambda: networkx_loop(draw, graph, True),
            "searches once": lambda: networkx_loop(draw, graph, False),
            "ours": ours,
        },
        rounds=ROUNDS,
    )
    low, high = result.spread("plain", "ours")
    low_once, high_once = result.spread("searches once", "ours")
    whole = compare({"study": lambda: run_study(STUDY, seed=1)}, rounds=ROUNDS)
    with ProcessPoolExecutor(2) as pool:
        run_study(STUDY, seed=1, executor=pool)
        began = time.perf_counter()
        run_study(STUDY, seed=1, executor=pool)
        both = time.perf_counter() - began
    rows = [
        ["100 networks x 10 vehicles x 11 x 11 grid, Dijkstra, one process",
         f"{whole.median('study'):.2f} s", "under 2 s", f"draws included; {ROUNDS} rounds"],
        ["the same, two processes", f"{both:.2f} s", "under 2 s", "pool already started"],
        ["plain networkx loop, against ours", f"{result.ratio('plain', 'ours'):.0f}",
         "at least 200", f"{low:.0f} to {high:.0f} in {ROUNDS} rounds; one network, whole grid; "
         "costs agree to 1e-9"],
        ["networkx loop that keeps its searches over the grid, against ours",
         f"{result.ratio('searches once', 'ours'):.0f}", "", f"{low_once:.0f} to {high_once:.0f}"],
    ]  # fmt: skip
    table = markdown_table(["Monte Carlo of the paper", "measured", "wanted", "how"], rows)
    print(table)
    write_section("study", table)


if __name__ == "__main__":
    main()
