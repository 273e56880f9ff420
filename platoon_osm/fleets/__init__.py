"""Whole fleets: who drives with whom among thousands, and how much more could be saved at most.

`instance` states the problem in whole numbers; `bound` holds what no plan can undercut, `plan` the
search for a good one, and `fleet` runs both and writes the plan.
"""
