"""The decisions: who drives where, merges with whom, and what it saves."""
