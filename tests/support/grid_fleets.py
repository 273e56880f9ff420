"""Fleets on square grids of roads: what they pay, and trips between random corners."""

from __future__ import annotations

from datetime import datetime, timedelta

import numpy as np

import platoon_osm as po

__all__ = ["DAY", "base", "trips_on_grid"]

DAY = datetime(2026, 3, 2, 6)


def base(net):
    """Metres alone; whoever follows pays nine tenths, and who leads all of it."""
    length = net.length_m
    return po.EdgeWeights(solo=length, platoon=0.9 * length, master=length, unit="m", params={})


def trips_on_grid(count, seed, flexibility_min, side, within_min):
    """Trips between two corners of a grid each, within some minutes of `DAY`."""
    rng = np.random.default_rng(seed)
    ends = [rng.choice(side * side, 2, replace=False).tolist() for _ in range(count)]
    return [
        po.Trip(
            f"T{k}", a, b, DAY + timedelta(minutes=int(rng.integers(0, within_min))),
            flexibility_min=flexibility_min,
        )
        for k, (a, b) in enumerate(ends)
    ]  # fmt: skip
