"""When everyone drives: pieces driven by one company, and their times."""
