"""One vehicle and its drivers on a given way: the law as searches over labels."""
