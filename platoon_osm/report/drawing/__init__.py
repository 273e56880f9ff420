"""Maps: lines, places, marks and texts, and how vehicles are told apart."""
