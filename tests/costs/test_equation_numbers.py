"""Equations are called by the numbers that they have in the paper's source."""

import re

import pytest
from places import SHARED

SOURCE = SHARED / "paper" / "joint-travel-route-optimization.tex"
MARKS = {
    2: "g'(v) = g(u)", 4: r"\mathcal{C}_{T}^{(I)} =", 5: r"\mathcal{C}_{T}^{(P)} =",
    6: "F_{t_{dm}}", 7: "F_{t_{da}}", 8: "F_{t_{dn}}", 9: "C^{(I)}_F = F",
    10: r"h(v) = \varphi", 11: r"\mathcal{C}^{(I)}_{\Gamma, O} =",
    12: r"\mathcal{C}^{(P)}_{\Gamma, O} =",
    13: r"\mathcal{C}_\Gamma = \sum_{(u,v) \in \Gamma^{(I)}}",
}  # fmt: skip
"""What is written in each equation that this project calls by its number."""


def numbered(source):
    """Return the numbered equations of a LaTeX source in order."""
    source = re.sub(r"(?s)\\begin\{comment\}.*?\\end\{comment\}", "", source)
    source = re.sub(r"(?m)(?<!\\)%.*$", "", source)
    found = []
    for kind, body in re.findall(r"(?s)\\begin\{(equation|align)\}(.*?)\\end\{\1\}", source):
        lines = body.split(r"\\") if kind == "align" else [body]
        waiting = ""
        for line in lines:
            waiting += line
            if r"\nonumber" not in line:
                found.append(waiting)
                waiting = ""
    return found


@pytest.mark.skipif(not SOURCE.is_file(), reason="the paper's source is not beside the repository")
def test_numbers_are_those_of_the_source():
    equations = numbered(SOURCE.read_text(encoding="utf-8"))
    assert len(equations) == max(MARKS)
    for number, mark in MARKS.items():
        assert mark in equations[number - 1], number
