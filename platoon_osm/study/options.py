"""What may be chosen in a study, as a user types it; nothing heavy is loaded to show it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

__all__ = ["StudyOptions"]


@dataclass(frozen=True, slots=True)
class StudyOptions:
    """The options of `platoon-osm study`, with their defaults.

    Attributes
    ----------
    output : Path
        Folder to write into.
    runs : int
        Networks drawn for each reading of the paper, 1 or more.
    seed : int
        Of all draws, 0 or more.
    workers : int or None
        Processes; None is one for each core.
    method : str
        "dijkstra", "astar" and "astar-closed-once", with commas: A* as the paper prints it, which
        opens a node again once a cheaper way to it is found, and with each node explored once.
    mixing : str
        "printed", "gain" or both: readings of tau and xi in eq. 12.
    terms : str
        Which terms eq. 11 and 12 add up, with commas; figures show the first.
    case : str
        "A", "B" or "C".
    diameter_km : str or None
        Diameters of the spawn circles [km], with commas; None is 1, 200, 400 and 600 on random
        networks and 200 on a real one.
    spawning : str
        "points", "nodes" or both.
    vehicles : int
        N_v, with the master.
    min_route_km : float
        Length of the shortest route that is drawn [km].
    grid : int
        Values of tau and of xi in [0, 1], 1 or more.
    table : Path or None
        Markdown file in which the table between the marks is renewed.
    nodes, edges : int
        Of a random network.
    dropout : float
        Probability with which each edge left is dropped, [0, 1).
    area_km : float
        Side of the square in which nodes are drawn [km].
    pruning : {"shortest", "random"}
        Which edges of the complete graph are kept.
    directed : bool
        Whether edges are one-way.
    connected : {"whole", "part"}
        What must be connected: the whole network, or the part on which trips are drawn.
    access_nodes : int
        Nodes that a spawn point leads to.
    route_length : {"network", "straight"}
        What the minimum route is compared with: the shortest route, or the straight line.
    network : str or None
        A bundled map's name or a file on which trips are drawn instead.
    flows : Path or None
        traffic.csv of truck volumes, with segments.csv beside it.
    classes : str
        Values of `highway` to load, with commas.
    country : str or None
        Whose speed limit for trucks applies.
    infer_links : bool
        Whether likely connectors are added that the map lacks.
    """

    output: Path = Path("out/study")
    runs: int = 100
    seed: int = 0
    workers: int | None = None
    method: str = "dijkstra,astar,astar-closed-once"
    mixing: str = "printed,gain"
    terms: str = "distance+time+fuel,distance+time,distance+fuel,distance,time,fuel"
    case: str = "C"
    diameter_km: str | None = None
    spawning: str = "points,nodes"
    vehicles: int = 10
    min_route_km: float = 500.0
    grid: int = 11
    table: Path | None = None
    nodes: int = 100
    edges: int = 500
    dropout: float = 0.2
    area_km: float = 1000.0
    pruning: Literal["shortest", "random"] = "shortest"
    directed: bool = False
    connected: Literal["whole", "part"] = "whole"
    access_nodes: int = 3
    route_length: Literal["network", "straight"] = "network"
    network: str | None = None
    flows: Path | None = None
    classes: str = "motorway,motorway_link"
    country: str | None = None
    infer_links: bool = False
