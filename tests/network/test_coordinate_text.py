"""Coordinates as text: which texts are pairs, which are names, and which nobody can tell."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

import platoon_osm as po
from platoon_osm.errors import NetworkError
from platoon_osm.network.coordinate_text import coordinates_in

LON = st.floats(-180, 180).map(lambda x: round(x, 7))
LAT = st.floats(-90, 90).map(lambda x: round(x, 7))


@given(LON, LAT, st.sampled_from([", ", " , ", " ", "; ", ";", "\t", "  ", "\u00a0"]))
def test_pairs_with_points(lon, lat, between):
    text = f"{lon:.7f}{between}{lat:.7f}"
    for written in (text, f" {text} ", f"({text})", f"[{text}]", text.replace("-", "\u2212")):
        assert coordinates_in(written) == (lon, lat)


@given(LON, LAT, st.sampled_from(["; ", " ; ", " ", ";", ", ", "\t"]))
def test_pairs_with_decimal_commas(lon, lat, between):
    text = f"{lon:.7f}{between.replace('.', ',')}{lat:.7f}".replace(".", ",")
    assert coordinates_in(text) == (lon, lat)


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("10.22, 45.54", (10.22, 45.54)), ("10.22,45.54", (10.22, 45.54)), ("10, 45", (10, 45)),
        ("10,22 45,54", (10.22, 45.54)), ("+10.22 -45.54", (10.22, -45.54)), ("10. 45.", (10, 45)),
        ("200, 95", (200, 95)),
    ],
)  # fmt: skip
def test_some_pairs(text, pair):
    assert coordinates_in(text) == pair


@pytest.mark.parametrize(
    "text",
    [
        "", "Torino", "A 1 exit 4", "exit 12A", "I 5 exit 519B", "12", "10.22", "1.2.3, 4",
        "1, 2, 3",
        "10.22 45.54 7", "Route 66, 5", "10:22, 45", "5th Street, NW", "A1 N", "nan, nan", "1e3, 2",
        "Nord 2", "S 24", "2 Sud", "K\u00f6ln 3 West",
    ],
)  # fmt: skip
def test_names(text):
    assert coordinates_in(text) is None


@pytest.mark.parametrize("text", ["10,22", "-9,5", " 10,22 "])
def test_one_number_or_two(text):
    with pytest.raises(NetworkError, match="may be one number or two; write longitude"):
        coordinates_in(text)


@pytest.mark.parametrize(
    "text",
    [
        "45.54 N 10.22 E", "45.54N, 10.22E", "45.54\u00b0 N, 10.22\u00b0 E",
        "45\u00b032'N 10\u00b013'E", "45,54 N 10,22 O", "33.9 S 18.4 E",
    ],
)  # fmt: skip
def test_hemispheres(text):
    with pytest.raises(NetworkError, match="write longitude and latitude in degrees"):
        coordinates_in(text)


def read(text):
    """Return what a text is read as, and what is said of it."""
    try:
        return coordinates_in(text), ""
    except NetworkError as error:
        return None, str(error)


@given(st.text(max_size=60))
def test_any_text_is_a_pair_a_name_or_told(text):
    found, said = read(text)
    assert found is None or len(found) == 2
    assert "\n" not in said


def test_a_long_text_takes_no_time():
    for text in ("1", "1 ", "1,1", "1\u00b0", "1.1 N", "1 N ", "1.1, "):
        for count in (30, 60, 50_000):
            assert len(read(text * count)[1]) < 300


def test_a_place_in_python_may_be_such_a_text():
    net = po.load_network("italy-motorways")
    for role in ("origin", "destination", "any"):
        assert net.locate("9.03, 45.83", role) == net.locate((9.03, 45.83), role)
        assert net.locate("9,03; 45,83", role) == net.locate((9.03, 45.83), role)
    with pytest.raises(NetworkError, match="longitude comes first"):
        net.locate("45.83, 99.03")
    with pytest.raises(NetworkError, match="may be one number or two"):
        net.locate("9,03")
    weights = po.paper_weights(net)
    plans = [
        po.plan_joint(net, weights, [po.Trip("A", place, "Trieste")])
        for place in ("9.03 45.83", (9.03, 45.83))
    ]
    assert plans[0] == plans[1]
