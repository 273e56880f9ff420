"""Countries by the borders that a map has, before the bundled outlines."""

import json

import pytest
from osm_files import write

from platoon_osm.sources.load import load_network
from platoon_osm.sources.osm.borders import code_of

# All of it lies in Italy by the outlines; the map has Austria's border at 11.15 E.
NODES = {
    1: (11.05, 45.0, {}), 2: (11.1, 45.0, {}), 3: (11.2, 45.0, {}), 4: (11.25, 45.0, {}),
    11: (11.15, 44.9, {}), 12: (11.3, 44.9, {}), 13: (11.3, 45.1, {}), 14: (11.15, 45.1, {}),
}  # fmt: skip
ROAD = {"highway": "motorway", "oneway": "yes"}
WAYS = {
    21: ([1, 2], ROAD), 22: ([2, 3], ROAD), 23: ([3, 4], ROAD),
    31: ([11, 12, 13], {"admin_level": "2"}), 32: ([11, 14, 13], {}),
}  # fmt: skip
AUSTRIA = {
    "type": "boundary", "boundary": "administrative", "admin_level": "2", "ISO3166-1": "AT",
}  # fmt: skip
WHOLE = (("way", 31, "outer"), ("way", 32, "outer"))


def countries(net):
    at = {float(net.lon[node]): node for node in range(net.n)}
    return {
        lon: net.texts[net.country[edge]]
        for lon, node in at.items()
        for edge in range(net.m)
        if net.tail[edge] == node
    }


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_a_border_on_the_map_tells_the_country(tmp_path, suffix):
    path = write(tmp_path, NODES, WAYS, suffix, relations={41: (WHOLE, AUSTRIA)})
    net = load_network(path)
    # A road is where it begins: the second one crosses the border.
    assert countries(net) == {11.05: "IT", 11.2: "AT"}
    assert (
        load_network(path, country="DE").texts[load_network(path, country="DE").country[0]] == "DE"
    )


def test_a_border_that_is_cut_open_leaves_it_to_the_outlines(tmp_path):
    path = write(tmp_path, NODES, WAYS, relations={41: (WHOLE[:1], AUSTRIA)})
    assert set(countries(load_network(path)).values()) == {"IT"}


def test_an_answer_of_overpass_has_borders_too(tmp_path):
    elements = [
        {"type": "node", "id": node, "lon": lon, "lat": lat}
        for node, (lon, lat, _) in NODES.items()
    ]
    elements += [
        {"type": "way", "id": way, "nodes": nodes, "tags": tags}
        for way, (nodes, tags) in WAYS.items()
    ]
    members = [{"type": kind, "ref": ref, "role": role} for kind, ref, role in WHOLE]
    elements.append({"type": "relation", "id": 41, "members": members, "tags": AUSTRIA})
    (tmp_path / "map.json").write_text(json.dumps({"elements": elements}))
    assert countries(load_network(tmp_path / "map.json")) == {11.05: "IT", 11.2: "AT"}


def test_a_hole_in_a_country_is_not_in_it(tmp_path):
    nodes = {
        **NODES, 15: (11.19, 44.99, {}), 16: (11.21, 44.99, {}), 17: (11.21, 45.01, {}),
        18: (11.19, 45.01, {}),
    }  # fmt: skip
    ways = {**WAYS, 33: ([15, 16, 17, 18, 15], {})}
    path = write(tmp_path, nodes, ways, relations={41: ((*WHOLE, ("way", 33, "inner")), AUSTRIA)})
    assert set(countries(load_network(path)).values()) == {"IT"}


@pytest.mark.parametrize(
    ("tags", "code"),
    [
        (AUSTRIA, "AT"),
        ({**AUSTRIA, "ISO3166-1": "aut", "ISO3166-1:alpha2": "at"}, "AT"),
        ({**AUSTRIA, "ISO3166-1": "AUT"}, ""),
        ({**AUSTRIA, "admin_level": "4", "ISO3166-2": "US-CA"}, "US-CA"),
        ({**AUSTRIA, "admin_level": "4", "ISO3166-2": "AT-7"}, ""),
        ({**AUSTRIA, "admin_level": "8"}, ""),
        ({**AUSTRIA, "boundary": "national_park"}, ""),
        ({**AUSTRIA, "type": "multipolygon"}, ""),
    ],
)
def test_codes_of_borders(tags, code):
    assert code_of(tags) == code


def test_a_country_does_not_hide_the_state_of_the_outlines(tmp_path):
    nodes = {
        1: (-120.0, 37.0, {}), 2: (-120.1, 37.0, {}),
        11: (-121.0, 36.0, {}), 12: (-119.0, 36.0, {}),
        13: (-119.0, 38.0, {}), 14: (-121.0, 38.0, {}),
    }  # fmt: skip
    ways = {21: ([1, 2], ROAD), 31: ([11, 12, 13, 14, 11], {})}
    own = {**AUSTRIA, "ISO3166-1": "US"}
    net = load_network(write(tmp_path, nodes, ways, relations={41: ((("way", 31, "outer"),), own)}))
    assert net.texts[net.country[0]] == "US-CA"
