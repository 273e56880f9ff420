"""The colours of all drawings made here; style sheets and scripts repeat those they share.

A test holds the two together.
"""

from __future__ import annotations

__all__ = [
    "CASING",
    "CROWD",
    "FLOWS",
    "FRAME",
    "GAIN",
    "INK",
    "LATE",
    "LOSS",
    "MUTED",
    "NETWORK",
    "PAPER",
    "PLATOON",
    "PLATOON_CASING",
    "REST",
    "TERMS",
    "TICK",
    "TRAFFIC",
    "VEHICLES",
]

INK = "#17202b"
MUTED = "#5a6675"
PAPER = "white"

CASING = "#fff"
"""Round lines, so that they stay apart where they cross."""

FRAME = "#c3cad3"
"""Of a box with a text."""

PLATOON = "#ffd54a"
PLATOON_CASING = "#8a6a00"

NETWORK = "#c5ccd5"
"""The background on paper, where it is thinner than on a screen."""

TICK = "#e8ecf0"
"""Lines of a scale behind a chart."""

LATE = "#a3260a"
LOSS = LATE
GAIN = "#0072b2"

CROWD = "#4d5560"
"""Stands for many vehicles at once."""

REST = CROWD
"""A night's rest in a diagram."""

FLOWS = ("#8fb8de", "#5b97cf", "#2f74b5", "#14528c", "#0a3157")
"""From few vehicles to many: one hue, so that it reads in grey too."""

TRAFFIC = FLOWS[1]
"""Ribbons of vehicles alone under the platoons of a crowd."""

# All keep 4.5:1 against white, so that a white letter reads on them and they read on paper;
# neighbours in the list differ for the three common kinds of colour blindness.
VEHICLES = (GAIN, "#c14900", "#007a5a", "#8f3c97", "#7a5a00", "#b3124f", "#4152c4", CROWD)

TERMS = {
    "fuel": VEHICLES[0],
    "driver": MUTED,
    "toll": PLATOON,
    "co2": VEHICLES[2],
    "waiting": VEHICLES[1],
    "delay": VEHICLES[3],
}
"""What is paid for, in a figure of a bill."""
