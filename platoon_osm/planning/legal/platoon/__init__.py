"""A platoon with one master under the law: searches over its stops and departures."""
