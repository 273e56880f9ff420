"""The loops of the checker, compiled before anybody waits for them."""

from __future__ import annotations

from .belief import certified
from .told import told_of

__all__ = ["warm_up"]


def warm_up() -> None:
    """Compile what is not compiled yet, by checking the example of docs/certificate.md."""
    certified(told_of(EXAMPLE))


EXAMPLE = {
    "format": "platoon-osm fleet", "version": 1, "plan": {},
    "certificate": {
        "tick_s": 1.0, "grain": "1", "nodes": 3, "tail": [0, 1, 0], "head": [1, 2, 2],
        "drive": [2, 2, 5], "alone": [20, 20, 45], "member": [12, 12, 30], "extra": [5, 8, 15],
        "lane_kind": [0, 0, 0], "origin": [0, 0], "destination": [2, 2], "earliest": [0, 0],
        "latest_departure": [3, 3], "latest": [9, 9], "kind": [0, 0], "vehicles": ["A", "B"],
        "largest": 0, "given": False, "waiting": 0, "routes": [[0, 1], [0, 1]], "rounds": 1,
        "shares": {
            "lane_first": [0, 1, 2, 3], "starts": [0, 0, 0], "truck": [0, 1, 0, 1, 0, 1],
            "lane": [0, 0, 1, 1, 2, 2], "first_bucket": [0, 0, 1, 1, 2, 2],
            "first_share": [0, 1, 2, 3, 4, 5, 6], "share": [2, 3, 4, 4, 7, 8],
        },
        "schedules": {"first": [0, 2, 4], "lane": [0, 1, 0, 1], "depart": [0, 2, 0, 2]},
        "lane_edges": {"first": [0, 1, 2, 3], "edge": [0, 1, 2]},
        "claims": {"alone": 80, "cost": 61, "bound": 61},
    },
}  # fmt: skip
"""Two trucks that go from node 0 to node 2."""
