"""The best plan of a whole fleet: built truck by truck, then mended where it pays most."""
