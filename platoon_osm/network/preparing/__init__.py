"""From raw segments to a network: chains contracted, edges cut, likely connectors added."""
