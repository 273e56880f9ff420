"""Who leads when: the lead of each company handed on at junctions, so that each leads its share."""
