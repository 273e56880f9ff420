"""The options of `platoon-osm study`; nothing heavy is loaded to show them."""

from __future__ import annotations

import argparse
from pathlib import Path

__all__ = ["DESCRIPTION", "EXAMPLES", "add_study_options"]

DESCRIPTION = """Repeat the paper's Monte Carlo and put every number it prints beside ours, under
each reading of what it leaves open. Writes four figures (PNG, SVG, CSV), results.parquet,
comparison.csv and report.html. A study that was interrupted goes on where it stopped."""

EXAMPLES = """examples:
  platoon-osm study --runs 100 --seed 0 -o out/study
  platoon-osm study --method dijkstra --diameter-km 1 --spawning points -o out/quick
  platoon-osm study --network italy-motorways --diameter-km 200 --min-route-km 400 -o out/italy
  platoon-osm study --network italy-motorways --flows IT/traffic.csv -o out/italy-flows
  platoon-osm study --network NL/graph.graphml --flows NL/traffic.csv --min-route-km 150 -o out/nl
"""


def add_study_options(parser: argparse.ArgumentParser) -> None:
    """Add all options to a parser."""
    parser.description, parser.epilog = DESCRIPTION, EXAMPLES
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    add = parser.add_argument
    add("-o", "--output", type=Path, default=Path("out/study"), help="folder (default out/study)")
    add("--runs", type=int, default=100, help="networks drawn for each reading (default 100)")
    add("--seed", type=int, default=0, help="of all draws (default 0)")
    add("--workers", type=int, help="processes (default: one for each core)")
    add("--method", default="dijkstra,astar", help="dijkstra, astar or both (default both)")
    add("--mixing", default="printed,gain", help="printed, gain or both (default both)")
    add("--case", default="C", help="A, B or C (default C)")
    add("--diameter-km", help="spawn circles (default 1,200,400,600; 200 on a real network)")
    add("--spawning", default="points,nodes", help="points, nodes or both (default both)")
    add("--vehicles", type=int, default=10, help="N_v, with the master (default 10)")
    add("--min-route-km", type=float, default=500.0, help="minimum route (default 500)")
    add("--grid", type=int, default=11, help="values of tau and of xi in 0 to 1 (default 11)")
    group = parser.add_argument_group("random networks (Table 1)")
    add = group.add_argument
    add("--nodes", type=int, default=100)
    add("--edges", type=int, default=500)
    add("--dropout", type=float, default=0.2)
    add("--area-km", type=float, default=1000.0, help="side of the square area (default 1000)")
    add("--pruning", default="shortest", help="shortest (default) or random")
    add("--directed", action="store_true", help="one-way edges")
    add("--connected", default="whole", help="whole (default) or part")
    add("--access-nodes", type=int, default=3, help="nodes a spawn point leads to (default 3)")
    add("--route-length", default="network", help="network (default) or straight")
    group = parser.add_argument_group("real networks")
    add = group.add_argument
    add("--network", help="a bundled map's name or a file; trips are drawn on it instead")
    add("--flows", type=Path, help="traffic.csv of truck volumes, with segments.csv beside it")
    add("--classes", default="motorway,motorway_link", help="highway values to load, with commas")
    add("--country", help="whose truck speed limit applies")
    add("--infer-links", action="store_true", help="add likely connectors the map lacks")
    parser.add_argument(
        "--table", type=Path,
        help="Markdown file in which to renew the table between <!-- study:begin --> and end",
    )  # fmt: skip
