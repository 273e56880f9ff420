"""Platoons of a few trucks that form from several places, exactly."""
