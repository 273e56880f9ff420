"""The fast engine: a customizable contraction hierarchy with batched sweeps.

What depends on the network alone (`order`, `symbolic`, `ranks`) is built once and stored beside it
(`storage`); what depends on a weight (`customization`) takes milliseconds; then `sweeps` answer for
one source, `batches` for many, `selection` for some targets and `members` for a platoon's route.
Which roads lead there `least_paths` says, from the costs alone, as it does for the reference.
Importing any of these loads numba; nothing here is imported before the engine is chosen.

References
----------
.. [1] Dibbelt, Strasser, Wagner, "Customizable contraction hierarchies", ACM Journal of
   Experimental Algorithmics 21 (2016).
.. [2] Delling, Goldberg, Nowatzyk, Werneck, "PHAST: hardware-accelerated shortest path trees",
   IPDPS 2011.
"""
