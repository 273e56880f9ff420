"""Downloads from a server on this machine that answers like Overpass and Nominatim."""

import contextlib
import copy
import json
import socket
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

import osmnx
import pytest
import requests
from small_osm import ROADS, as_overpass

from platoon_osm.cli import main
from platoon_osm.errors import MapDataError, ScenarioError
from platoon_osm.network.saved.store import open_network
from platoon_osm.sources.graphs.osmnx_graph import read_graphml
from platoon_osm.sources.overpass.answers import read_overpass_cache
from platoon_osm.sources.overpass.download import download, osmnx_settings, read_bounds
from platoon_osm.sources.truck import TruckRules

BOX = "10.9,44.9,11.2,45.1"
MOTORWAYS = ("motorway", "motorway_link")
VERONA = {
    "place_id": 1, "osm_type": "relation", "osm_id": 2, "lat": "45.0", "lon": "11.0",
    "display_name": "Verona", "class": "boundary", "type": "administrative", "importance": 0.5,
    "name": "Verona", "addresstype": "city", "place_rank": 16,
    "boundingbox": ["44.9", "45.1", "10.9", "11.2"],
    "geojson": {
        "type": "Polygon",
        "coordinates": [[[10.9, 44.9], [11.2, 44.9], [11.2, 45.1], [10.9, 45.1], [10.9, 44.9]]],
    },
}  # fmt: skip


class MapServer:
    """Answers on a free port of the loopback until closed, and notes what it was asked."""

    def __init__(self):
        self.requests = []
        self.status = 200
        self.interpreter = json.dumps(as_overpass()).encode()
        self.search = json.dumps([VERONA]).encode()
        owner = self

        class Handler(BaseHTTPRequestHandler):
            timeout = 10

            def do_POST(self):
                size = int(self.headers["Content-Length"])
                query = parse_qs(self.rfile.read(size).decode())["data"][0]
                self.answer(owner.interpreter, query)

            def do_GET(self):
                url = urlsplit(self.path)
                asked = parse_qs(url.query).get("q", [""])[0]
                self.answer(owner.search if url.path.endswith("search") else b"", asked)

            def answer(self, content, asked):
                owner.requests.append((urlsplit(self.path).path, asked))
                self.send_response(owner.status)
                self.send_header("Content-Length", str(len(content)))
                self.end_headers()
                self.wfile.write(content)

            def log_message(self, *args):
                pass

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.url = f"http://127.0.0.1:{self.server.server_address[1]}"
        self.thread = threading.Thread(target=self.server.serve_forever, args=(0.05,))
        self.thread.start()

    def close(self):
        self.server.shutdown()
        self.server.server_close()
        self.thread.join(10)


@pytest.fixture
def server(monkeypatch):
    for name in ("http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"):
        monkeypatch.delenv(name, raising=False)
    running = MapServer()
    yield running
    running.close()


def fetch(server, output, place=BOX, **options):
    return download(
        place,
        output,
        classes=options.pop("classes", MOTORWAYS),
        cache_dir=output.parent / "cache",
        overpass_url=f"{server.url}/api",
        nominatim_url=server.url,
        timeout_s=10,
        **options,
    )


def settings_now():
    names = osmnx.settings.__annotations__
    assert "overpass_url" in names
    return {name: copy.copy(getattr(osmnx.settings, name)) for name in names}


def test_graphml_of_a_box_and_the_cache(server, tmp_path):
    before, resolver = settings_now(), socket.getaddrinfo
    file = fetch(server, tmp_path / "verona.graphml")
    assert file == tmp_path / "verona.graphml"
    path, query = server.requests[0]
    assert path == "/api/interpreter"
    assert '["highway"~"^(motorway|motorway_link)$"]' in query
    net = read_graphml(file, MOTORWAYS, TruckRules("IT"))
    assert net.report()["edges dropped: closed to all by motor_vehicle"] == 2
    assert "Verona Est" in [net.junction_name(v) for v in range(net.n)]
    assert net.toll.any()

    fetch(server, tmp_path / "again.graphml")
    assert len(server.requests) == 1
    again = read_graphml(tmp_path / "again.graphml", MOTORWAYS, TruckRules("IT"))
    assert again.identity() == net.identity()
    assert settings_now() == before
    assert socket.getaddrinfo is resolver
    (cached,) = (tmp_path / "cache").iterdir()
    assert read_overpass_cache(cached, MOTORWAYS, TruckRules("IT")).m == net.m
    assert sorted(item.name for item in tmp_path.iterdir()) == [
        "again.graphml", "cache", "verona.graphml",
    ]  # fmt: skip


