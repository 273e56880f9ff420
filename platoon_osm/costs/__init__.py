"""What an edge costs alone and in a platoon."""
