"""What pages show of a plan, made once."""
