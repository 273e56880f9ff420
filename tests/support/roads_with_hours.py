"""Networks in a country, and with hours on some of their roads."""

import numpy as np

from platoon_osm.network.columns import columns_per
from platoon_osm.network.restrictions import encode
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
