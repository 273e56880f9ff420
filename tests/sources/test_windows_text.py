"""Maps and plans that went through Windows: byte order marks, UTF-16, its line ends."""

import codecs
import json

import pytest
from osm_files import MOTORWAY, row, write
from small_osm import ROADS, as_overpass

import platoon_osm as po

ENCODINGS = ["utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"]


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_answers_of_overpass(tmp_path, encoding):
    text = json.dumps(as_overpass(), indent=1)
    (tmp_path / "plain.json").write_text(text)
    (tmp_path / "saved.json").write_bytes(text.replace("\n", "\r\n").encode(encoding))
    plain, saved = (po.load_network(tmp_path / f"{n}.json", ROADS) for n in ("plain", "saved"))
    assert saved.m == plain.m


def test_an_extract_with_a_mark_and_its_line_ends(tmp_path):
    file = write(tmp_path, row(4), {1: ([1, 2, 3, 4], MOTORWAY)})
    plain = po.load_network(file)
    file.write_bytes(codecs.BOM_UTF8 + file.read_bytes().replace(b"\n", b"\r\n"))
    assert po.load_network(file).m == plain.m


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_plans(tmp_path, encoding):
    net = po.load_network("italy-motorways")
    plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", "Torino", "Forl\u00ec")])
    plan.write_json(tmp_path / "plan.json")
    text = (tmp_path / "plan.json").read_text(encoding="utf-8")
    (tmp_path / "saved.json").write_bytes(text.replace("\n", "\r\n").encode(encoding))
    assert po.Plan.read_json(tmp_path / "saved.json") == plan
    (tmp_path / "saved.json").write_bytes(b"\xff\xfe\xff")
    with pytest.raises(po.ScenarioError, match="is no JSON file"):
        po.Plan.read_json(tmp_path / "saved.json")
