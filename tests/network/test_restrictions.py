"""Restrictions as text: what comes back, and that equal ones are equal texts."""

from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.network.restrictions import decode, encode
from platoon_osm.network.texts import encode_texts

LAYER = st.dictionaries(st.text(min_size=1), st.text(), max_size=4)
WHOLE = st.characters(exclude_categories=["Cs"])


def test_a_text_reads_like_tags():
    layers = [{"maxheight": "3.8", "hgv": "destination"}, {"barrier": "gate"}]
    assert encode(layers) == "barrier=gate | hgv=destination maxheight=3.8"
    assert encode([{"hgv:conditional": "no @ (22:00-06:00)"}]) == (
        "hgv:conditional=no%20@%20(22:00-06:00)"
    )
    assert encode([]) == encode([{}]) == ""
    assert decode("") == ()


@given(st.lists(st.dictionaries(st.text(WHOLE), st.text(WHOLE), min_size=1)))
def test_layers_come_back_whatever_they_hold(layers):
    text = encode(layers)
    again = decode(text)
    assert {frozenset(layer.items()) for layer in again} == {
        frozenset(layer.items()) for layer in layers
    }
    assert encode(again) == text
    assert encode(reversed(layers)) == text


@given(st.lists(LAYER))
def test_half_characters_stop_nothing(layers):
    text = encode(layers)
    table, (codes,) = encode_texts([text])
    assert table[int(codes[0])] == text