def test_own_form_of_a_place(server, tmp_path):
    file = fetch(
        server, tmp_path / "verona.platoon", "Verona, Italy", classes=ROADS, rules=TruckRules("IT")
    )
    net = open_network(file)
    assert [path for path, _ in server.requests] == ["/search", "/api/interpreter"]
    assert server.requests[0][1] == "Verona, Italy"
    assert net.source.name == "OpenStreetMap, Verona, Italy"
    assert net.source.licence == "ODbL 1.0"
    assert {"motorway", "primary"} <= set(to_classes(net))
    assert net.speed_mps.max() * 3.6 == pytest.approx(80)


def test_the_command_takes_the_truck_too(server, tmp_path, capsys):
    file = tmp_path / "verona.platoon"
    words = ["download", BOX, "-o", str(file), "--cache", str(tmp_path / "cache")]
    words += ["--overpass-url", f"{server.url}/api", "--classes", ",".join(ROADS)]
    assert main([*words, "--country", "IT", "--limiter", "85"]) == 0
    assert "OpenStreetMap contributors" in capsys.readouterr().out
    assert open_network(file).speed_mps.max() * 3.6 == pytest.approx(80)
    assert main([*words, "--country", "XX"]) == 2
    assert "country 'XX' has no truck limit here" in capsys.readouterr().err


def to_classes(net):
    return [data["highway"] for *_, data in net.to_networkx().edges(data=True)]


def assert_refused(server, tmp_path, said, place=BOX, **options):
    file = tmp_path / "verona.graphml"
    file.write_text("what was here before")
    before, resolver = settings_now(), socket.getaddrinfo
    with pytest.raises(MapDataError, match=said) as caught:
        fetch(server, file, place, **options)
    assert "\n" not in str(caught.value)
    assert file.read_text() == "what was here before"
    assert {item.name for item in tmp_path.iterdir()} <= {"verona.graphml", "cache"}
    assert settings_now() == before
    assert socket.getaddrinfo is resolver


@pytest.mark.parametrize("status", [400, 429, 500, 504])
def test_error_status(server, tmp_path, status):
    server.status = status
    assert_refused(server, tmp_path, f"the server answered {status}")
    assert len(server.requests) == 1


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"<html>busy</html>", "the answer holds no usable road"),
        (b"", "the answer holds no usable road"),
        (b"[]", "the answer holds no usable road"),
        (b'{"version": 0.6}', "the answer holds no usable road"),
        (b'{"elements": []}', "the answer holds no usable road"),
        (
            json.dumps(as_overpass() | {"remark": "runtime error:\n out of time"}).encode(),
            "Overpass gave up: runtime error: out of time; ask for a smaller area",
        ),
    ],
)
def test_garbage(server, tmp_path, content, said):
    server.interpreter = content
    assert_refused(server, tmp_path, said)


def test_a_remark_among_the_tags_is_no_remark(server, tmp_path):
    answer = as_overpass()
    answer["elements"][-1]["tags"] = {"remark": "nice view"}
    server.interpreter = json.dumps(answer).encode()
    assert fetch(server, tmp_path / "verona.graphml").exists()


def test_no_road_in_the_box(server, tmp_path):
    assert_refused(server, tmp_path, "the answer holds no usable road", "1,44.9,1.1,45.1")


