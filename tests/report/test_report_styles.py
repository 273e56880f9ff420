"""Style sheets parse without error: browsers drop what they cannot read, and say nothing."""

import pytest
import tinycss2
from places import ROOT

ASSETS = ROOT / "platoon_osm" / "report" / "assets"


def errors(nodes):
    for node in nodes:
        if node.type == "error":
            yield f"line {node.source_line}: {node.message}"
        elif node.type in ("qualified-rule", "at-rule") and node.content is not None:
            yield from errors(
                tinycss2.parse_blocks_contents(
                    node.content, skip_comments=True, skip_whitespace=True
                )
            )


def parsed(text):
    return tinycss2.parse_stylesheet(text, skip_comments=True, skip_whitespace=True)


@pytest.mark.parametrize("name", sorted(path.name for path in ASSETS.glob("*.css")))
def test_style_sheets_parse(name):
    assert list(errors(parsed((ASSETS / name).read_text(encoding="utf-8")))) == []


def test_a_broken_style_sheet_would_be_seen():
    assert list(errors(parsed("p { color red; }")))
    assert list(errors(parsed("@media print { p { margin: 0 } } }")))
