"""Plans with bills, shares and chances that are drawn, so that every sum is another."""

from __future__ import annotations

import random
from dataclasses import replace

from platoon_osm.costs.cost_figure import CostFigure
from platoon_osm.plans.bill import Bill, VehicleBill
from platoon_osm.plans.chances import Chances, MeetingChance
from platoon_osm.plans.gain import GainShare, GainSharing
from platoon_osm.plans.plan import Plan

TERMS = ("fuel", "driver", "toll", "co2", "waiting", "delay")


def in_money(
    plan: Plan, seed: int = 1, currency: str = "EUR", most_cents: int = 90_000, text: str = ""
) -> Plan:
    """The plan with amounts that are drawn; CO2 is free, and `text` ends every text."""
    draw = random.Random(seed)
    bills = []
    for _ in plan.trips:
        alone = [draw.randrange(most_cents // 2, most_cents) for _ in range(3)]
        fuel = alone[0] - draw.randrange(-50, most_cents // 20)
        waits = draw.randrange(0, 900)
        litres = draw.uniform(100.0, 300.0)
        fewer = litres * draw.uniform(0.9, 1.0)
        bills.append(
            VehicleBill(
                (*alone, 0, 0, 0), (fuel, *alone[1:], 0, waits, 0), litres, fewer,
                (litres * 2.571, litres * 3.197), (fewer * 2.571, fewer * 3.197),
            )
        )  # fmt: skip
    saved = [one.saved_cents for one in bills]
    moved = [draw.randrange(-400, 400) for _ in saved[1:]]
    payments = [-sum(moved), *moved]
    merges = [k for k, event in enumerate(plan.events) if event.kind == "merge"]
    return replace(
        plan,
        unit=currency,
        bill=Bill(
            currency,
            (*TERMS[:-1], TERMS[-1] + text),
            tuple(bills),
            (
                CostFigure("fuel_per_l" + text, 1.3, "EUR/l" + text, "Bulletin, 2023" + text),
                CostFigure("to_wheel_kg_per_l", 2.57082, "kg/l", "factors, 2025"),
            ),
        ),
        gain=GainSharing(
            "equal" + text, currency,
            tuple(GainShare(own, own + paid) for own, paid in zip(saved, payments, strict=True)),
            7, -1.5, "planned anew" + text, text,
        ),
        chances=Chances(
            "normal" + text, 7, 1000,
            tuple(
                MeetingChance(k, 0.784, 60.0, 300.0, 120.0, 1800.0, 720.0, 12.5, 9.0, 660.0)
                for k in merges
            ),
            sum(saved) / 100, sum(saved) / 150,
        ),
    )  # fmt: skip
