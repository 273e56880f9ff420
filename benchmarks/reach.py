"""How far inferred connectors should reach, on the California extract.

Run with `python -m benchmarks.reach`. For each reach: the share of carriageway-km that is strongly
connected, the connectors added, and two routes whose true length is known. It writes its table to
docs/performance.md.
"""

from __future__ import annotations

import sys

import numpy as np

from benchmarks.california import EXTRACT, SACRAMENTO, SAN_DIEGO
from benchmarks.sections import markdown_table, write_section

REACHES_M = (100.0, 150.0, 200.0, 300.0)
LOS_ANGELES, SAN_FRANCISCO = (-118.243, 34.052), (-122.41, 37.775)


def main() -> None:
    """Measure and write the section."""
    import platoon_osm as po
    from platoon_osm.network.preparing.inferred_links import infer_links

    if not EXTRACT.is_file():
        sys.exit(f"{EXTRACT.name}: not found in ../shared/data/osm; this table needs it")
    bare = po.load_network(EXTRACT, country="US-CA")
    rows = []
    for reach_m in REACHES_M:
        net = infer_links(bare, reach_m)
        lengths = []
        for start, end in ((SAN_DIEGO, SACRAMENTO), (LOS_ANGELES, SAN_FRANCISCO)):
            for origin, destination in ((start, end), (end, start)):
                starts = [node for node, _ in net.locate(origin, "origin").candidates]
                ends = [node for node, _ in net.locate(destination, "destination").candidates]
                lengths.append(np.min(po.many_to_many(net, net.length_m, starts, ends)) / 1000)
        rows.append([
            f"{reach_m:.0f} m", f"{net.connected_share():.0%}", f"{net.inferred.sum():,}",
            f"{lengths[0]:.0f} and {lengths[1]:.0f} km",
            f"{lengths[2]:.0f} and {lengths[3]:.0f} km",
        ])  # fmt: skip
    header = [
        "reach of inferred connectors", "strongly connected", "connectors",
        "San Diego - Sacramento and back (about 810)",
        "Los Angeles - San Francisco and back (about 615)",
    ]  # fmt: skip
    table = markdown_table(header, rows)
    print(table)
    write_section("reach", table)


if __name__ == "__main__":
    main()
