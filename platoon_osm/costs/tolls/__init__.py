"""Tolls for heavy vehicles by country: where they are due, and at which rate."""
