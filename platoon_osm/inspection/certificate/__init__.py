"""What proves a fleet's plan, checked with whole numbers and nothing of what planned it.

docs/certificate.md says why the bound is one, and how to check it by hand.
"""
