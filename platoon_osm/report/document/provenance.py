"""Where a plan comes from: network, parameters, method, proof, version, and who is to be named."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from ...kinds import is_number
from ...network.road_network import RoadNetwork
from ...plans.credits import credits_of
from ...plans.lateness import NOT_FEASIBLE
from ...plans.leading import leading_text
from ...plans.plan import Plan
from ...shown_text import fitted, shown
from ..language.plan_sentences import in_language
from ..language.speech import number, say
from ..markup.quantities import CostUnit, percent
from .model import LabelledText, Provenance
from .profiles import profile_rows
from .status import ways_out

__all__ = ["credits", "proof_text", "provenance"]

METHODS = {
    "dijkstra": "about.dijkstra",
    "astar": "about.astar",
    "astar-closed-once": "about.astar-once",
}

OBJECTIVES = {"member": "about.of-member", "system": "about.of-system"}

KINDS = {"bound": "proof.bound", "heuristic": "proof.heuristic"}

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
    nodes, edges = number(identity.nodes), number(identity.edges)
    rows = (
        (say("about.network"), say("about.size", name=identity.name, nodes=nodes, edges=edges)),
        (say("about.data-of"), _day(extracted)),
        ("sha256", identity.sha256),
        (say("about.graph"), identity.identity),
        (say("about.method"), _method(plan)),
        (say("about.costs"), ", ".join(_parameters(plan.params))),
        *((say("about.vehicles"), row) for row in profile_rows(plan)),
        (say("profile.closed"), ", ".join(plan.closed)),
        (say("about.made-by"), f"platoon_osm {plan.version}".strip()),
    )
    told = (fitted(in_language(leading_text(plan))), proof_text(plan.proof, unit))
    proof = " ".join(text for text in told if text)
    return Provenance(
        rows=tuple(LabelledText(label, fitted(text)) for label, text in rows if text),
        proof=fitted(proof),
        remarks=tuple(fitted(in_language(remark)) for remark in _other_remarks(plan)),
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
    kind, *conditions = (shown(in_language(str(text))) for text in raw)
    told = [(shown(key), _value(value)) for key, value in others.items()]
    bound, gap = _number(proof, "bound"), _number(proof, "gap")
    excess, optimum = _number(proof, "excess"), _number(proof, "optimum")
    solo_excess, any_plan = _number(proof, "solo_excess"), _number(proof, "any_plan")
    parts: list[str] = []
    if kind == "exact":
        parts.append(say("proof.optimal-for" if conditions else "proof.optimal"))
    elif kind in KINDS:
        parts.append(say(KINDS[kind]))
    elif kind:
        parts.append(kind[:1].upper() + kind[1:])
    if gap is not None:
        parts.append(say("proof.gap", share=percent(gap)))
    if bound is not None:
        parts.append(say("proof.bound-is", cost=unit.full(bound)))
    if excess is not None:
        # The planner's optimum is that of its own case: another way of counting may lie below it.
        side = "proof.above" if excess >= 0 else "proof.below"
        parts.append(say(side, share=percent(abs(excess))))
    if solo_excess is not None:
        parts.append(say("proof.solo-excess", share=percent(solo_excess)))
    if optimum is not None:
        parts.append(say("proof.optimum", cost=unit.full(optimum)))
    parts += conditions
    if any_plan is not None and kind == "exact":
        parts.append(say("proof.any-plan", cost=unit.full(any_plan)))
    parts += [f"{key.replace('_', ' ')}: {text}" for key, text in told]
    head, *rest = parts or [""]
    text = f"{head}: {'; '.join(rest)}" if rest else head
    return f"{text.rstrip('.')}." if text else ""


def _other_remarks(plan: Plan) -> list[str]:
    """Return the plan's remarks but those that head the page."""
    told = ways_out(plan.remarks)
    return [
        remark
        for remark in plan.remarks
        if not remark.startswith(NOT_FEASIBLE) and remark not in told
    ]


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
    if (fleet := plan.fleet) is not None:
        parts = [say("about.fleet"), say(f"plan.fleet-{fleet.routes}")]
        if fleet.max_platoon is not None:
            parts.append(say("plan.fleet-largest", count=str(fleet.max_platoon)))
        return "; ".join((*parts, say("about.seed", n=str(fleet.seed))))
    method = say(METHODS[plan.method]) if plan.method in METHODS else plan.method
    least = OBJECTIVES.get(plan.objective)
    objective = say(least) if least else plan.objective
    text = say("about.planned", case=plan.case, objective=objective, method=method)
    if plan.asked and plan.asked != plan.case:
        text += f" ({say('about.asked', case=plan.asked)})"
    return text


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
