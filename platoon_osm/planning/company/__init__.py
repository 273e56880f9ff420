"""Who drives with whom on given roads, also off the master's route, and how it is improved."""
