"""The law of driving times: what it forbids, and nothing else."""
