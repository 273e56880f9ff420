"""How options of loading are written: in Python, on the command line, and in a scenario.

A message does not know where it will be read, so the remedy it names is spelt for all three.
"""

__all__ = ["CLASSES", "COUNTRY", "INFER_LINKS"]

CLASSES = "classes=, --classes, or classes below [network]"
COUNTRY = "country=, --country, or country below [network]"
INFER_LINKS = "infer_links=True, --infer-links, or infer_links = true below [network]"
