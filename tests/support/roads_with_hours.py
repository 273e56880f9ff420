"""Networks in a country, and with hours on some of their roads."""

import numpy as np

from platoon_osm.network.columns import columns_per
from platoon_osm.network.restrictions import encode
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.texts import TextTable


def in_country(net, country, hours=None):
    """Return a network whose edges lie in a country; `hours` gives edges tags."""
    texts = [*net.texts, country]
    own = {
        column.name: getattr(net, column.name)
        for column in columns_per("node", "edge", "offset", "shape point")
        if column.name != "first_out"
    }
    own["country"] = np.full(net.m, len(texts) - 1)
    restriction = net.restriction.copy()
    for edge, tags in (hours or {}).items():
        texts.append(encode([tags]))
        restriction[edge] = len(texts) - 1
    own["restriction"] = restriction
    return net.from_edges(
        **own, texts=TextTable.from_strings(texts), points=net.points, source=net.source,
        report=net.load_report,
    )  # fmt: skip


def row_with_turn_offs(country, hours, **names):
    """Return five junctions in a row, 60 km apart at 80 km/h, with turn-offs.

    The third road has hours; texts of edges and nodes are told by column.
    """
    count = 5
    lon = [0.75 * k for k in range(count)] + [0.75 * k for k in range(1, count - 1)]
    lat = [45.0] * count + [45.2] * (count - 2)
    tail = [*range(count - 1), *range(1, count - 1)]
    head = [*range(1, count), *range(count, 2 * count - 2)]
    net = RoadNetwork.from_edges(
        tail, head, lon=lon, lat=lat, length_m=[60_000.0] * (count - 1) + [1000.0] * (count - 2),
        speed_mps=80 / 3.6, **names,
    )  # fmt: skip
    edge = int(((net.tail == 2) & (net.head == 3)).argmax())
    return in_country(net, country, {edge: {"hgv:conditional": hours}})
