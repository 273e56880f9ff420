"""Towns of the world with their other names, for maps that hold nothing but roads."""
