"""Vehicles as roads see them: their size and mass, and what restrictions mean for them."""
