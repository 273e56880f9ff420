"""Charts as static SVG, and figures for papers."""
