"""Who gets the gain of driving together: games, shares that are fair by a stated rule, and proofs.

Mathematics alone: a coalition is a set of players, and its value what its members save without the
others. Nothing here knows of roads or plans.
"""
