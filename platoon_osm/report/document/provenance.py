"""Where a plan comes from: network, parameters, method, proof, version, and who is to be named."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from ...kinds import is_number
from ...network.road_network import RoadNetwork
from ...plans.credits import credits_of
from ...plans.leading import leading_text
from ...plans.plan import Plan
from ...shown_text import fitted, shown
from ..markup.quantities import CostUnit, percent
from .model import LabelledText, Provenance

__all__ = ["credits", "proof_text", "provenance"]

METHODS = {"dijkstra": "Dijkstra", "astar": "A*", "astar-closed-once": "A*, each node once"}

PROOF_KEYS = frozenset(
    {"kind", "conditions", "bound", "gap", "excess", "solo_excess", "optimum", "any_plan"}
)


def provenance(plan: Plan, net: RoadNetwork, unit: CostUnit) -> Provenance:
    """Return where a plan comes from.

    Parameters
    ----------
    plan : Plan
        The plan.
    net : RoadNetwork
        The network it was made on.
    unit : CostUnit
        How its costs are printed.

    Returns
    -------
    Provenance
        Rows, proof, remarks and credits.
    """
    identity = plan.network
    extracted = identity.extracted or net.source.extracted
    network = f"{identity.name}, {identity.nodes:,} nodes, {identity.edges:,} edges"
    rows = (
        ("Network", network),
        ("Data of", _day(extracted)),
        ("sha256", identity.sha256),
        ("Graph", identity.identity),
        ("Method", _method(plan)),
        ("Costs", ", ".join(_parameters(plan.params))),
        ("Made by", f"platoon_osm {plan.version}".strip()),
    )
    told = (fitted(leading_text(plan)), proof_text(plan.proof, unit))
    proof = " ".join(text for text in told if text)
    return Provenance(
        rows=tuple(LabelledText(label, fitted(text)) for label, text in rows if text),
        proof=fitted(proof),
        remarks=tuple(fitted(remark) for remark in plan.remarks),
        credits=credits(plan, net),
    )


def credits(plan: Plan, net: RoadNetwork) -> tuple[str, ...]:
    """Return who is to be named with the map, on every page and in every file.

    Parameters
    ----------
    plan : Plan
        It names its network's source.
    net : RoadNetwork
        So does this.

    Returns
    -------
    tuple of str
        In the source's own words; OpenStreetMap where the map is from there, and only there.
    """
    return credits_of(plan, net.source)


def proof_text(proof: Mapping[str, object], unit: CostUnit) -> str:
    """Return in a sentence how good a plan is known to be.

    Parameters
    ----------
    proof : mapping of str to object
        As the plan holds it.
    unit : CostUnit
        How its costs are printed.

    Returns
    -------
    str
        The sentence; empty if nothing is known.
    """
    others = {
        key: value
        for key, value in proof.items()
        if key not in PROOF_KEYS and value not in (None, "", (), [])
    }
    raw = [proof.get("kind", ""), *_items(proof.get("conditions"))]
    # Every text of others is made fit here, before any of them is put into a sentence.
    kind, *conditions = (shown(text) for text in raw)
    told = [(shown(key), _value(value)) for key, value in others.items()]
    bound, gap = _number(proof, "bound"), _number(proof, "gap")
    excess, optimum = _number(proof, "excess"), _number(proof, "optimum")
    solo_excess, any_plan = _number(proof, "solo_excess"), _number(proof, "any_plan")
    parts: list[str] = []
    if kind == "exact":
        parts.append("Proved optimal for" if conditions else "Proved optimal for these trips")
    elif kind:
        parts.append(kind[:1].upper() + kind[1:])
    if gap is not None:
        parts.append(f"at most {percent(gap)} above the optimum")
    if bound is not None:
        parts.append(f"no plan can cost less than {unit.full(bound)}")
    if excess is not None:
        # The planner's optimum is that of its own case: another way of counting may lie below it.
        side = "above" if excess >= 0 else "below"
        parts.append(f"found by the paper's A*, {percent(abs(excess))} {side} the optimum")
    if solo_excess is not None:
        parts.append(f"its routes alone cost {percent(solo_excess)} above the least")
    if optimum is not None:
        parts.append(f"the optimum costs {unit.full(optimum)}")
    parts += conditions
    if any_plan is not None and kind == "exact":
        parts.append(f"no other routes and company cost less than {unit.full(any_plan)}")
    parts += [f"{key.replace('_', ' ')}: {text}" for key, text in told]
    head, *rest = parts or [""]
    text = f"{head}: {'; '.join(rest)}" if rest else head
    return f"{text.rstrip('.')}." if text else ""


def _day(moment: str) -> str:
    """Return the day of an ISO 8601 moment; any other text as it is."""
    day, t, _ = moment.partition("T")
    return day if t and len(day) == 10 else moment


def _items(value: object) -> list[object]:
    if not value:
        return []
    return list(value) if isinstance(value, list | tuple) else [value]


def _number(proof: Mapping[str, object], name: str) -> float | None:
    value = proof.get(name)
    if not is_number(value):
        return None
    return float(value) if math.isfinite(value) else None


def _method(plan: Plan) -> str:
    asked = f" (asked: {plan.asked})" if plan.asked and plan.asked != plan.case else ""
    method = METHODS.get(plan.method, plan.method)
    return f"case {plan.case}{asked}, least cost of the {plan.objective}, {method}"


def _parameters(params: Mapping[str, object]) -> Iterator[str]:
    for name, value in params.items():
        if value is not None:
            yield f"{name} = {_value(value)}"


def _value(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple):
        return ", ".join(_value(item) for item in value)
    return shown(value)
