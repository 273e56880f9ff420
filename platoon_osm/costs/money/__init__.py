"""Costs in money: prices with their sources, and what driving, waiting and delay cost by them."""
