"""What no plan of a fleet can undercut: trucks' cheapest schedules under shares of prices."""