def test_only_roads_closed_to_trucks(server, tmp_path):
    answer = as_overpass()
    for element in answer["elements"]:
        if element["type"] == "way":
            element["tags"]["motor_vehicle"] = "no"
    server.interpreter = json.dumps(answer).encode()
    with pytest.raises(MapDataError, match="closed to them"):
        fetch(server, tmp_path / "verona.platoon")
    assert [item.name for item in tmp_path.iterdir()] == ["cache"]


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ([], "the answer holds no usable road"),
        ([VERONA | {"geojson": {"type": "Point", "coordinates": [11.0, 45.0]}}], "no boundary"),
    ],
)
def test_unknown_place(server, tmp_path, found, said):
    server.search = json.dumps(found).encode()
    assert_refused(server, tmp_path, said, "Nowhere")


def test_nobody_answers(server, tmp_path):
    server.close()
    assert_refused(server, tmp_path, "no answer from the server")


def test_damaged_cache(server, tmp_path):
    fetch(server, tmp_path / "verona.graphml")
    (cached,) = (tmp_path / "cache").iterdir()
    cached.write_bytes(cached.read_bytes()[:100])
    assert_refused(server, tmp_path, "the cache is not damaged")


def test_bad_arguments_ask_nobody(server, tmp_path):
    with pytest.raises(ScenarioError, match=r"\.graphml or \.platoon"):
        fetch(server, tmp_path / "verona.shp")
    with pytest.raises(ScenarioError, match="highway tag"):
        fetch(server, tmp_path / "verona.graphml", classes=('motorway"];out;',))
    (tmp_path / "file").write_text("mine")
    with pytest.raises(MapDataError, match="file is no folder"):
        fetch(server, tmp_path / "file" / "verona.graphml")
    assert server.requests == []


def test_bounds():
    assert read_bounds("6.5, 36, 18.75,47.5") == (6.5, 36, 18.75, 47.5)
    assert read_bounds("Verona") is None
    assert read_bounds("Verona, Veneto, Italy, Europe") is None
    for text in ("1,2,3", "5,2,3,4", "1,4,3,2", "1,2,3,400", "nan,1,2,3", "12"):
        with pytest.raises(ScenarioError, match="bounding box"):
            read_bounds(text)


def test_busy_server_is_asked_again_but_not_for_hours(tmp_path):
    def answer(status, url="http://a/api/interpreter"):
        response = requests.Response()
        response.status_code, response.url, response._content = status, url, b"{}"
        response._content_consumed = True
        return response

    def mine(response, **_):
        seen.append(response.status_code)

    seen = []
    before = osmnx.settings.requests_kwargs
    osmnx.settings.requests_kwargs = {"hooks": {"response": mine}}
    try:
        with osmnx_settings(tmp_path, 2, {}):
            hooks = osmnx.settings.requests_kwargs["hooks"]["response"]
            for response in (answer(429), answer(504), answer(200)):
                for hook in hooks:
                    hook(response)
            hooks[0](answer(500, "http://a/api/status"))
            with pytest.raises(requests.HTTPError):
                hooks[0](answer(429))
    finally:
        osmnx.settings.requests_kwargs = before
    assert seen == [429, 504, 200]


def test_settings_come_back_after_any_error(tmp_path):
    before = settings_now()
    with contextlib.suppress(KeyboardInterrupt), osmnx_settings(tmp_path, 0, {"use_cache": False}):
        assert osmnx.settings.cache_folder == tmp_path
        raise KeyboardInterrupt
    assert settings_now() == before


def test_what_is_read_of_a_road_is_kept_of_an_answer():
    from platoon_osm.sources.overpass.download import NODE_TAGS, WAY_TAGS
    from platoon_osm.sources.slopes import INCLINE_TAGS
    from platoon_osm.sources.truck import is_driving_tag

    for key in ("maxheight", "maxweight:hgv", "hgv:forward", "access:conditional", "hazmat"):
        assert key in WAY_TAGS
    assert {"barrier", "access", "maxheight"} <= {*NODE_TAGS}
    assert "ele" in NODE_TAGS
    names = {"ref", "name", "destination", *INCLINE_TAGS}
    assert [key for key in WAY_TAGS if not (is_driving_tag(key) or key in names)] == []
    assert len(set(WAY_TAGS)) == len(WAY_TAGS)
