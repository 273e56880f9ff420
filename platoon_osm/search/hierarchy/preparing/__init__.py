"""What depends on the network alone: its order, arcs and triangles, and where they are stored."""
