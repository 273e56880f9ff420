"""How much of real maps is closed to which vehicle, and by which tags.

Run with `python -m benchmarks.access`; it reads ../shared/data/osm and writes its table to
docs/tags.md.
"""

from __future__ import annotations

from benchmarks.sections import ROOT, markdown_table, write_section

FOLDER = ROOT.parent / "shared" / "data" / "osm"
PAGE = ROOT / "docs" / "tags.md"
MAIN = ("motorway", "trunk", "primary", "secondary", "tertiary")
EVERY = [*MAIN, *(f"{kind}_link" for kind in MAIN)]
EXTRACTS = (
    ("california-motorway.osm.pbf", ["motorway", "motorway_link"], "eu-40t"),
    ("california-motorway.osm.pbf", ["motorway", "motorway_link"], "van-3.5t"),
    ("harrisburg.osm.pbf", EVERY, "us-80k-lb"),
    ("north-bayreuth.osm.gz", EVERY, "eu-40t"),
)
COUNTED = ("turn restrictions obeyed", "barriers obeyed")


def rows() -> list[list[str]]:
    """Return a row for each extract and vehicle."""
    from platoon_osm.sources.load import load_network
    from platoon_osm.vehicles.closures import Closures
    from platoon_osm.vehicles.profile import VEHICLES

    found = []
    for name, classes, vehicle in EXTRACTS:
        net = load_network(FOLDER / name, classes)
        by_reason = net.attached(Closures).km_by_reason(VEHICLES[vehicle])
        counts = net.report().counts
        dropped = sum(n for key, n in counts.items() if key.startswith("ways dropped: closed"))
        found.append(
            [
                name,
                vehicle,
                f"{net.length_m.sum() / 1000:,.0f}",
                "; ".join(f"{reason} {km:,.1f}" for reason, km in by_reason.items()) or "nothing",
                f"{dropped:,}",
                "; ".join(f"{counts[key]:,} {key}" for key in COUNTED if key in counts) or "none",
            ]
        )
    return found


def main() -> None:
    """Write the table."""
    header = ["extract", "vehicle", "km loaded", "not open, km", "ways nobody drives", "on nodes"]
    table = markdown_table(header, rows())
    print(table)
    write_section("access", table, PAGE)


if __name__ == "__main__":
    main()
