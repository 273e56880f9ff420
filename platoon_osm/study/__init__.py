"""The paper's Monte Carlo, and its figures and numbers beside the printed ones."""
